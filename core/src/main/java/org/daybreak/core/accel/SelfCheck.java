package org.daybreak.core.accel;

import java.util.SplittableRandom;

/**
 * Compares the answers of two intersectors on a small scene of triangles and quadrics. For providers whose code may go
 * wrong on some JVM, and for tests.
 */
public final class SelfCheck {
    private static final int RAYS = 500;

    private SelfCheck() {}

    /**
     * Asks both the same.
     *
     * @param expected gives right answers for {@link #scene}
     * @param actual is to be checked on the same scene
     * @return what is wrong, or an empty string
     */
    public static String compare(Intersector expected, Intersector actual) {
        SplittableRandom random = new SplittableRandom(20_240_611);
        Ray a = new Ray();
        Ray b = new Ray();
        for (int i = 0; i < RAYS; i++) {
            double tMax = i % 3 == 0 ? 3 : Double.POSITIVE_INFINITY;
            aim(a, random, tMax);
            b.set(a.ox, a.oy, a.oz, a.dx, a.dy, a.dz, tMax);
            boolean hit = expected.intersect(a);
            if (actual.intersect(b) != hit || a.primitive != b.primitive || Math.abs(a.t - b.t) > 1e-5 * a.t) {
                return "it gives a wrong closest hit: primitive " + b.primitive + " at " + b.t + " instead of "
                        + a.primitive + " at " + a.t;
            }
            if (actual.occluded(b) != hit) {
                return "it gives a wrong answer to whether a ray is blocked";
            }
        }
        return "";
    }

    /** Aims a random ray from around the scene into it. */
    public static void aim(Ray ray, SplittableRandom random, double tMax) {
        double ox = random.nextDouble(-2, 2);
        double oy = random.nextDouble(-2, 2);
        double oz = random.nextDouble(-2, 2);
        ray.set(
                ox,
                oy,
                oz,
                random.nextDouble(-1, 1) - ox,
                random.nextDouble(-1, 1) - oy,
                random.nextDouble(-1, 1) - oz,
                tMax);
    }

    /**
     * A sphere, a disk, a cylinder and random triangles in the cube [-1, 1]³.
     *
     * @param triangles number of triangles
     */
    public static PrimitiveSet scene(int triangles) {
        SplittableRandom random = new SplittableRandom(20_240_612);
        double size = 2 / Math.cbrt(triangles);
        float[] positions = new float[9 * triangles];
        int[] corners = new int[3 * triangles];
        for (int i = 0; i < triangles; i++) {
            for (int axis = 0; axis < 3; axis++) {
                double centre = random.nextDouble(-1, 1);
                for (int corner = 0; corner < 3; corner++) {
                    positions[9 * i + 3 * corner + axis] = (float) (centre + size * random.nextDouble(-0.5, 0.5));
                }
            }
            for (int corner = 0; corner < 3; corner++) {
                corners[3 * i + corner] = 3 * i + corner;
            }
        }
        Quadric[] quadrics = {
            new Quadric(Quadric.Kind.SPHERE, new double[] {0.3, 0, 0, 0.5, 0, 0.2, 0, 0, 0, 0.1, 0.3, 0}),
            new Quadric(Quadric.Kind.DISK, new double[] {0.3, 0, 0, -0.5, 0, 0.2, 0, 0, 0, 0.1, 0.3, 0}),
            new Quadric(Quadric.Kind.CYLINDER, new double[] {0.3, 0, 0, 0, 0, 0.2, 0, 0, 0, 0.1, 0.3, 0.5}),
            new Quadric(Quadric.Kind.CONE, new double[] {0.3, 0, 0, 0.5, 0, 0.2, 0, -0.5, 0, 0.1, 0.3, 0})
                    .withTaper(0.7)
        };
        return new PrimitiveSet(positions, corners, quadrics, new Instance[0]);
    }
}
