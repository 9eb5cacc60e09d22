package org.daybreak.core.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.lang.management.ManagementFactory;
import java.util.List;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.Significance;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class PerspectiveCameraTest {
    /** False-alarm rate of each kind of test here, over all its cases. */
    private static final double SIGNIFICANCE = 1e-4;

    private static final Transform PLACE = CameraTest.PLACE;

    private static List<CameraTest.Case> cases() {
        return CameraTest.cases().stream()
                .filter(c -> c.camera() instanceof PerspectiveCamera)
                .toList();
    }

    @ParameterizedTest
    @MethodSource("cases")
    void directionsFollowTheirDensity(CameraTest.Case c) {
        Camera camera = c.camera();
        CameraRay ray = new CameraRay();
        camera.sampleRay(1, 1, 0.3, 0.8, ray);
        double ox = ray.ox;
        double oy = ray.oy;
        double oz = ray.oz;
        ChiSquareTest.ofDirections(
                        c.name(),
                        (u, v, w, d) -> {
                            camera.sampleRay(camera.width() * u, camera.height() * v, 0.3, 0.8, ray);
                            d[0] = ray.dx;
                            d[1] = ray.dy;
                            d[2] = ray.dz;
                            return true;
                        },
                        (x, y, z) -> camera.rayDensity(ox, oy, oz, x, y, z, ray) ? ray.densityDirection : 0)
                .cells(21, 21)
                .samples(50_000)
                .depth(5, 7)
                .assertAgrees(Significance.sidak(SIGNIFICANCE, cases().size()));
    }

    @Test
    void imageIsTheRightWayRound() {
        // Looking along +z with +y up, +x is on the left.
        PerspectiveCamera camera = new PerspectiveCamera(Transform.identity(), 1, 200, 100, 0, 0);
        CameraRay ray = new CameraRay();
        camera.sampleRay(0, 0, 0, 0, ray);
        double length = Math.sqrt(2.25);
        assertEquals(1 / length, ray.dx, 1e-15);
        assertEquals(0.5 / length, ray.dy, 1e-15);
        assertEquals(1 / length, ray.dz, 1e-15);
        LensSample lens = new LensSample();
        assertTrue(camera.sampleLens(0.5, 0.25, 1, 0, 0, lens));
        assertEquals(50, lens.filmX, 1e-12);
        assertEquals(25, lens.filmY, 1e-12);
        assertFalse(camera.sampleLens(0.5, 0.25, -1, 0, 0, lens), "behind");
        assertFalse(camera.sampleLens(1.01, 0.25, 1, 0, 0, lens), "left of the film");
        assertFalse(camera.sampleLens(0, 0, 0, 0, 0, lens), "at the pinhole");
        assertFalse(camera.rayDensity(0, 0, 0, 0, 0, -1, ray));
        // A mirror image has +x on the right.
        PerspectiveCamera mirrored = new PerspectiveCamera(Transform.scale(-1, 1, 1), 1, 200, 100, 0, 0);
        assertTrue(mirrored.sampleLens(0.5, 0.25, 1, 0, 0, lens));
        assertEquals(150, lens.filmX, 1e-12);
    }

    /** A ray along the line to a point of the lens hits it there; one to a point beyond its rim, or from behind, does not. */
    @ParameterizedTest
    @MethodSource("cases")
    void raysHitTheLensWhereItIs(CameraTest.Case c) {
        Camera camera = c.camera();
        CameraRay ray = new CameraRay();
        LensSample expected = new LensSample();
        LensSample actual = new LensSample();
        RandomStream random = new RandomStream(5, StreamDomain.SELF_CHECK, 0, 0);
        for (int i = 0; i < 1000; i++) {
            double u = random.nextDouble();
            double v = random.nextDouble();
            camera.sampleRay(camera.width() * random.nextDouble(), camera.height() * random.nextDouble(), u, v, ray);
            double distance = 0.1 + 3 * random.nextDouble();
            double px = ray.ox + distance * ray.dx;
            double py = ray.oy + distance * ray.dy;
            double pz = ray.oz + distance * ray.dz;
            assertFalse(camera.hitLens(px, py, pz, ray.dx, ray.dy, ray.dz, actual), "away from the lens");
            assertFalse(
                    camera.hitLens(
                            ray.ox - distance * ray.dx,
                            ray.oy - distance * ray.dy,
                            ray.oz - distance * ray.dz,
                            ray.dx,
                            ray.dy,
                            ray.dz,
                            actual),
                    "from behind");
            boolean hit = camera.hitLens(px, py, pz, -ray.dx, -ray.dy, -ray.dz, actual);
            assertEquals(camera.hasLensArea(), hit);
            if (!hit) {
                continue;
            }
            assertTrue(camera.sampleLens(px, py, pz, u, v, expected));
            assertEquals(expected.filmX, actual.filmX, 1e-9);
            assertEquals(expected.filmY, actual.filmY, 1e-9);
            assertEquals(expected.distance, actual.distance, 1e-9);
            assertEquals(expected.weight, actual.weight, 1e-9 * expected.weight);
            assertEquals(expected.density, actual.density, 1e-9 * expected.density);
            assertEquals(expected.densityPosition, actual.densityPosition);
            assertEquals(expected.point.x, actual.point.x, 1e-9);
            assertEquals(ray.densityPosition, actual.densityPosition);
            assertEquals(ray.normalX, actual.point.gx);
        }
    }

    /** Parallel rays through points of a square around the lens: the hits have its area, within five standard deviations. */
    @Test
    void theLensIsAsLargeAsItsDensitySays() {
        PerspectiveCamera camera = new PerspectiveCamera(Transform.identity(), 0.6, 40, 25, 0.3, 2.5);
        LensSample lens = new LensSample();
        int hits = 0;
        int n = 20_000;
        RandomStream random = new RandomStream(7, StreamDomain.SELF_CHECK, 0, 0);
        for (int i = 0; i < n; i++) {
            double x = random.nextDouble() - 0.5;
            double y = random.nextDouble() - 0.5;
            hits += camera.hitLens(x + 0.02, y, 2, -0.01 / Math.sqrt(1.0001), 0, -1 / Math.sqrt(1.0001), lens) ? 1 : 0;
        }
        double expected = n / lens.densityPosition;
        assertEquals(expected, hits, 5 * Math.sqrt(expected));
    }

    @Test
    void lensesFocusAtTheirDistance() {
        for (double scale : new double[] {1, 7}) {
            Transform map = PLACE.multiply(Transform.scale(scale, scale, scale));
            PerspectiveCamera camera = new PerspectiveCamera(map, 0.6, 40, 25, 0.3, 2.5);
            CameraRay ray = new CameraRay();
            camera.sampleRay(31, 7, 0.5, 0.5, ray);
            // The view direction of the film's centre gives the depth.
            CameraRay axis = new CameraRay();
            camera.sampleRay(20, 12.5, 0.5, 0.5, axis);
            double t = 2.5 / (ray.dx * axis.dx + ray.dy * axis.dy + ray.dz * axis.dz);
            double fx = ray.ox + t * ray.dx;
            double fy = ray.oy + t * ray.dy;
            double fz = ray.oz + t * ray.dz;
            double widest = 0;
            RandomStream random = new RandomStream(3, StreamDomain.SELF_CHECK, 0, 0);
            for (int i = 0; i < 2000; i++) {
                camera.sampleRay(31, 7, random.nextDouble(), random.nextDouble(), ray);
                double dx = fx - ray.ox;
                double dy = fy - ray.oy;
                double dz = fz - ray.oz;
                double along = dx * ray.dx + dy * ray.dy + dz * ray.dz;
                double miss = dx * dx + dy * dy + dz * dz - along * along;
                assertEquals(0, miss, 1e-12, "all rays of a film position meet in focus");
                double ox = ray.ox - 1;
                double oy = ray.oy - 2;
                double oz = ray.oz - 3;
                widest = Math.max(widest, Math.sqrt(ox * ox + oy * oy + oz * oz));
            }
            assertTrue(widest <= 0.3 + 1e-12 && widest > 0.29, "radius " + widest);
        }
    }

    @Test
    void raysFromBesideTheLensHaveNoDensity() {
        PerspectiveCamera camera = new PerspectiveCamera(Transform.identity(), 1, 20, 10, 0.5, 2);
        CameraRay ray = new CameraRay();
        assertTrue(camera.rayDensity(0.49, 0, 0, 0, 0, 1, ray));
        assertEquals(1 / (Math.PI * 0.25), ray.densityPosition, 1e-12);
        assertFalse(camera.rayDensity(0.51, 0, 0, 0, 0, 1, ray));
    }

    @Test
    void openingAnglesOfAllAxes() {
        double angle = 40;
        double tan = Math.tan(Math.toRadians(20));
        assertEquals(tan, PerspectiveCamera.tanHalfWidth(angle, 300, 300), 1e-15);
        // 200 rows see 40°, so 300 columns see half as much again of the plane.
        assertEquals(1.5 * tan, PerspectiveCamera.tanHalfWidth(angle, 200, 300), 1e-15);
        PerspectiveCamera camera = new PerspectiveCamera(
                Transform.identity(), PerspectiveCamera.tanHalfWidth(angle, Math.hypot(300, 200), 300), 300, 200, 0, 0);
        CameraRay corner = new CameraRay();
        CameraRay opposite = new CameraRay();
        camera.sampleRay(0, 0, 0, 0, corner);
        camera.sampleRay(300, 200, 0, 0, opposite);
        double cosine = corner.dx * opposite.dx + corner.dy * opposite.dy + corner.dz * opposite.dz;
        assertEquals(angle, Math.toDegrees(Math.acos(cosine)), 1e-12);
    }

    @Test
    void badNumbersAreRefused() {
        assertRefused(0, 10, 10, 0, 1, "opening angle");
        assertRefused(Double.NaN, 10, 10, 0, 1, "opening angle");
        assertRefused(1, 0, 10, 0, 1, "width");
        assertRefused(1, 10, -1, 0, 1, "height");
        assertRefused(1, 10, 10, -1, 1, "aperture");
        assertRefused(1, 10, 10, 1, 0, "focus");
    }

    @Test
    void samplingAllocatesNothing() {
        com.sun.management.ThreadMXBean threads = (com.sun.management.ThreadMXBean) ManagementFactory.getThreadMXBean();
        Camera camera = new PerspectiveCamera(PLACE, 0.6, 40, 25, 0.3, 2);
        CameraRay ray = new CameraRay();
        LensSample lens = new LensSample();
        long before = 0;
        for (int i = 0; i < 40_000; i++) {
            if (i == 20_000) {
                before = threads.getCurrentThreadAllocatedBytes();
            }
            camera.sampleRay(i % 40, i % 25, 0.3, 0.7, ray);
            camera.sampleLens(ray.ox + ray.dx, ray.oy + ray.dy, ray.oz + ray.dz, 0.1, 0.9, lens);
            camera.rayDensity(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, ray);
        }
        long bytes = threads.getCurrentThreadAllocatedBytes() - before;
        assertTrue(bytes < 2000, bytes + " bytes");
    }

    private static void assertRefused(double tan, int width, int height, double aperture, double focus, String part) {
        IllegalArgumentException e = assertThrows(
                IllegalArgumentException.class,
                () -> new PerspectiveCamera(Transform.identity(), tan, width, height, aperture, focus));
        assertTrue(e.getMessage().contains(part), e.getMessage());
    }
}
