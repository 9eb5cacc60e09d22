package org.daybreak.metropolis.strategy;

import org.daybreak.core.math.Densities;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.metropolis.chains.Outcome;

/**
 * Changes a path between three vertices a, b, c that follow each other but for delta lobes between them (Jakob and Marschner 2012): tilts
 * the direction at a, or moves the image point if a is the lens; follows the delta lobes to b; and moves the chain of delta lobes between
 * b and c so that it joins the new b to c, by a walk on the manifold of such chains. So it explores what no other strategy can but by
 * luck: light that a lens throws on what is seen in a mirror.
 *
 * <p>All such triples that the path has are equally probable, those with a chain between b and c before the others, of which those that the
 * lens and caustic perturbations make are left out. They depend on where the path has delta lobes, which does not change. The
 * change runs towards the light or towards the lens; T is that of the way that was taken. Sizes of changes are as for the other
 * perturbations: evenly distributed on a logarithmic scale, between bounds given as distances on the film.
 *
 * <p>T: density of the vertices up to b given the film position or the direction at a, times that of the chain, {@link
 * ChainPieces#density}. Lights at infinity are no a. Chains that pass through alpha masks are not walked.
 */
public final class ManifoldPerturbationStrat extends MutationStrategy {
    /** Relative probability of triples without a chain between b and c. */
    private static final double PLAIN = 0.25;

    private final double smallest;
    private final double largest;
    private final double smallestTilt;
    private final double largestTilt;

    /**
     * Creates the strategy.
     *
     * @param weight relative probability of choosing it
     * @param smallest r₁, in pixels
     * @param largest r₂, in pixels
     * @param smallestTilt r₁ of tilted directions, in pixels that they correspond to
     * @param largestTilt r₂ of tilted directions, in pixels that they correspond to
     */
    public ManifoldPerturbationStrat(
            double weight, double smallest, double largest, double smallestTilt, double largestTilt) {
        super(weight);
        this.smallest = smallest;
        this.largest = largest;
        this.smallestTilt = smallestTilt;
        this.largestTilt = largestTilt;
    }

    @Override
    public String id() {
        return "manifold";
    }

    /** True if some triple has a chain between b and c. */
    @Override
    protected boolean applies(LightPath x) {
        for (int a = 0; a < x.length; a++) {
            if (probability(x, a, true) == 1 || probability(x, a, false) == 1) {
                return true;
            }
        }
        return false;
    }

    /** The next vertex on a side that is an end or scatters by no delta lobe; -1 or the number of vertices if there is none. */
    private static int next(LightPath x, int vertex, boolean towardsLight) {
        int step = towardsLight ? -1 : 1;
        int i = vertex + step;
        while (i > 0 && i < x.length - 1 && !x.joins(i)) {
            i += step;
        }
        return i;
    }

    /** Relative probability of a triple that begins at a vertex; 0 if there is none, 1 if it has a chain between b and c. */
    private static double probability(LightPath x, int a, boolean towardsLight) {
        int k = x.length - 1;
        if (!x.joins(a) || (a < k && x.filmPerSolidAngle == 0) || (a == 0 && x.infinite)) {
            return 0;
        }
        int b = next(x, a, towardsLight);
        if (b <= 0 || b >= k) {
            return 0;
        }
        int c = next(x, b, towardsLight);
        if (Math.abs(b - c) > 1) {
            return 1;
        }
        return a == k || c == k ? 0 : PLAIN;
    }

    /** Chooses a triple: twice the vertex a, and one more if it is changed towards the light. */
    private static int choose(LightPath x, RandomStream random) {
        double sum = 0;
        for (int i = 0; i < 2 * x.length; i++) {
            sum += probability(x, i >> 1, (i & 1) == 1);
        }
        double left = random.nextDouble() * sum;
        int last = 0;
        for (int i = 0; i < 2 * x.length; i++) {
            double p = probability(x, i >> 1, (i & 1) == 1);
            if (p > 0) {
                last = i;
                left -= p;
                if (left < 0) {
                    return i;
                }
            }
        }
        return last;
    }

    /** Factor from distances on the film to angles at a: of two vertices that change, the one farther from the lens is seen to move. */
    private static double scale(LightPath x, int a, int b) {
        double changed = 0;
        for (int i = Math.min(a, b); i < Math.max(a, b); i++) {
            changed += Math.sqrt(x.squared[i]);
        }
        double seen = 0;
        for (int i = Math.max(a, b); i < x.length - 1; i++) {
            seen += Math.sqrt(x.squared[i]);
        }
        return seen / (changed * Math.sqrt(x.filmPerSolidAngle));
    }

    @Override
    public boolean propose(
            LightPath x, LightPath y, Move move, PathBuilder builder, RandomStream random, long stratum) {
        int k = x.length - 1;
        int choice = choose(x, random);
        int a = choice >> 1;
        boolean towardsLight = (choice & 1) == 1;
        int b = next(x, a, towardsLight);
        int c = next(x, b, towardsLight);
        int last = Math.max(a, c);
        move.set(Math.min(a, c), last, last);
        move.towardsLight = towardsLight;
        y.length = x.length;
        y.reserve(y.length);
        y.copy(x, 0, Math.min(a, c) + 1, 0);
        y.copyLight(x);
        if (!(towardsLight
                ? perturbTowardsLight(x, y, a, b, builder, random)
                : perturbTowardsEye(x, y, a, b, builder, random))) {
            return false;
        }
        if (!towardsLight) {
            y.copy(x, c, x.length - c, c);
            y.copyLens(x);
        }
        int joined = towardsLight ? b - 1 : b;
        boolean chain = Math.abs(b - c) > 1;
        if (chain) {
            if (!builder.chains().move(x, y, c, b)) {
                return false;
            }
        } else {
            ChainPieces.setEdge(y, joined);
        }
        if (c == k && !builder.lens().aim(y, k)) {
            return false;
        }
        if (!builder.contribution().measure(y, Math.min(a, c), a == k || c == k ? y.length : last)
                || !builder.edges().reveal(y, joined)) {
            return false;
        }
        return !chain || builder.chains().isReversible() || builder.fail(Outcome.UNREACHABLE);
    }

    private boolean perturbTowardsLight(
            LightPath x, LightPath y, int a, int b, PathBuilder builder, RandomStream random) {
        if (a == x.length - 1) {
            return LensPiece.perturbFilm(x, y, smallest, largest, builder, random);
        }
        y.copy(x, a, x.length - a, a);
        y.copyLens(x);
        if (!Tilt.tilt(
                -x.dx[a - 1],
                -x.dy[a - 1],
                -x.dz[a - 1],
                smallestTilt,
                largestTilt,
                scale(x, a, b),
                random,
                builder.walk())) {
            return builder.fail(Outcome.MISSED);
        }
        boolean met = builder.walk().traceToLight(y, a, random);
        return LensPiece.follow(x, y, a - 1, b, met, builder, random);
    }

    private boolean perturbTowardsEye(
            LightPath x, LightPath y, int a, int b, PathBuilder builder, RandomStream random) {
        if (!Tilt.tilt(x.dx[a], x.dy[a], x.dz[a], smallestTilt, largestTilt, scale(x, a, b), random, builder.walk())) {
            return builder.fail(Outcome.MISSED);
        }
        if (!builder.walk().traceToEye(y, a, random)) {
            return false;
        }
        for (int i = a + 1; i < b; i++) {
            y.lobe[i] = x.lobe[i];
            if (!builder.walk().follow(y, i, false) || !builder.walk().traceToEye(y, i, random)) {
                return false;
            }
        }
        return y.bsdfs[b].connectable() || builder.fail(Outcome.KIND_CHANGED);
    }

    @Override
    public double transition(LightPath from, LightPath to, Move move, PathBuilder builder) {
        boolean towardsLight = move.towardsLight;
        int a = towardsLight ? move.newEnd : move.kept;
        int c = towardsLight ? move.kept : move.newEnd;
        int b = next(to, a, towardsLight);
        double density = towardsLight ? densityTowardsLight(from, to, a, b) : densityTowardsEye(from, to, a, b);
        return Math.abs(b - c) > 1 ? density * builder.chains().density(to, c, b) : density;
    }

    private double densityTowardsLight(LightPath from, LightPath to, int a, int b) {
        if (a == to.length - 1) {
            return LensPiece.density(to, to.length, b);
        }
        double density = Tilt.density(
                -from.dx[a - 1],
                -from.dy[a - 1],
                -from.dz[a - 1],
                -to.dx[a - 1],
                -to.dy[a - 1],
                -to.dz[a - 1],
                smallestTilt,
                largestTilt,
                scale(from, a, b));
        density *= WalkDensities.towardsLight(to, a - 1) * to.clear[a - 1] * to.opacity[a - 1];
        return density * LensPiece.density(to, a - 1, b);
    }

    private double densityTowardsEye(LightPath from, LightPath to, int a, int b) {
        double density = Tilt.density(
                from.dx[a], from.dy[a], from.dz[a], to.dx[a], to.dy[a], to.dz[a], smallest, largest, scale(from, a, b));
        density *= Densities.solidAngleToArea(
                1, to.squared[a], to.points[a + 1].geometricCosine(to.dx[a], to.dy[a], to.dz[a]));
        density *= to.clear[a] * to.opacity[a + 1];
        for (int i = a + 2; i <= b; i++) {
            density *= to.fromLight[i] * to.clear[i - 1] * to.opacity[i];
        }
        return density;
    }
}
