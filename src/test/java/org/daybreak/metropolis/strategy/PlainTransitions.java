package org.daybreak.metropolis.strategy;

import java.util.ArrayList;
import java.util.List;
import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.material.BsdfSample;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;

/**
 * The strategies' densities T(x→y), and to which paths they apply, straight from the description of each (Veach 1997, §11.4) for {@link
 * PlainPath}s. Factors that both directions have in common are left out as the strategies say.
 *
 * @param whole probability of replacing all of the path
 * @param deleted p_d of pieces, halved from its last entry on
 * @param added p_a, alike
 * @param shortest smallest number of edges
 * @param longest largest number of edges
 * @param smallest r₁ in pixels, of film positions and angles
 * @param largest r₂ in pixels, alike
 * @param shortEdges edges shorter than this part of the way to the lens are moved like chains
 */
record PlainTransitions(
        double whole,
        double[] deleted,
        double[] added,
        int shortest,
        int longest,
        double smallest,
        double largest,
        double shortEdges) {
    // Which paths

    /** The first vertex from one towards the light that is no delta, 0 for the light. */
    private static int nextPlain(PlainPath x, int from) {
        int i = from - 1;
        while (i > 0 && x.isDelta(i)) {
            i--;
        }
        return i;
    }

    boolean applies(String strategy, PlainPath x) {
        int d = nextPlain(x, x.k);
        return switch (strategy) {
            case "bidirectional" -> true;
            case "lens", "lensSubpath" -> d == 0 ? !x.deltaLight : !x.isDelta(d - 1);
            case "caustic" ->
                x.k >= 2 && d == x.k - 1 && !x.camera.isParallel() && (nextPlain(x, d) > 0 || !x.infinite);
            case "multiChain" -> {
                if (d == 0 || !isMovedOn(x, d) || x.camera.isParallel()) {
                    yield false;
                }
                int last = lastOfChains(x);
                yield last > 0 || !(x.deltaLight || x.infinite);
            }
            case "manifold" -> {
                boolean any = false;
                for (int a = 0; a <= x.k; a++) {
                    any |= hasTriple(x, a, -1) || hasTriple(x, a, 1);
                }
                yield any;
            }
            default -> throw new IllegalArgumentException(strategy);
        };
    }

    /** The first vertex from one in a direction that is no delta: the light, the lens, or beyond if there is none. */
    private static int nextPlain(PlainPath x, int from, int step) {
        int i = from + step;
        while (i > 0 && i < x.k && x.isDelta(i)) {
            i += step;
        }
        return i;
    }

    /** Whether the manifold perturbation can begin at a vertex and has a chain of delta lobes to move. */
    private static boolean hasTriple(PlainPath x, int a, int step) {
        if (x.isDelta(a) || (a < x.k && x.camera.isParallel()) || (a == 0 && x.infinite)) {
            return false;
        }
        int b = nextPlain(x, a, step);
        return b > 0 && b < x.k && x.isDelta(b + step);
    }

    private boolean isMovedOn(PlainPath x, int plain) {
        return x.isDelta(plain - 1) || length(x, plain - 1, plain) < shortEdges * length(x, plain, x.k);
    }

    private int lastOfChains(PlainPath x) {
        int d = nextPlain(x, x.k);
        while (d > 0 && isMovedOn(x, d)) {
            d = nextPlain(x, d);
        }
        return d;
    }

    // T

    /** NaN if finite differences do not tell. */
    double transition(String strategy, boolean importance, PlainPath x, PlainPath y, Move move) {
        int kept = move.kept;
        int oldEnd = move.oldEnd;
        int newEnd = move.newEnd;
        return switch (strategy) {
            case "bidirectional" -> {
                List<Integer> before = joints(x);
                List<Integer> after = joints(y);
                int l = before.indexOf(kept);
                int m = before.indexOf(oldEnd);
                int newM = after.indexOf(newEnd);
                yield deletion(x, before, l, m, importance)
                        * addition(x, before, l, m, newM - l)
                        * construction(y, after, l, newM);
            }
            case "lensSubpath" -> lensSubpath(y, kept + 1);
            case "lens" -> lens(y, kept + 1);
            case "caustic" -> caustic(x, y);
            case "multiChain" -> multiChain(x, y);
            case "manifold" -> manifold(x, y, move.towardsLight, kept, newEnd);
            default -> throw new IllegalArgumentException(strategy);
        };
    }

    private static double entry(double[] table, int i) {
        return i < table.length ? table[i] : table[table.length - 1] * Math.pow(0.5, i - table.length + 1);
    }

    /**
     * The vertices at which pieces of a path may end: its ends and those whose material has other lobes than deltas. The first is −1, for
     * what lies before the light, so that the light is number 1; the last is k + 1, for what lies behind the lens.
     */
    private static List<Integer> joints(PlainPath x) {
        List<Integer> joints = new ArrayList<>(List.of(-1, 0));
        for (int i = 1; i < x.k; i++) {
            if (x.bsdf(i).connectable()) {
                joints.add(i);
            }
        }
        joints.add(x.k);
        joints.add(x.k + 1);
        return joints;
    }

    private static boolean hasDeltasOnly(PlainPath x, int shape) {
        return !x.scene.bsdf(shape).connectable() && x.scene.bsdf(shape).deltaLobes() > 0;
    }

    /**
     * In how many ways a piece of so many edges between joints can be built, whose joints from the light are 0, 1, …; 0 if it is not wanted.
     *
     * @param joints number of joints of the path that it is a piece of
     * @param l number of the last joint that stays on the side of the light; 0 if none does
     * @param m number of the first one that stays on the side of the lens; joints + 1 if none does
     */
    private int ways(PlainPath x, int joints, int l, int m, int edges) {
        int newJoints = joints - (m - l) + edges;
        boolean toLight = l == 0;
        boolean toLens = m == joints + 1;
        boolean deltas = false;
        for (int shape = 0; shape < x.scene.shapeCount(); shape++) {
            deltas |= hasDeltasOnly(x, shape);
        }
        if (newJoints < 2
                || newJoints > longest + 1
                || (!deltas && newJoints < shortest + 1)
                || edges < 1
                || Math.abs(edges - (m - l)) > 8) {
            return 0;
        }
        if (toLight && (m == 1 || edges == 1)) {
            // The light would stay, or the piece ends before it.
            return 0;
        }
        if (newJoints == 2) {
            return toLight ? 1 : 0;
        }
        int made = edges - 1;
        int mostFromLight = made - (toLens ? 1 : 0);
        if (mostFromLight < 0) {
            return 0;
        }
        return l == 1 ? 1 : mostFromLight + 1;
    }

    private double lengths(PlainPath x, int joints, int l, int m) {
        double sum = 0;
        for (int edges = 1; edges <= joints + 20; edges++) {
            if (ways(x, joints, l, m, edges) > 0) {
                sum += entry(added, Math.abs(edges - (m - l)));
            }
        }
        return sum;
    }

    private double addition(PlainPath x, List<Integer> joints, int l, int m, int edges) {
        int count = joints.size() - 2;
        return ways(x, count, l, m, edges) == 0 ? 0 : entry(added, Math.abs(edges - (m - l))) / lengths(x, count, l, m);
    }

    private double deletion(PlainPath x, List<Integer> joints, int chosenL, int chosenM, boolean importance) {
        int count = joints.size() - 2;
        double plainSum = 0;
        double importantSum = 0;
        double plain = 0;
        double important = 0;
        for (int l = 0; l < count; l++) {
            for (int m = l + 1; m <= count + 1; m++) {
                if ((l == 0 && m == count + 1) || lengths(x, count, l, m) == 0 || !couldBeMade(x, joints, l, m)) {
                    continue;
                }
                double p = entry(deleted, m - l - 1);
                double techniques = 0;
                for (int s = l; s < m && s < count; s++) {
                    techniques += way(x, joints, 0, count + 1, s);
                }
                plainSum += p;
                importantSum += p * techniques;
                if (l == chosenL && m == chosenM) {
                    plain = p;
                    important = p * techniques;
                }
            }
        }
        if (chosenL == 0 && chosenM == count + 1) {
            return plainSum == 0 ? 1 : whole;
        }
        return (1 - whole)
                * (importance && importantSum > 0
                        ? 0.5 * plain / plainSum + 0.5 * important / importantSum
                        : plain / plainSum);
    }

    /** Whether there is an edge in a piece at which walks could have been joined, or a light that one could have come to. */
    private boolean couldBeMade(PlainPath x, List<Integer> joints, int l, int m) {
        int ways = ways(x, joints.size() - 2, l, m, m - l);
        boolean any = l == 0 && !x.deltaLight;
        for (int way = l == 0 ? 1 : 0; way < ways; way++) {
            any |= isSeam(x, joints, l + way);
        }
        return any;
    }

    private static boolean isSeam(PlainPath x, List<Integer> joints, int joint) {
        int i = joints.get(joint);
        return joints.get(joint + 1) == i + 1 && !x.isDelta(i) && !x.isDelta(i + 1);
    }

    private double construction(PlainPath y, List<Integer> joints, int l, int m) {
        int ways = ways(y, joints.size() - 2, l, m, m - l);
        double sum = 0;
        for (int way = 0; way < ways; way++) {
            sum += way(y, joints, l, m, way);
        }
        return ways == 0 ? 0 : sum / ways;
    }

    /** Density of the vertices between two joints when so many joints come from the light's side and the others from the side of the lens. */
    private static double way(PlainPath y, List<Integer> joints, int l, int m, int fromLight) {
        int joint = l + fromLight;
        if (joint > 0 && !isSeam(y, joints, joint)) {
            return 0;
        }
        int kept = joints.get(l);
        int last = joints.get(joint);
        double density = 1;
        if (l == 0 && fromLight == 1) {
            density *= y.nextEvent;
        } else {
            for (int i = kept + 1; i <= last; i++) {
                density *= y.fromLight[i] * (i > 0 ? y.clear[i - 1] * y.opacity[i] : 1);
            }
        }
        for (int i = joints.get(m) - 1; i > last; i--) {
            density *= y.fromEye[i] * (i < y.k ? y.clear[i] * y.opacity[i] : 1);
        }
        return joint == 0 ? density * landing(y) * ending(y, joints.get(2)) : density;
    }

    /** With which probability a walk goes on at all surfaces that shine and reflect, and ends at the light of a path. */
    private static double ending(PlainPath y, int until) {
        double probability = 1;
        for (int i = 0; i < until; i++) {
            int shape = y.points[i].shape;
            if (shape >= 0 && !(i == 0 && y.infinite) && y.scene.lightOf(shape) >= 0 && hasDeltasOnly(y, shape)) {
                probability /= 2;
            }
        }
        return probability;
    }

    /** With which probability a walk that leaves the scene takes the environment of a path, if several lights are everywhere. */
    private static double landing(PlainPath y) {
        return y.infinite ? 1.0 / y.scene.environmentCount() : 1;
    }

    private static double lens(PlainPath y, int d) {
        double density = d == 0 ? landing(y) : 1;
        for (int i = y.k - 1; i >= d; i--) {
            density *= y.fromEyeByLobe[i] * y.clear[i] * y.opacity[i];
        }
        return density;
    }

    private static double lensSubpath(PlainPath y, int d) {
        double density = d == 0 ? landing(y) : 1;
        for (int i = y.k - 1; i >= d; i--) {
            density *= y.fromEye[i] * y.clear[i] * y.opacity[i];
        }
        if (d == 0 && y.infinite) {
            return density;
        }
        double goesOn = 0;
        BsdfSample lobe = new BsdfSample();
        for (int i = 0; i < y.bsdf(d).deltaLobes(); i++) {
            double[] e = y.edges[d];
            if (Scattering.deltaLobe(y.bsdf(d), y.points[d], e[0], e[1], e[2], i, TransportMode.RADIANCE, lobe)) {
                goesOn += lobe.density / y.opacity[d];
            }
        }
        return density * (1 - goesOn);
    }

    /** Pixels per radian at the lens, where the path leaves it. */
    private static double pixelsPerRadian(PlainPath x) {
        double[] d = x.towardsLens();
        CameraRay ray = new CameraRay();
        x.camera.rayDensity(x.points[x.k].x, x.points[x.k].y, x.points[x.k].z, -d[0], -d[1], -d[2], ray);
        return Math.sqrt(ray.densityDirection * x.camera.width() * x.camera.height());
    }

    /**
     * Density per solid angle of a tilt: the angle's logarithm is uniform between those of the bounds, and its azimuth is (Veach 1997,
     * eq. 11.9).
     */
    private double tilt(double[] from, double[] to, double radiansPerPixel) {
        double cosine = from[0] * to[0] + from[1] * to[1] + from[2] * to[2];
        double x = to[0] - from[0];
        double y = to[1] - from[1];
        double z = to[2] - from[2];
        double chord = Math.sqrt(x * x + y * y + z * z);
        double theta = cosine > 0 ? 2 * Math.asin(0.5 * chord) : Math.acos(cosine);
        double low = smallest * radiansPerPixel;
        double high = Math.min(0.5 * Math.PI, largest * radiansPerPixel);
        if (theta < low || theta > high) {
            return 0;
        }
        return 1 / (theta * (Math.log(high) - Math.log(low))) / (2 * Math.PI * Math.sin(theta));
    }

    private static double length(PlainPath x, int from, int to) {
        double sum = 0;
        for (int i = from; i < to; i++) {
            sum += Math.sqrt(x.squares[i]);
        }
        return sum;
    }

    private double caustic(PlainPath x, PlainPath y) {
        int start = nextPlain(x, x.k - 1);
        double scale = length(x, x.k - 1, x.k) / length(x, start, x.k - 1) / pixelsPerRadian(x);
        double density = tilt(x.edges[start], y.edges[start], scale) * y.perVertex(start + 1, start);
        density *= y.clear[start] * y.opacity[start + 1];
        for (int i = start + 2; i < y.k; i++) {
            density *= y.fromLightByLobe[i] * y.clear[i - 1] * y.opacity[i];
        }
        return density;
    }

    /**
     * Density of the manifold perturbation (Jakob and Marschner 2012), which tilts the direction at a, follows delta lobes to b and moves
     * the chain between b and c. NaN if finite differences do not tell, near folds and edges of triangles.
     *
     * @param kept the last vertex before the change
     * @param end the first one behind
     */
    private double manifold(PlainPath x, PlainPath y, boolean towardsLight, int kept, int end) {
        int step = towardsLight ? -1 : 1;
        int a = towardsLight ? end : kept;
        int b = nextPlain(y, a, step);
        int c = nextPlain(y, b, step);
        double density;
        if (a == y.k) {
            density = lens(y, b);
        } else {
            int edge = towardsLight ? a - 1 : a;
            double scale =
                    length(x, Math.max(a, b), x.k) / length(x, Math.min(a, b), Math.max(a, b)) / pixelsPerRadian(x);
            density = tilt(x.edges[edge], y.edges[edge], scale) * y.perVertex(a + step, edge);
            density *= y.clear[edge] * y.opacity[a + step];
            for (int i = a + 2 * step; i != b + step; i += step) {
                double[] given = towardsLight ? y.fromEyeByLobe : y.fromLightByLobe;
                density *= given[i] * y.clear[towardsLight ? i : i - 1] * y.opacity[i];
            }
        }
        if (Math.abs(c - b) == 1) {
            return density;
        }
        // Rays of c over the chain: the density of its vertices and b, over that of b alone.
        for (int i = c - 2 * step; i != b - step; i -= step) {
            density *= c > b ? y.fromEyeByLobe[i] : y.fromLightByLobe[i];
        }
        return density * y.endPerFirst(c, b);
    }

    /** Whether a move of the manifold perturbation moves a chain. */
    static boolean movesChain(PlainPath y, Move move) {
        int step = move.towardsLight ? -1 : 1;
        int b = nextPlain(y, move.towardsLight ? move.newEnd : move.kept, step);
        return Math.abs(nextPlain(y, b, step) - b) > 1;
    }

    /** The edge that a move of the manifold perturbation joins. */
    static int joined(PlainPath y, Move move) {
        return move.towardsLight ? nextPlain(y, move.newEnd, -1) - 1 : nextPlain(y, move.kept, 1);
    }

    private double multiChain(PlainPath x, PlainPath y) {
        int d = nextPlain(x, x.k);
        double density = lens(y, d);
        int last = lastOfChains(x);
        if (last != lastOfChains(y)) {
            return 0;
        }
        while (d > last) {
            int next = nextPlain(x, d);
            double ratio = next < d - 1 ? length(x, d, x.k) / length(x, next, d) : 1 / shortEdges;
            double scale = ratio / pixelsPerRadian(x);
            density *= tilt(x.edges[d - 1], y.edges[d - 1], scale) * y.perVertex(d - 1, d - 1);
            density *= y.clear[d - 1] * y.opacity[d - 1];
            for (int i = d - 2; i >= next; i--) {
                density *= y.fromEyeByLobe[i] * y.clear[i] * y.opacity[i];
            }
            d = next;
        }
        return density;
    }
}
