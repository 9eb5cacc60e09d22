package org.daybreak.core.accel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;

/** Checks that hold for every intersector; the tests of each provider run them. */
public final class IntersectorChecks {
    private IntersectorChecks() {}

    /** Triangles of random size and place in the cube [-1, 1]³ times the scale, about the centre. */
    public static PrimitiveSet randomTriangles(SplittableRandom random, int count, double size, double scale) {
        return mixed(random, count, 0, size, scale, new Instance[0]);
    }

    /** Random triangles, quadrics, and the given instances. */
    public static PrimitiveSet mixed(
            SplittableRandom random, int triangles, int quadrics, double size, double scale, Instance[] instances) {
        float[] positions = new float[9 * triangles];
        int[] corners = new int[3 * triangles];
        for (int i = 0; i < triangles; i++) {
            for (int axis = 0; axis < 3; axis++) {
                double centre = random.nextDouble(-1, 1);
                for (int corner = 0; corner < 3; corner++) {
                    positions[9 * i + 3 * corner + axis] = (float) (scale * (centre + size * random.nextDouble(-1, 1)));
                }
            }
            for (int corner = 0; corner < 3; corner++) {
                corners[3 * i + corner] = 3 * i + corner;
            }
        }
        Quadric[] shapes = new Quadric[quadrics];
        Quadric.Kind[] kinds = Quadric.Kind.values();
        for (int i = 0; i < quadrics; i++) {
            shapes[i] = new Quadric(kinds[i % kinds.length], randomAffine(random, size, scale));
        }
        return new PrimitiveSet(positions, corners, shapes, instances);
    }

    /** A random affine map: sheared, unevenly scaled, half of the time mirrored. */
    public static double[] randomAffine(SplittableRandom random, double size, double scale) {
        double[] m = new double[12];
        double determinant;
        do {
            for (int i = 0; i < 12; i++) {
                m[i] = scale * random.nextDouble(-1, 1) * (i % 4 == 3 ? 1 : size);
            }
            determinant = m[0] * (m[5] * m[10] - m[6] * m[9])
                    - m[1] * (m[4] * m[10] - m[6] * m[8])
                    + m[2] * (m[4] * m[9] - m[5] * m[8]);
        } while (Math.abs(determinant) < 0.02 * Math.pow(scale * size, 3));
        return m;
    }

    /** Aims a random ray from around the cube [-1, 1]³ times the scale into it. */
    public static void aim(Ray ray, SplittableRandom random, double scale) {
        double ox = random.nextDouble(-2, 2);
        double oy = random.nextDouble(-2, 2);
        double oz = random.nextDouble(-2, 2);
        double stretch = scale * Math.exp(random.nextDouble(-5, 5));
        ray.set(
                scale * ox,
                scale * oy,
                scale * oz,
                stretch * (random.nextDouble(-1, 1) - ox),
                stretch * (random.nextDouble(-1, 1) - oy),
                stretch * (random.nextDouble(-1, 1) - oz),
                Double.POSITIVE_INFINITY);
        int kind = random.nextInt(8);
        if (kind < 3) {
            ray.dx = kind == 0 ? ray.dx : 0;
            ray.dy = kind == 1 ? ray.dy : -0.0;
            ray.dz = kind == 2 ? ray.dz : 0;
        }
    }

    /**
     * Compares closest and any hits with brute force. A ray may disagree where it grazes an edge or two surfaces lie
     * within single precision of each other; then the reported hit must still be a true one.
     */
    public static void agreesWithBruteForce(
            IntersectorProvider provider,
            PrimitiveSet set,
            PrimitiveSet[] levels,
            SplittableRandom random,
            double scale,
            int rays,
            int allowedDifferences) {
        Intersector intersector = provider.build(set, 1);
        Ray actual = new Ray();
        Ray expected = new Ray();
        int differences = 0;
        int hits = 0;
        for (int i = 0; i < rays; i++) {
            aim(actual, random, scale);
            copy(actual, expected);
            boolean hit = BruteForce.intersect(set, levels, expected);
            if (i % 2 == 1 && hit) {
                double bound = expected.t * (random.nextBoolean() ? 0.999 : 1.001);
                actual.tMax = bound;
                expected.tMax = bound;
                hit = BruteForce.intersect(set, levels, expected);
            }
            boolean found = intersector.intersect(actual);
            assertEquals(found, actual.primitive >= 0);
            boolean same = found == hit
                    && (!hit
                            || Math.abs(actual.t - expected.t) <= 2e-5 * expected.t
                            || actual.primitive == expected.primitive && actual.instance == expected.instance);
            boolean blocked = intersector.occluded(actual);
            if (!same || blocked != hit) {
                differences++;
            }
            if (hit) {
                hits++;
            }
        }
        assertTrue(hits > rays / 50, "the scene is too empty to test anything: " + hits);
        assertTrue(differences <= allowedDifferences, differences + " of " + rays + " rays differ");
    }

    static void copy(Ray from, Ray to) {
        to.set(from.ox, from.oy, from.oz, from.dx, from.dy, from.dz, from.tMax);
    }
}
