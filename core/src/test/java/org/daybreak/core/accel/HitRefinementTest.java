package org.daybreak.core.accel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import org.daybreak.core.testing.IntersectorChecks;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class HitRefinementTest {
    private final Ray ray = new Ray();
    private final HitRefinement point = new HitRefinement();

    /** The point lies on the plane of the triangle to double precision, and on the ray as far as it is kept off edges. */
    @ParameterizedTest
    @ValueSource(doubles = {1e-6, 1, 1e6})
    void pointsLieOnTheirTriangle(double scale) {
        SplittableRandom random = new SplittableRandom(1);
        PrimitiveSet set = IntersectorChecks.mixed(random, 300, 0, 0.3, scale, new Instance[0]);
        Intersector intersector = new ScalarProvider().build(set, 1);
        int hits = 0;
        for (int i = 0; i < 5000; i++) {
            double ox = scale * random.nextDouble(-2, 2);
            double oy = scale * random.nextDouble(-2, 2);
            double oz = scale * random.nextDouble(-2, 2);
            ray.set(
                    ox,
                    oy,
                    oz,
                    scale * random.nextDouble(-1, 1) - ox,
                    scale * random.nextDouble(-1, 1) - oy,
                    scale * random.nextDouble(-1, 1) - oz,
                    Double.POSITIVE_INFINITY);
            if (!intersector.intersect(ray)) {
                continue;
            }
            hits++;
            point.refine(set, ray, set);
            float[] p = set.positions();
            int a = 9 * ray.primitive;
            double distance = (point.x - p[a]) * point.normalX
                    + (point.y - p[a + 1]) * point.normalY
                    + (point.z - p[a + 2]) * point.normalZ;
            assertEquals(0, distance, 1e-14 * scale);
            assertEquals(
                    1,
                    point.normalX * point.normalX + point.normalY * point.normalY + point.normalZ * point.normalZ,
                    1e-14);
            assertTrue(point.u > 0 && point.v > 0 && point.u + point.v < 1);
            assertTrue(point.offset > 0 && point.offset < 1e-5 * scale);
            double ux = point.x - ox;
            double uy = point.y - oy;
            double uz = point.z - oz;
            double t =
                    (ux * ray.dx + uy * ray.dy + uz * ray.dz) / (ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz);
            double off = Math.hypot(Math.hypot(ux - t * ray.dx, uy - t * ray.dy), uz - t * ray.dz);
            assertTrue(off < 1e-3 * scale, "the point is " + off + " off the ray");
            if (point.u > 0.01 && point.v > 0.01 && point.u + point.v < 0.99) {
                assertTrue(off < 1e-12 * scale, "the point is " + off + " off the ray");
            }
        }
        assertTrue(hits > 1000);
    }

    /**
     * From points on a closed quadric, or a room of two disks and a cylinder or frustum, outward rays hit nothing and inward rays
     * hit something, whatever the transform.
     */
    @ParameterizedTest
    @EnumSource(names = {"SPHERE", "CYLINDER", "CONE"})
    void raysFromQuadricsNeitherLeakNorHitThemselves(Quadric.Kind kind) {
        SplittableRandom random = new SplittableRandom(2);
        for (int round = 0; round < 40; round++) {
            double[] m = IntersectorChecks.randomAffine(random, 1, 1);
            double scale = Math.pow(10, round % 9 - 4);
            for (int i = 0; i < 12; i++) {
                m[i] *= scale;
            }
            m[3] += scale * (round % 3) * 30;
            double[] top = m.clone();
            for (int row = 0; row < 12; row += 4) {
                top[row + 3] += m[row + 2];
            }
            double taper = kind == Quadric.Kind.CONE ? 0.1 + 0.5 * random.nextDouble() : 0;
            for (int row = 0; row < 12; row += 4) {
                top[row] *= 1 - taper;
                top[row + 1] *= 1 - taper;
            }
            Quadric side = kind == Quadric.Kind.CONE ? new Quadric(kind, m).withTaper(taper) : new Quadric(kind, m);
            Quadric[] quadrics = kind == Quadric.Kind.SPHERE
                    ? new Quadric[] {side}
                    : new Quadric[] {side, new Quadric(Quadric.Kind.DISK, m), new Quadric(Quadric.Kind.DISK, top)};
            double height = kind == Quadric.Kind.SPHERE ? 0 : 0.5;
            double[] centre = {m[3] + height * m[2], m[7] + height * m[6], m[11] + height * m[10]};
            follow(new PrimitiveSet(new float[0], new int[0], quadrics, new Instance[0]), centre, random);
        }
    }

    private void follow(PrimitiveSet set, double[] centre, SplittableRandom random) {
        Intersector intersector = new ScalarProvider().build(set, 1);
        ray.set(centre[0], centre[1], centre[2], 1, 2, 3, Double.POSITIVE_INFINITY);
        for (int bounce = 0; bounce < 5000; bounce++) {
            assertTrue(intersector.intersect(ray), "a ray leaked");
            point.refine(set, ray, set);
            double side = (centre[0] - point.x) * point.normalX
                                    + (centre[1] - point.y) * point.normalY
                                    + (centre[2] - point.z) * point.normalZ
                            > 0
                    ? 1
                    : -1;
            double x = random.nextDouble(-1, 1);
            double y = random.nextDouble(-1, 1);
            double z = random.nextDouble(-1, 1);
            double along = x * point.normalX + y * point.normalY + z * point.normalZ;
            double change = side * Math.abs(along) * (bounce % 2 == 0 ? 1 : 1e-3) - along;
            x += change * point.normalX;
            y += change * point.normalY;
            z += change * point.normalZ;
            double shift = side * point.offset;
            ray.set(
                    point.x - shift * point.normalX,
                    point.y - shift * point.normalY,
                    point.z - shift * point.normalZ,
                    -x,
                    -y,
                    -z,
                    Double.POSITIVE_INFINITY);
            assertFalse(intersector.occluded(ray), "an outward ray hit something");
            ray.set(
                    point.x + shift * point.normalX,
                    point.y + shift * point.normalY,
                    point.z + shift * point.normalZ,
                    x,
                    y,
                    z,
                    Double.POSITIVE_INFINITY);
        }
    }

    /** A mirroring instance keeps the side of a triangle; its offset grows with the scale along the normal. */
    @Test
    void instancesTransformNormalAndOffset() {
        float[] positions = {-1, -1, 1, 1, -1, 1, 0, 1, 1};
        PrimitiveSet level = PrimitiveSet.ofTriangles(positions, new int[] {0, 1, 2});
        double[] m = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -8, 0};
        Instance[] instances = {new Instance(m, new ScalarProvider().build(level, 1))};
        PrimitiveSet set = new PrimitiveSet(new float[0], new int[0], new Quadric[0], instances);
        ray.set(0, 0, 0, 0, 0, -1, Double.POSITIVE_INFINITY);
        assertTrue(new ScalarProvider().build(set, 1).intersect(ray));
        assertEquals(8, ray.t, 1e-5);
        assertEquals(0, ray.instance);
        point.refine(set, ray, level);
        assertEquals(-8, point.z, 1e-14);
        assertEquals(-1, point.normalZ, 1e-14);
        double scaled = point.offset;
        m[10] = -1;
        Instance[] unscaled = {new Instance(m, new ScalarProvider().build(level, 1))};
        point.refine(new PrimitiveSet(new float[0], new int[0], new Quadric[0], unscaled), ray, level);
        assertEquals(8, scaled / point.offset, 1e-3);
    }
}
