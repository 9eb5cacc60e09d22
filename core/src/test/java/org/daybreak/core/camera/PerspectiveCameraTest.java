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
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.Significance;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class PerspectiveCameraTest {
    /** False-alarm rate of each kind of test here, over all its cases. */
    private static final double SIGNIFICANCE = 1e-4;

    private static final Transform PLACE = Transform.lookAt(1, 2, 3, -1, 1.5, 0.5, 0.1, 1, 0);

    record Case(String name, PerspectiveCamera camera) {
        @Override
        public String toString() {
            return name;
        }
    }

    static List<Case> cases() {
        Transform shear = Transform.ofRows(1.1, 0.5, 0.2, 0.1, -0.3, 0.8, 0.4, 0.2, 0.1, -0.2, 0.6, -0.4);
        return List.of(
                new Case("pinhole", new PerspectiveCamera(PLACE, 0.6, 40, 25, 0, 0)),
                new Case("wide pinhole", new PerspectiveCamera(PLACE, 3, 30, 40, 0, 0)),
                new Case("lens", new PerspectiveCamera(PLACE, 0.6, 40, 25, 0.3, 2)),
                new Case(
                        "mirrored and scaled lens",
                        new PerspectiveCamera(PLACE.multiply(Transform.scale(-5, 5, 5)), 1.2, 30, 40, 0.5, 1.5)),
                new Case("shifted film", new PerspectiveCamera(PLACE, 0.6, 0.4, 40, 25, 0, 0, 0.3, -0.2)),
                new Case("flat pixels", new PerspectiveCamera(PLACE, 0.6, 0.2, 40, 25, 0.3, 2, -0.1, 0.2)),
                new Case("sheared pinhole", new PerspectiveCamera(shear, 0.8, 40, 25, 0, 0)),
                new Case("sheared lens", new PerspectiveCamera(shear, 0.8, 40, 25, 0.3, 2)));
    }

    @ParameterizedTest
    @MethodSource("cases")
    void filmPositionsAreFoundAgain(Case c) {
        PerspectiveCamera camera = c.camera();
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        CameraRay ray = new CameraRay();
        CameraRay again = new CameraRay();
        LensSample lens = new LensSample();
        for (int i = 0; i < 5000; i++) {
            double filmX = camera.width() * random.nextDouble();
            double filmY = camera.height() * random.nextDouble();
            double u = random.nextDouble();
            double v = random.nextDouble();
            assertTrue(camera.sampleRay(filmX, filmY, u, v, ray));
            assertEquals(1, Math.sqrt(ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz), 1e-14);
            assertEquals(1, ray.weight);
            assertTrue(camera.rayDensity(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, again));
            assertEquals(ray.densityPosition, again.densityPosition, 1e-12 * ray.densityPosition);
            assertEquals(ray.densityDirection, again.densityDirection, 1e-11 * ray.densityDirection);
            double distance = 0.1 + 10 * random.nextDouble();
            double px = ray.ox + distance * ray.dx;
            double py = ray.oy + distance * ray.dy;
            double pz = ray.oz + distance * ray.dz;
            assertTrue(camera.sampleLens(px, py, pz, u, v, lens));
            assertEquals(filmX, lens.filmX, 1e-9);
            assertEquals(filmY, lens.filmY, 1e-9);
            assertEquals(distance, lens.distance, 1e-12 * distance);
            assertEquals(-ray.dx, lens.wiX, 1e-12);
            assertEquals(ray.ox, lens.point.x, 1e-12);
            assertEquals(!camera.hasLensArea(), lens.delta);
            // The importance is the ray density times the number of pixels; the lens density is measured over the view.
            double filmPerSolidAngle = ray.densityDirection * camera.width() * camera.height();
            double weight = filmPerSolidAngle / (distance * distance);
            assertEquals(weight, lens.weight, 1e-10 * weight);
            double cosine = lens.point.geometricCosine(ray.dx, ray.dy, ray.dz);
            assertTrue(cosine > 0);
            double density = lens.delta ? 1 : ray.densityPosition * distance * distance / cosine;
            assertEquals(density, lens.density, 1e-10 * density);
        }
    }

    @ParameterizedTest
    @MethodSource("cases")
    void directionsFollowTheirDensity(Case c) {
        PerspectiveCamera camera = c.camera();
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

    /** A pixel's light-traced value of a bright distant patch is its path-traced one: both measure mean radiance. */
    @ParameterizedTest
    @MethodSource("cases")
    void bothDirectionsMeasureTheSame(Case c) {
        PerspectiveCamera camera = c.camera();
        RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
        CameraRay ray = new CameraRay();
        LensSample lens = new LensSample();
        // A sphere of unit radiance in front of the camera, over the whole film.
        camera.sampleRay(0.6 * camera.width(), 0.45 * camera.height(), 0.5, 0.5, ray);
        double cx = ray.ox + 4 * ray.dx;
        double cy = ray.oy + 4 * ray.dy;
        double cz = ray.oz + 4 * ray.dz;
        double radius = 0.7;
        Moments fromEye = new Moments();
        Moments fromLight = new Moments();
        for (int i = 0; i < 40_000; i++) {
            camera.sampleRay(
                    camera.width() * random.nextDouble(),
                    camera.height() * random.nextDouble(),
                    random.nextDouble(),
                    random.nextDouble(),
                    ray);
            double dx = cx - ray.ox;
            double dy = cy - ray.oy;
            double dz = cz - ray.oz;
            double along = dx * ray.dx + dy * ray.dy + dz * ray.dz;
            boolean hit = along > 0 && dx * dx + dy * dy + dz * dz - along * along < radius * radius;
            fromEye.add(hit ? (double) camera.width() * camera.height() : 0);
            double nz = 2 * random.nextDouble() - 1;
            double phi = 2 * Math.PI * random.nextDouble();
            double nx = Math.sqrt(1 - nz * nz) * Math.cos(phi);
            double ny = Math.sqrt(1 - nz * nz) * Math.sin(phi);
            double splat = 0;
            if (camera.sampleLens(
                    cx + radius * nx,
                    cy + radius * ny,
                    cz + radius * nz,
                    random.nextDouble(),
                    random.nextDouble(),
                    lens)) {
                double cosine = nx * lens.wiX + ny * lens.wiY + nz * lens.wiZ;
                splat = Math.max(0, cosine) * lens.weight * 4 * Math.PI * radius * radius;
            }
            fromLight.add(splat);
        }
        ZTest.assertNotRejected(
                c.name(), ZTest.twoSample(fromEye, fromLight), Significance.sidak(SIGNIFICANCE, cases().size()));
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
        PerspectiveCamera camera = cases().get(2).camera();
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
