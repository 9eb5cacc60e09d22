package org.daybreak.core.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

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

/** Orthographic and environment cameras. */
class OtherCamerasTest {
    /** False-alarm rate of each kind of test here, over all its cases. */
    private static final double SIGNIFICANCE = 1e-4;

    private static final Transform PLACE = Transform.lookAt(1, 2, 3, -1, 1.5, 0.5, 0.1, 1, 0);

    record Case(String name, Camera camera) {
        @Override
        public String toString() {
            return name;
        }
    }

    static List<Case> cases() {
        Transform shear = Transform.ofRows(1.1, 0.5, 0.2, 0.1, -0.3, 0.8, 0.4, 0.2, 0.1, -0.2, 0.6, -0.4);
        return List.of(
                new Case("orthographic", new OrthographicCamera(PLACE, 40, 25, 1)),
                new Case(
                        "scaled and mirrored orthographic",
                        new OrthographicCamera(PLACE.multiply(Transform.scale(-2, 1.5, 3)), 30, 40, 0.7)),
                new Case("sheared orthographic", new OrthographicCamera(shear, 40, 25, 1)),
                new Case("environment", new EnvironmentCamera(PLACE, 40, 20)),
                new Case(
                        "mirrored environment",
                        new EnvironmentCamera(PLACE.multiply(Transform.scale(1, 1, -1)), 30, 40)));
    }

    @ParameterizedTest
    @MethodSource("cases")
    void filmPositionsAreFoundAgain(Case c) {
        Camera camera = c.camera();
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        CameraRay ray = new CameraRay();
        CameraRay again = new CameraRay();
        LensSample lens = new LensSample();
        for (int i = 0; i < 5000; i++) {
            double filmX = camera.width() * random.nextDouble();
            double filmY = camera.height() * random.nextDouble();
            assertTrue(camera.sampleRay(filmX, filmY, 0.5, 0.5, ray));
            assertEquals(1, Math.sqrt(ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz), 1e-14);
            assertEquals(1, ray.weight);
            assertTrue(camera.rayDensity(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, again));
            assertEquals(ray.densityPosition, again.densityPosition, 1e-12 * ray.densityPosition);
            // The density of the panorama has a pole where its sine cancels.
            assertEquals(ray.densityDirection, again.densityDirection, 1e-8 * ray.densityDirection);
            double distance = 0.1 + 10 * random.nextDouble();
            double px = ray.ox + distance * ray.dx;
            double py = ray.oy + distance * ray.dy;
            double pz = ray.oz + distance * ray.dz;
            assertTrue(camera.sampleLens(px, py, pz, 0.5, 0.5, lens));
            assertEquals(filmX, lens.filmX, 1e-8);
            assertEquals(filmY, lens.filmY, 1e-8);
            assertEquals(distance, lens.distance, 1e-11);
            assertEquals(-ray.dx, lens.wiX, 1e-11);
            assertEquals(ray.ox, lens.point.x, 1e-11);
            assertEquals(ray.oz, lens.point.z, 1e-11);
            assertTrue(lens.delta && !camera.hasLensArea());
            assertEquals(1, lens.density);
            assertTrue(lens.point.geometricCosine(ray.dx, ray.dy, ray.dz) > 0);
            double filmDensity = camera.width() * camera.height() * ray.densityPosition * ray.densityDirection;
            double weight = camera.isParallel()
                    ? filmDensity / lens.point.geometricCosine(ray.dx, ray.dy, ray.dz)
                    : filmDensity / (distance * distance);
            assertEquals(weight, lens.weight, 1e-8 * weight);
        }
    }

    /** A pixel's light-traced value of a sphere of unit radiance is its path-traced one: both measure mean radiance. */
    @ParameterizedTest
    @MethodSource("cases")
    void bothDirectionsMeasureTheSame(Case c) {
        Camera camera = c.camera();
        RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
        CameraRay ray = new CameraRay();
        LensSample lens = new LensSample();
        camera.sampleRay(0.6 * camera.width(), 0.45 * camera.height(), 0.5, 0.5, ray);
        double cx = ray.ox + 2 * ray.dx;
        double cy = ray.oy + 2 * ray.dy;
        double cz = ray.oz + 2 * ray.dz;
        double radius = 0.5;
        Moments fromEye = new Moments();
        Moments fromLight = new Moments();
        for (int i = 0; i < 40_000; i++) {
            camera.sampleRay(
                    camera.width() * random.nextDouble(), camera.height() * random.nextDouble(), 0.5, 0.5, ray);
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
            if (camera.sampleLens(cx + radius * nx, cy + radius * ny, cz + radius * nz, 0.5, 0.5, lens)) {
                double cosine = lens.wiX * nx + lens.wiY * ny + lens.wiZ * nz;
                splat = Math.max(0, cosine) * lens.weight * 4 * Math.PI * radius * radius;
            }
            fromLight.add(splat);
        }
        ZTest.assertNotRejected(
                c.name(), ZTest.twoSample(fromEye, fromLight), Significance.sidak(SIGNIFICANCE, cases().size()));
    }

    @Test
    void panoramasFollowTheirDensity() {
        Camera camera = new EnvironmentCamera(PLACE, 40, 20);
        CameraRay ray = new CameraRay();
        ChiSquareTest.ofDirections(
                        "environment",
                        (u, v, w, d) -> {
                            camera.sampleRay(40 * u, 20 * v, 0.5, 0.5, ray);
                            d[0] = ray.dx;
                            d[1] = ray.dy;
                            d[2] = ray.dz;
                            return true;
                        },
                        (x, y, z) -> camera.rayDensity(1, 2, 3, x, y, z, ray) ? ray.densityDirection : 0)
                .cells(21, 11)
                .samples(50_000)
                .depth(3, 13)
                .assertAgrees(SIGNIFICANCE);
    }

    @Test
    void otherRaysAreNotOfAnOrthographicCamera() {
        Camera camera = new OrthographicCamera(PLACE, 40, 25, 1);
        CameraRay ray = new CameraRay();
        camera.sampleRay(3, 4, 0.5, 0.5, ray);
        double[] o = {ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz};
        assertFalse(camera.rayDensity(o[0], o[1], o[2], -o[3], -o[4], -o[5], ray));
        assertFalse(camera.rayDensity(o[0], o[1], o[2], o[4], -o[3], 0, ray));
        assertFalse(camera.rayDensity(o[0] + 5, o[1] + 5, o[2], o[3], o[4], o[5], ray));
        assertFalse(camera.sampleLens(o[0] - o[3], o[1] - o[4], o[2] - o[5], 0.5, 0.5, new LensSample()));
    }

    @Test
    void badNumbersAreRefused() {
        for (double aspect : new double[] {0, -1, Double.NaN, Double.POSITIVE_INFINITY}) {
            assertThrows(IllegalArgumentException.class, () -> new OrthographicCamera(PLACE, 40, 25, aspect));
        }
        assertThrows(IllegalArgumentException.class, () -> new OrthographicCamera(PLACE, 0, 25, 1));
        assertThrows(IllegalArgumentException.class, () -> new EnvironmentCamera(PLACE, 2, 0));
        assertThrows(IllegalArgumentException.class, () -> new EnvironmentCamera(Transform.scale(2, 2, 2), 40, 20));
        assertThrows(
                IllegalArgumentException.class, () -> new PerspectiveCamera(PLACE, 1, 1, 4, 4, 0, 0, Double.NaN, 0));
    }
}
