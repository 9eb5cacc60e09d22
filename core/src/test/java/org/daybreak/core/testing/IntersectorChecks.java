package org.daybreak.core.testing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.SplittableRandom;
import org.daybreak.core.accel.HitRefinement;
import org.daybreak.core.accel.Instance;
import org.daybreak.core.accel.Intersector;
import org.daybreak.core.accel.IntersectorProvider;
import org.daybreak.core.accel.PrimitiveSet;
import org.daybreak.core.accel.Quadric;
import org.daybreak.core.accel.Ray;

/** What every intersector must hold; the tests of each one run these checks. Seeds are fixed: nothing fails by chance. */
public final class IntersectorChecks {
    private static final PrimitiveSet[] NO_LEVELS = {};

    private final IntersectorProvider provider;

    /** Checks of the intersectors of one provider. */
    public IntersectorChecks(IntersectorProvider provider) {
        this.provider = provider;
    }

    /** Random triangles, quadrics, and the given instances in the cube [-1, 1]³ times the scale. */
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
            Quadric.Kind kind = kinds[i % kinds.length];
            double[] m = randomAffine(random, size, scale);
            shapes[i] = new Quadric(kind, m);
            if (kind == Quadric.Kind.CONE && i % 8 > 3) {
                shapes[i] = shapes[i].withTaper(random.nextDouble());
            }
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

    private static void aim(Ray ray, SplittableRandom random, double scale) {
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

    /** Closest and any hits on sets of triangles of many sizes agree with brute force. */
    public void trianglesAgreeWithBruteForce(double scale) {
        SplittableRandom random = new SplittableRandom(1);
        for (int count : new int[] {1, 2, 4, 5, 16, 17, 100, 1000}) {
            PrimitiveSet set = mixed(random, count, 0, count < 17 ? 1 : 0.3, scale, new Instance[0]);
            agreesWithBruteForce(set, NO_LEVELS, random, scale, 2000);
        }
    }

    /** So do those on sets of triangles, quadrics and instances. */
    public void mixedPrimitivesAgreeWithBruteForce() {
        SplittableRandom random = new SplittableRandom(2);
        for (int round = 0; round < 5; round++) {
            PrimitiveSet[] levels = new PrimitiveSet[6];
            Instance[] instances = new Instance[6];
            for (int i = 0; i < 6; i++) {
                levels[i] = mixed(random, 20 * i, 5, 0.3, 1, new Instance[0]);
                instances[i] = new Instance(randomAffine(random, 0.6, 1), provider.build(levels[i], 1));
            }
            PrimitiveSet set = mixed(random, 100 * round, 9, 0.2, 1, instances);
            agreesWithBruteForce(set, levels, random, 1, 4000);
        }
    }

    /** One ray in some thousand may pass so near an edge that single and double precision differ. */
    private void agreesWithBruteForce(
            PrimitiveSet set, PrimitiveSet[] levels, SplittableRandom random, double scale, int rays) {
        Intersector intersector = provider.build(set, 1);
        Ray actual = new Ray();
        Ray expected = new Ray();
        int differences = 0;
        int hits = 0;
        for (int i = 0; i < rays; i++) {
            aim(actual, random, scale);
            copy(actual, expected);
            boolean hit = BruteForceIntersection.intersect(set, levels, expected);
            if (i % 2 == 1 && hit) {
                double bound = expected.t * (random.nextBoolean() ? 0.999 : 1.001);
                actual.tMax = bound;
                expected.tMax = bound;
                hit = BruteForceIntersection.intersect(set, levels, expected);
            }
            boolean found = intersector.intersect(actual);
            assertEquals(found, actual.primitive >= 0);
            boolean same = found == hit
                    && (hit
                            ? Math.abs(actual.t - expected.t) <= 2e-5 * expected.t
                                    || (actual.primitive == expected.primitive && actual.instance == expected.instance)
                            : actual.t == actual.tMax);
            if (!same || intersector.occluded(actual) != hit) {
                differences++;
            }
            hits += hit ? 1 : 0;
        }
        assertTrue(hits > rays / 50, "too few hits to test anything: " + hits);
        assertTrue(differences <= 1, differences + " of " + rays + " rays differ");
    }

    private static void copy(Ray from, Ray to) {
        to.set(from.ox, from.oy, from.oz, from.dx, from.dy, from.dz, from.tMax);
    }

    /** Axis-parallel rays through vertices and edges of the faces of a subdivided cube hit it, from inside and outside. */
    public void axisParallelRaysHitEdgesAndVertices() {
        TestMesh cube = TestMesh.cube(4);
        for (double scale : new double[] {1e-18, 1e-4, 1, 1e4, 1e15}) {
            PrimitiveSet set = cube.placed(scale, 0, 0, 0);
            Intersector intersector = provider.build(set, 1);
            Ray ray = new Ray();
            for (int axis = 0; axis < 3; axis++) {
                for (int i = -8; i <= 8; i++) {
                    for (int j = -8; j <= 8; j++) {
                        for (int start = -2; start <= 2; start++) {
                            axisRay(ray, axis, scale * i / 8, scale * j / 8, scale * start);
                            boolean expected = start < 1;
                            assertEquals(expected, intersector.intersect(ray), "axis " + axis + ", " + i + ", " + j);
                            assertEquals(expected, intersector.occluded(ray));
                        }
                    }
                }
            }
        }
    }

    private static void axisRay(Ray ray, int axis, double a, double b, double c) {
        ray.set(
                axis == 0 ? c : a,
                axis == 1 ? c : axis == 0 ? a : b,
                axis == 2 ? c : b,
                axis == 0 ? 1 : 0,
                axis == 1 ? 1 : 0,
                axis == 2 ? 1 : 0,
                Double.POSITIVE_INFINITY);
    }

    /** No ray from inside a closed mesh leaves it, though aimed at vertices and points of edges. */
    public void closedMeshesAreWatertight(int rays) {
        SplittableRandom random = new SplittableRandom(3);
        TestMesh[] meshes = {TestMesh.cube(1), TestMesh.cube(7), TestMesh.sphere(3, 4), TestMesh.sphere(40, 63)};
        for (TestMesh mesh : meshes) {
            for (double[] place : new double[][] {{1, 0, 0, 0}, {1e-4, 0, 0, 0}, {1e4, 0, 0, 0}, {1, 100, -70, 30}}) {
                PrimitiveSet set = mesh.placed(place[0], place[1], place[2], place[3]);
                Intersector intersector = provider.build(set, 1);
                Ray ray = new Ray();
                double[] target = new double[3];
                for (int i = 0; i < rays; i++) {
                    TestMesh.pointOnEdge(set, random, i % 3, target);
                    double ox = place[1] + place[0] * random.nextDouble(-0.4, 0.4);
                    double oy = place[2] + place[0] * random.nextDouble(-0.4, 0.4);
                    double oz = place[3] + place[0] * random.nextDouble(-0.4, 0.4);
                    ray.set(ox, oy, oz, target[0] - ox, target[1] - oy, target[2] - oz, Double.POSITIVE_INFINITY);
                    assertTrue(intersector.intersect(ray), "a ray escaped");
                    assertTrue(intersector.occluded(ray), "a ray escaped");
                }
            }
        }
    }

    /** Rays that come from far away find the triangle that double precision finds, at the same parameter. */
    public void farOriginsLoseNoDigits() {
        SplittableRandom random = new SplittableRandom(10);
        PrimitiveSet set = TestMesh.sphere(20, 30).placed(1, 0.3, -0.2, 0.5);
        Intersector intersector = provider.build(set, 1);
        Ray actual = new Ray();
        Ray expected = new Ray();
        HitRefinement point = new HitRefinement();
        // 12 ε |V − O|, see HitRefinement; the scene is entered some 8 units from any of its vertices at most.
        double bound = 12 * 0x1p-24 * 8;
        int differences = 0;
        for (int i = 0; i < 3000; i++) {
            double distance = Math.pow(10, i % 8 + 1);
            aim(actual, random, 0.5);
            double length = Math.sqrt(actual.dx * actual.dx + actual.dy * actual.dy + actual.dz * actual.dz);
            double back = distance / length;
            actual.ox -= back * actual.dx;
            actual.oy -= back * actual.dy;
            actual.oz -= back * actual.dz;
            copy(actual, expected);
            boolean hit = BruteForceIntersection.intersect(set, NO_LEVELS, expected);
            boolean same = intersector.intersect(actual) == hit
                    && intersector.occluded(actual) == hit
                    && actual.primitive == expected.primitive;
            differences += same ? 0 : 1;
            if (same && hit) {
                point.refine(set, actual, set);
                double cosine =
                        Math.abs(actual.dx * point.normalX + actual.dy * point.normalY + actual.dz * point.normalZ)
                                / length;
                assertEquals(0, (expected.t - actual.t) * length * cosine, bound + 1e-15 * distance);
            }
        }
        // Some rays in a million pass an edge within single precision of the scene's size.
        assertTrue(differences <= 1, differences + " of 3000 rays differ");
    }

    /**
     * Paths in a closed convex mesh: every segment ends on the mesh; a ray that goes outwards hits nothing. Every fourth
     * segment is aimed exactly at a vertex or edge, every fourth one grazes the surface that it leaves.
     */
    public void pathsNeitherLeakNorHitThemselves(int bounces) {
        SplittableRandom random = new SplittableRandom(4);
        TestMesh[] meshes = {TestMesh.cube(1), TestMesh.cube(9), TestMesh.sphere(8, 12), TestMesh.sphere(60, 90)};
        double[][] places = {
            {1, 0, 0, 0}, {1e-4, 0, 0, 0}, {1e4, 0, 0, 0}, {1, 100, 0, 0}, {1, 60, -70, 30}, {100, -60, 3, 10}
        };
        for (TestMesh mesh : meshes) {
            for (double[] place : places) {
                PrimitiveSet set = mesh.placed(place[0], place[1], place[2], place[3]);
                follow(set, set, place, bounces, random);
            }
        }
        TestMesh mesh = TestMesh.sphere(8, 12);
        for (int i = 0; i < 4; i++) {
            PrimitiveSet level = mesh.placed(1, 0.5, 0, 0);
            double[] m = randomAffine(random, 1, 1);
            m[3] += 10 * i;
            Instance[] instances = {new Instance(m, provider.build(level, 1))};
            PrimitiveSet world = new PrimitiveSet(new float[0], new int[0], new Quadric[0], instances);
            double[] place = {0, 0.5 * m[0] + m[3], 0.5 * m[4] + m[7], 0.5 * m[8] + m[11]};
            follow(world, level, place, bounces, random);
        }
    }

    private void follow(PrimitiveSet set, PrimitiveSet level, double[] place, int bounces, SplittableRandom random) {
        Intersector intersector = provider.build(set, 1);
        HitRefinement point = new HitRefinement();
        Ray ray = new Ray();
        double[] target = new double[3];
        ray.set(place[1], place[2], place[3], 0.3, 0.5, 0.7, Double.POSITIVE_INFINITY);
        for (int i = 0; i < bounces; i++) {
            if (!intersector.intersect(ray)) {
                throw new AssertionError("bounce " + i + " leaked at " + point.x + ", " + point.y + ", " + point.z
                        + ", offset " + point.offset + ", direction " + ray.dx + ", " + ray.dy + ", " + ray.dz);
            }
            point.refine(set, ray, level);
            double cosine = (place[1] - point.x) * point.normalX
                    + (place[2] - point.y) * point.normalY
                    + (place[3] - point.z) * point.normalZ;
            double inward = cosine > 0 ? 1 : -1;
            double shift = inward * point.offset;
            int kind = i & 3;
            direction(random, ray, inward, point, kind == 1 ? 1e-4 : kind == 2 ? 1e-7 : 1);
            double dx = ray.dx;
            double dy = ray.dy;
            double dz = ray.dz;
            ray.set(
                    point.x - shift * point.normalX,
                    point.y - shift * point.normalY,
                    point.z - shift * point.normalZ,
                    -dx,
                    -dy,
                    -dz,
                    Double.POSITIVE_INFINITY);
            assertFalse(intersector.occluded(ray), "an outward ray hit a convex mesh");
            ray.set(
                    point.x + shift * point.normalX,
                    point.y + shift * point.normalY,
                    point.z + shift * point.normalZ,
                    dx,
                    dy,
                    dz,
                    Double.POSITIVE_INFINITY);
            if (kind == 3 && set == level) {
                TestMesh.pointOnEdge(set, random, i >> 2 & 1, target);
                double x = target[0] - ray.ox;
                double y = target[1] - ray.oy;
                double z = target[2] - ray.oz;
                if ((x * point.normalX + y * point.normalY + z * point.normalZ) * inward > 0) {
                    ray.dx = x;
                    ray.dy = y;
                    ray.dz = z;
                }
            }
        }
    }

    /** A random direction on the inward side whose cosine to the normal is about the given number. */
    private static void direction(SplittableRandom random, Ray ray, double side, HitRefinement p, double steepness) {
        double x;
        double y;
        double z;
        double length;
        do {
            x = random.nextDouble(-1, 1);
            y = random.nextDouble(-1, 1);
            z = random.nextDouble(-1, 1);
            length = Math.sqrt(x * x + y * y + z * z);
        } while (length > 1 || length < 1e-3);
        double along = x * p.normalX + y * p.normalY + z * p.normalZ;
        double wanted = steepness == 1 ? Math.abs(along) : steepness * Math.abs(along);
        double change = side * wanted - along;
        ray.dx = x + change * p.normalX;
        ray.dy = y + change * p.normalY;
        ray.dz = z + change * p.normalZ;
    }

    /** Sets that have nothing to hit. */
    public void nothingIsHitWhereNothingIs() {
        float[] line = {0, 0, 0, 1, 1, 1, 2, 2, 2, 5, 5, 5};
        int[] corners = {0, 1, 2, 0, 0, 0, 3, 1, 1, 0, 2, 3};
        PrimitiveSet[] sets = {
            PrimitiveSet.ofTriangles(new float[0], new int[0]),
            PrimitiveSet.ofTriangles(line, new int[0]),
            PrimitiveSet.ofTriangles(line, corners)
        };
        for (PrimitiveSet set : sets) {
            Intersector intersector = provider.build(set, 1);
            Ray ray = new Ray();
            ray.set(1, 1, -3, 0, 0, 1, Double.POSITIVE_INFINITY);
            assertFalse(intersector.intersect(ray));
            assertFalse(intersector.occluded(ray));
            assertEquals(-1, ray.primitive);
            float[] bounds = new float[6];
            intersector.bounds(bounds);
            assertEquals(Float.POSITIVE_INFINITY, bounds[0]);
            assertEquals(Float.NEGATIVE_INFINITY, bounds[3]);
        }
    }

    /** A ray without a direction, or with one that is not finite, hits nothing. */
    public void improperRaysHitNothing() {
        PrimitiveSet set = TestMesh.sphere(20, 30).placed(1, 0, 0, 0);
        Intersector intersector = provider.build(set, 1);
        Ray ray = new Ray();
        double[][] directions = {
            {0, 0, 0}, {Double.NaN, 1, 0}, {0, Double.POSITIVE_INFINITY, 0}, {1, Double.NEGATIVE_INFINITY, Double.NaN}
        };
        for (double[] d : directions) {
            ray.set(0.1, 0.2, 0.3, d[0], d[1], d[2], Double.POSITIVE_INFINITY);
            assertFalse(intersector.intersect(ray));
            assertFalse(intersector.occluded(ray));
        }
        for (double length : new double[] {1e-300, 1e-30, 1e30, 1e300}) {
            ray.set(0.1, 0.2, 0.3, 0, length, 0, Double.POSITIVE_INFINITY);
            assertTrue(intersector.intersect(ray));
            assertEquals(0.73, ray.t * length, 0.02);
            ray.tMax = 0.5 / length;
            assertFalse(intersector.occluded(ray));
        }
    }

    /** Thousands of triangles in one place cannot be split by position. */
    public void coincidentTriangles() {
        int count = 5000;
        float[] positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
        int[] corners = new int[3 * count];
        for (int i = 0; i < corners.length; i++) {
            corners[i] = i % 3;
        }
        Intersector intersector = provider.build(PrimitiveSet.ofTriangles(positions, corners), 2);
        Ray ray = new Ray();
        ray.set(0.25, 0.25, 2, 0, 0, -0.5, Double.POSITIVE_INFINITY);
        assertTrue(intersector.intersect(ray));
        assertEquals(4, ray.t);
        assertTrue(intersector.occluded(ray));
        ray.tMax = 4;
        assertFalse(intersector.intersect(ray));
        assertFalse(intersector.occluded(ray));
        ray.set(0.25, 0.25, 0, 0, 0, -0.5, Double.POSITIVE_INFINITY);
        assertFalse(intersector.intersect(ray), "a hit at t = 0");
        assertFalse(intersector.occluded(ray), "a hit at t = 0");
        ray.set(0.75, 0.75, 2, 0, 0, -0.5, Double.POSITIVE_INFINITY);
        assertFalse(intersector.intersect(ray));
    }

    /** The tree, and with it every answer, is the same for any number of build threads. */
    public void answersDoNotDependOnThreads() {
        PrimitiveSet set = mixed(new SplittableRandom(5), 30_000, 300, 0.03, 1, new Instance[0]);
        Intersector[] intersectors = new Intersector[8];
        for (int i = 0; i < 8; i++) {
            intersectors[i] = provider.build(set, i + 1);
            assertEquals(intersectors[0].memoryBytes(), intersectors[i].memoryBytes());
        }
        SplittableRandom random = new SplittableRandom(6);
        Ray first = new Ray();
        Ray other = new Ray();
        for (int i = 0; i < 3000; i++) {
            aim(first, random, 1);
            copy(first, other);
            intersectors[0].intersect(first);
            for (int k = 1; k < 8; k++) {
                intersectors[k].intersect(other);
                assertEquals(first.primitive, other.primitive);
                assertEquals(Double.doubleToLongBits(first.t), Double.doubleToLongBits(other.t));
            }
        }
    }

    /** Queries allocate nothing once they are compiled. */
    public void queriesAllocateNothing() {
        SplittableRandom random = new SplittableRandom(7);
        PrimitiveSet level = mixed(random, 500, 3, 0.1, 1, new Instance[0]);
        Instance[] instances = {new Instance(randomAffine(random, 0.5, 1), provider.build(level, 1))};
        PrimitiveSet set = mixed(random, 2000, 20, 0.1, 1, instances);
        Intersector intersector = provider.build(set, 1);
        int count = 1 << 12;
        double[] rays = new double[6 * count];
        Ray ray = new Ray();
        for (int i = 0; i < count; i++) {
            aim(ray, random, 1);
            double[] r = {ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz};
            System.arraycopy(r, 0, rays, 6 * i, 6);
        }
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        long thread = Thread.currentThread().getId();
        long least = Long.MAX_VALUE;
        // The compiler works beside the test; it may take a while until the last version of the code is in use.
        for (int round = 0; round < 600 && least >= 512; round++) {
            long before = threads.getThreadAllocatedBytes(thread);
            queryAll(intersector, rays, ray);
            least = Math.min(least, threads.getThreadAllocatedBytes(thread) - before);
        }
        // Reading the counter may itself allocate a few bytes; one object for each ray would be 65536.
        assertTrue(least < 512, least + " bytes for " + 2 * count + " queries");
    }

    private static int queryAll(Intersector intersector, double[] rays, Ray ray) {
        int hits = 0;
        for (int i = 0; i < rays.length; i += 6) {
            ray.set(rays[i], rays[i + 1], rays[i + 2], rays[i + 3], rays[i + 4], rays[i + 5], Double.POSITIVE_INFINITY);
            hits += intersector.intersect(ray) ? 1 : 0;
            hits += intersector.occluded(ray) ? 1 : 0;
        }
        return hits;
    }
}
