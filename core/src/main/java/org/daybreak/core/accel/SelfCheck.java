package org.daybreak.core.accel;

import java.util.SplittableRandom;

/**
 * Compares the answers of an intersector with those of the scalar one on a small scene of all kinds of primitives. A
 * vector kernel runs in the interpreter here, at microseconds for each operation; the number of rays keeps the check to
 * some milliseconds.
 */
final class SelfCheck {
    private static final int TRIANGLES = 60;
    private static final int RAYS = 48;

    private SelfCheck() {}

    /** Returns what is wrong, or an empty string. */
    static String run(IntersectorProvider provider) {
        SplittableRandom random = new SplittableRandom(20_240_611);
        PrimitiveSet set = scene(random);
        Intersector expected = ScalarIntersector.build(set, 1);
        Intersector actual = provider.build(set, 1);
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

    private static void aim(Ray ray, SplittableRandom random, double tMax) {
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

    private static PrimitiveSet scene(SplittableRandom random) {
        float[] positions = new float[9 * TRIANGLES];
        int[] corners = new int[3 * TRIANGLES];
        for (int i = 0; i < TRIANGLES; i++) {
            for (int axis = 0; axis < 3; axis++) {
                double centre = random.nextDouble(-1, 1);
                for (int corner = 0; corner < 3; corner++) {
                    positions[9 * i + 3 * corner + axis] = (float) (centre + random.nextDouble(-0.4, 0.4));
                }
            }
            for (int corner = 0; corner < 3; corner++) {
                corners[3 * i + corner] = 3 * i + corner;
            }
        }
        Quadric[] quadrics = {
            new Quadric(Quadric.Kind.SPHERE, new double[] {0.3, 0, 0, 0.5, 0, 0.2, 0, 0, 0, 0.1, 0.3, 0}),
            new Quadric(Quadric.Kind.DISK, new double[] {0.3, 0, 0, -0.5, 0, 0.2, 0, 0, 0, 0.1, 0.3, 0}),
            new Quadric(Quadric.Kind.CYLINDER, new double[] {0.3, 0, 0, 0, 0, 0.2, 0, 0, 0, 0.1, 0.3, 0.5})
        };
        return new PrimitiveSet(positions, corners, quadrics, new Instance[0]);
    }
}
