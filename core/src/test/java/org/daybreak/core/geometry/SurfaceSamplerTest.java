package org.daybreak.core.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import javax.vecmath.Point3d;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.Significance;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class SurfaceSamplerTest {
    /** False-alarm rate of each kind of test here, over all its cases. */
    private static final double SIGNIFICANCE = 1e-4;

    static List<SurfaceCase> cases() {
        return SurfaceCase.all();
    }

    @ParameterizedTest
    @MethodSource("cases")
    void directionsFollowTheirDensity(SurfaceCase surface) {
        SurfaceSampler sampler = surface.sampler();
        int tests = cases().size() * SurfaceCase.views().size();
        for (double[] p : SurfaceCase.views()) {
            double radius = chartRadius(surface, p);
            SurfacePoint point = new SurfacePoint();
            if (!seesFront(surface, p)) {
                assertEquals(0, sampler.sampleDirection(p[0], p[1], p[2], 0.3, 0.6, point), surface.name());
                continue;
            }
            SurfacePoint hit = new SurfacePoint();
            DirectionChart chart = chart(surface, p);
            double[] d = new double[3];
            ChiSquareTest.ofPoints(
                            surface + " from " + p[0],
                            (u, v, w, xy) -> {
                                if (!(sampler.sampleDirection(p[0], p[1], p[2], u, v, point) > 0)) {
                                    return false;
                                }
                                direction(p, point, d);
                                chart.toChart(d[0], d[1], d[2], xy);
                                return true;
                            },
                            (x, y) -> chart.toDirection(x, y, d) && surface.hit(p[0], p[1], p[2], d[0], d[1], d[2], hit)
                                    ? sampler.directionDensity(p[0], p[1], p[2], hit, d[0], d[1], d[2])
                                    : 0,
                            -radius,
                            radius,
                            -radius,
                            radius)
                    .cells(13, 13)
                    .samples(30_000)
                    // Towards the silhouette of a ruled surface the density has a pole, which takes a finer quadrature.
                    .depth(4, surface.name().matches(".*(cylinder|cone|frustum).*") ? 10 : 6)
                    .assertAgrees(Significance.sidak(SIGNIFICANCE, tests));
        }
    }

    @ParameterizedTest
    @MethodSource("cases")
    void pointsLieOnTheSurfaceAndStateTheirDensity(SurfaceCase surface) {
        SurfaceSampler sampler = surface.sampler();
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        SurfacePoint point = new SurfacePoint();
        SurfacePoint hit = new SurfacePoint();
        double[] d = new double[3];
        for (int i = 0; i < 2000; i++) {
            double density = sampler.sampleArea(random.nextDouble(), random.nextDouble(), point);
            assertEquals(density, sampler.areaDensity(point), 1e-9 * density, surface.name());
            assertFrame(point);
            // Seen from a point straight in front, the surface is where the sampler says, and turns the same way.
            double[] front = {point.x + 1e-3 * point.gx, point.y + 1e-3 * point.gy, point.z + 1e-3 * point.gz};
            direction(front, point, d);
            assertTrue(surface.hit(front[0], front[1], front[2], d[0], d[1], d[2], hit), surface.name());
            assertEquals(0, distance(point, hit), 1e-9);
            assertEquals(1, hit.geometricCosine(point.gx, point.gy, point.gz), 1e-9);
            assertTrue(point.offset > 0 && point.offset < 1e-5);
            for (double[] p : SurfaceCase.views()) {
                double perSolidAngle =
                        sampler.sampleDirection(p[0], p[1], p[2], random.nextDouble(), random.nextDouble(), point);
                if (perSolidAngle > 0) {
                    direction(p, point, d);
                    double again = sampler.directionDensity(p[0], p[1], p[2], point, d[0], d[1], d[2]);
                    if (point.geometricCosine(d[0], d[1], d[2]) < -1e-6) {
                        assertEquals(perSolidAngle, again, 1e-7 * perSolidAngle, surface.name());
                    }
                }
            }
        }
    }

    @ParameterizedTest
    @MethodSource("cases")
    void reciprocalDensitiesAddUpToTheArea(SurfaceCase surface) {
        SurfaceSampler sampler = surface.sampler();
        RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
        SurfacePoint point = new SurfacePoint();
        Moments area = new Moments();
        for (int i = 0; i < 50_000; i++) {
            area.add(1 / sampler.sampleArea(random.nextDouble(), random.nextDouble(), point));
        }
        if (area.variance() < 1e-20) {
            assertEquals(area.mean(), sampler.area(), 1e-9 * sampler.area());
        } else {
            ZTest.assertNotRejected(
                    surface.name(),
                    ZTest.oneSample(area, sampler.area()),
                    Significance.sidak(SIGNIFICANCE, cases().size()));
        }
    }

    @Test
    void areasAreThoseOfTheClosedForms() {
        assertEquals(4 * Math.PI * 9, area(new Sphere(new Point3d(1, 2, 3), 3), Transform.identity()), 1e-9);
        assertEquals(4 * 2 * 3, area(new Rectangle(), Transform.scale(2, 3, 7)), 1e-12);
        assertEquals(Math.PI * 6, area(new Disk(), Transform.scale(-2, 3, 7)), 1e-12);
        assertEquals(
                2 * Math.PI * 0.5 * 4,
                area(new Cylinder(new Point3d(), new Point3d(0, 4, 0), 0.5), Transform.identity()),
                1e-9);
        assertEquals(
                Math.PI * (2 + 0.5) * Math.hypot(4, 1.5),
                area(new Cone(new Point3d(), new Point3d(0, 4, 0), 0.5, 2), Transform.identity()),
                1e-9);
        assertEquals(
                Math.PI * 2 * Math.hypot(4, 2),
                area(new Cone(new Point3d(), new Point3d(0, 0, 4), 2, 0), Transform.identity()),
                1e-9);
        assertEquals(8 * (2 * 3 + 3 * 4 + 2 * 4), area(new Cube(), Transform.scale(2, 3, 4)), 1e-9);
        // Oblate spheroid, a = 2, c = 1: 2πa²(1 + (1 − e²)/e · artanh e), e² = 3/4.
        double e = Math.sqrt(0.75);
        double expected = 2 * Math.PI * 4 * (1 + 0.25 / e * 0.5 * Math.log((1 + e) / (1 - e)));
        assertEquals(expected, area(new Sphere(new Point3d(), 1), Transform.scale(2, 2, 1)), 1e-5);
    }

    @Test
    void rectanglesAndSpheresAreSampledUniformlyBySolidAngle() {
        SurfacePoint point = new SurfacePoint();
        SurfaceSampler square = SurfaceSamplers.of(new Rectangle(), Transform.identity(), false);
        // The face of a cube seen from its centre is a sixth of the sphere.
        assertEquals(6 / (4 * Math.PI), square.sampleDirection(0, 0, 1, 0.3, 0.7, point), 1e-12);
        SurfaceSampler sphere = SurfaceSamplers.of(new Sphere(new Point3d(), 1), Transform.identity(), false);
        for (double distance : new double[] {1.0001, 1.5, 10, 1e4, 1e9}) {
            double cos = Math.sqrt((1 - 1 / distance) * (1 + 1 / distance));
            double solidAngle = 2 * Math.PI / (distance * distance) / (1 + cos);
            double density = sphere.sampleDirection(0, 0, distance, 0.3, 0.7, point);
            assertEquals(1 / solidAngle, density, 1e-10 / solidAngle);
            assertEquals(1, Math.sqrt(point.x * point.x + point.y * point.y + point.z * point.z), 1e-12);
            assertTrue(point.z * distance > 1 - 1e-9, "in view");
        }
        // u = 0 and u = 1 are the nearest point and the rim.
        sphere.sampleDirection(0, 0, 2, 0, 0, point);
        assertEquals(1, point.z, 1e-15);
        sphere.sampleDirection(0, 0, 2, 1, 0, point);
        assertEquals(0.5, point.z, 1e-7);
    }

    @Test
    void farRectanglesKeepTheirPrecision() {
        SurfaceSampler square = SurfaceSamplers.of(new Rectangle(), Transform.scale(0.5, 0.5, 1), false);
        SurfacePoint point = new SurfacePoint();
        for (double distance : new double[] {1, 10, 25, 30, 100, 1e4, 1e7}) {
            for (double height : new double[] {1, 1e-3, 1e-6, 1e-9}) {
                double x = distance;
                double z = distance * height;
                double density = square.sampleDirection(x, 0, z, 0.37, 0.61, point);
                double expected = SurfaceSampler.perSolidAngle(1, x, 0, z, point);
                // By solid angle or by area, the density differs from the other by the spread over the light only.
                assertEquals(1, density / expected, 6 / distance, "from " + x + ", " + z);
                assertTrue(Math.abs(point.x) <= 0.5 && Math.abs(point.y) <= 0.5 && Math.abs(point.z) == 0);
            }
        }
        assertEquals(0, square.sampleDirection(1, 2, -0.1, 0.5, 0.5, point), "from behind");
        assertEquals(0, square.sampleDirection(3, 1, 0, 0.5, 0.5, point), "from the plane");
    }

    @Test
    void degenerateTrianglesAreNeverChosen() {
        float[] positions = {0, 0, 0, 1, 0, 0, 0, 1, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0, 0, 0, 1, 1, 0, 1, 0, 2, 1};
        TriangleMesh mesh =
                new TriangleMesh(positions, new int[] {3, 4, 5, 0, 1, 2, 1, 1, 2, 6, 7, 8, 3, 5, 4}, null, null);
        SurfaceSampler sampler = SurfaceSamplers.of(mesh, Transform.identity(), false);
        assertEquals(1.5, sampler.area(), 1e-15);
        SurfacePoint point = new SurfacePoint();
        long[] counts = new long[5];
        for (int i = 0; i < 3000; i++) {
            assertEquals(1 / 1.5, sampler.sampleArea(i / 3000.0, 0.5, point), 1e-12);
            counts[point.primitive]++;
        }
        // The numbers are evenly spaced, so the shares of the triangles are exact.
        assertEquals(
                List.of(0L, 1000L, 0L, 2000L, 0L),
                java.util.Arrays.stream(counts).boxed().toList());
        SurfaceSampler flat = SurfaceSamplers.of(
                new TriangleMesh(positions, new int[] {3, 4, 5}, null, null), Transform.identity(), false);
        assertEquals(0, flat.area());
        assertEquals(0, flat.sampleArea(0.5, 0.5, point));
        assertEquals(0, flat.sampleDirection(1, 1, 1, 0.5, 0.5, point));
        assertEquals(0, flat.irradiance(1, 1, 1, 0, 0, 1));
    }

    @Test
    void textureCoordinatesFollowTheShapes() {
        SurfacePoint point = new SurfacePoint();
        Transform map = SurfaceCase.all().get(2).toWorld();
        place(map, 0.5, -0.2, 0, point);
        SurfaceSampler disk = SurfaceSamplers.of(new Disk(), map, false);
        disk.setTextureCoordinates(point);
        assertEquals(Math.hypot(0.5, 0.2), point.u, 1e-12);
        assertEquals(1 - Math.atan2(0.2, 0.5) / (2 * Math.PI), point.v, 1e-12);
        SurfaceSampler rectangle = SurfaceSamplers.of(new Rectangle(), map, false);
        rectangle.sampleArea(0.25, 0.75, point);
        place(map, -0.5, 0.5, 0, new SurfacePoint());
        assertEquals(0.25, point.u, 1e-12);
        assertEquals(0.75, point.v, 1e-12);
        SurfacePoint expected = new SurfacePoint();
        place(map, -0.5, 0.5, 0, expected);
        assertEquals(0, distance(point, expected), 1e-12);
        SurfaceSampler sphere = SurfaceSamplers.of(new Sphere(new Point3d(1, 0, 0), 2), map, false);
        place(map, 1 + 2 * 0.6, 0, 2 * 0.8, point);
        sphere.setTextureCoordinates(point);
        assertEquals(0, Math.min(point.u, 1 - point.u), 1e-12);
        assertEquals(Math.acos(0.8) / Math.PI, point.v, 1e-12);
        Cylinder shape = new Cylinder(new Point3d(0, 0, 1), new Point3d(0, 0, 3), 2);
        SurfaceSampler cylinder = SurfaceSamplers.of(shape, map, false);
        place(map, 0, 2, 1.5, point);
        cylinder.setTextureCoordinates(point);
        assertEquals(0.25, point.u, 1e-12);
        assertEquals(0.25, point.v, 1e-12);
    }

    @Test
    void meshesInterpolateNormalsAndCoordinates() {
        TriangleMesh mesh = new TriangleMesh(
                new float[] {0, 0, 0, 1, 0, 0, 0, 1, 0},
                new int[] {0, 1, 2},
                new float[] {0, 0, -2, 0.5F, 0, -1, 0, 0.5F, -1},
                new float[] {0, 0, 2, 0, 0, 4});
        SurfacePoint point = new SurfacePoint();
        SurfaceSamplers.of(mesh, Transform.scale(1, 1, -1), true).sampleArea(0.3, 0.6, point);
        // The mirror puts the outer side below, the flip puts the front above again.
        assertEquals(1, point.gz, 1e-15);
        double x = point.x;
        double y = point.y;
        double z = -2 + x + y;
        double length = Math.sqrt(0.25 * x * x + 0.25 * y * y + z * z);
        // The object-space normal (x/2, y/2, z) is mirrored to (x/2, y/2, −z), which is on the side of the front.
        assertEquals(0.5 * x / length, point.nx, 1e-7);
        assertEquals(0.5 * y / length, point.ny, 1e-7);
        assertEquals(-z / length, point.nz, 1e-7);
        SurfaceSamplers.of(mesh, Transform.scale(1, 1, -1), false).sampleArea(0.3, 0.6, point);
        assertEquals(-1, point.gz, 1e-15);
        assertEquals(z / length, point.nz, 1e-7);
        assertEquals(2 * x, point.u, 1e-7);
        assertEquals(4 * y, point.v, 1e-7);
    }

    static double area(Shape shape, Transform toWorld) {
        return SurfaceSamplers.of(shape, toWorld, false).area();
    }

    private static void place(Transform map, double x, double y, double z, SurfacePoint out) {
        double[] d = new double[3];
        map.applyPoint(x, y, z, d);
        out.x = d[0];
        out.y = d[1];
        out.z = d[2];
    }

    private static DirectionChart chart(SurfaceCase surface, double[] p) {
        double[] c = new double[3];
        surface.toWorld().applyPoint(0, 0, 0, c);
        return new DirectionChart(c[0] - p[0], c[1] - p[1], c[2] - p[2]);
    }

    /** Half the side of the square of the chart that holds all directions to the surface. */
    private static double chartRadius(SurfaceCase surface, double[] p) {
        SurfaceSampler sampler = surface.sampler();
        DirectionChart chart = chart(surface, p);
        SurfacePoint point = new SurfacePoint();
        double[] d = new double[3];
        double[] xy = new double[2];
        double most = 0;
        for (int i = 0; i <= 64; i++) {
            for (int j = 0; j <= 64; j++) {
                sampler.sampleArea(Math.min(i / 64.0, 1 - 1e-9), Math.min(j / 64.0, 1 - 1e-9), point);
                direction(p, point, d);
                chart.toChart(d[0], d[1], d[2], xy);
                most = Math.max(most, Math.max(Math.abs(xy[0]), Math.abs(xy[1])));
            }
        }
        return Math.min(2, 1.2 * most);
    }

    private static boolean seesFront(SurfaceCase surface, double[] p) {
        SurfaceSampler sampler = surface.sampler();
        SurfacePoint point = new SurfacePoint();
        for (int i = 0; i < 64; i++) {
            for (int j = 0; j < 64; j++) {
                sampler.sampleArea((i + 0.5) / 64, (j + 0.5) / 64, point);
                if (point.geometricCosine(p[0] - point.x, p[1] - point.y, p[2] - point.z) > 0) {
                    return true;
                }
            }
        }
        return false;
    }

    private static void direction(double[] p, SurfacePoint point, double[] d) {
        double dx = point.x - p[0];
        double dy = point.y - p[1];
        double dz = point.z - p[2];
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        d[0] = dx / length;
        d[1] = dy / length;
        d[2] = dz / length;
    }

    private static double distance(SurfacePoint a, SurfacePoint b) {
        return Math.sqrt((a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y) + (a.z - b.z) * (a.z - b.z));
    }

    private static void assertFrame(SurfacePoint p) {
        assertEquals(1, p.gx * p.gx + p.gy * p.gy + p.gz * p.gz, 1e-12);
        assertEquals(1, p.sx * p.sx + p.sy * p.sy + p.sz * p.sz, 1e-12);
        assertEquals(0, p.sx * p.nx + p.sy * p.ny + p.sz * p.nz, 1e-12);
        assertEquals(p.tx, p.ny * p.sz - p.nz * p.sy, 1e-12);
        assertEquals(p.ty, p.nz * p.sx - p.nx * p.sz, 1e-12);
        assertEquals(p.tz, p.nx * p.sy - p.ny * p.sx, 1e-12);
        assertFalse(p.geometricCosine(p.nx, p.ny, p.nz) <= 0);
    }
}
