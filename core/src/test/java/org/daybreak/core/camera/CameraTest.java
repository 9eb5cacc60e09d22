package org.daybreak.core.camera;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.Significance;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What all kinds of cameras must fulfil: rays from the film and connections to the lens agree. */
class CameraTest {
    /** False-alarm rate of each kind of test here, over all its cases. */
    private static final double SIGNIFICANCE = 1e-4;

    static final Transform PLACE = Transform.lookAt(1, 2, 3, -1, 1.5, 0.5, 0.1, 1, 0);
    static final Transform SHEAR = Transform.ofRows(1.1, 0.5, 0.2, 0.1, -0.3, 0.8, 0.4, 0.2, 0.1, -0.2, 0.6, -0.4);

    /**
     * A camera.
     *
     * @param rounding how many times the rounding errors of perspective cameras are allowed
     */
    record Case(String name, Camera camera, double rounding) {
        @Override
        public String toString() {
            return name;
        }
    }

    static List<Case> cases() {
        return List.of(
                new Case("pinhole", new PerspectiveCamera(PLACE, 0.6, 40, 25, 0, 0), 1),
                new Case("wide pinhole", new PerspectiveCamera(PLACE, 3, 30, 40, 0, 0), 1),
                new Case("lens", new PerspectiveCamera(PLACE, 0.6, 40, 25, 0.3, 2), 1),
                new Case(
                        "mirrored and scaled lens",
                        new PerspectiveCamera(PLACE.multiply(Transform.scale(-5, 5, 5)), 1.2, 30, 40, 0.5, 1.5),
                        1),
                new Case("shifted film", new PerspectiveCamera(PLACE, 0.6, 0.4, 40, 25, 0, 0, 0.3, -0.2), 1),
                new Case("flat pixels", new PerspectiveCamera(PLACE, 0.6, 0.2, 40, 25, 0.3, 2, -0.1, 0.2), 1),
                new Case("sheared pinhole", new PerspectiveCamera(SHEAR, 0.8, 40, 25, 0, 0), 1),
                new Case("sheared lens", new PerspectiveCamera(SHEAR, 0.8, 40, 25, 0.3, 2), 1),
                new Case("orthographic", new OrthographicCamera(PLACE, 40, 25, 1), 10),
                new Case(
                        "scaled and mirrored orthographic",
                        new OrthographicCamera(PLACE.multiply(Transform.scale(-2, 1.5, 3)), 30, 40, 0.7),
                        10),
                new Case("sheared orthographic", new OrthographicCamera(SHEAR, 40, 25, 1), 10),
                // The density of the panorama has a pole where its sine cancels.
                new Case("environment", new EnvironmentCamera(PLACE, 40, 20), 1000),
                new Case(
                        "mirrored environment",
                        new EnvironmentCamera(PLACE.multiply(Transform.scale(1, 1, -1)), 30, 40),
                        1000));
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
            double u = random.nextDouble();
            double v = random.nextDouble();
            assertTrue(camera.sampleRay(filmX, filmY, u, v, ray));
            assertEquals(1, Math.sqrt(ray.dx * ray.dx + ray.dy * ray.dy + ray.dz * ray.dz), 1e-14);
            assertEquals(1, ray.weight);
            assertTrue(camera.rayDensity(ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, again));
            assertEquals(ray.densityPosition, again.densityPosition, 1e-12 * ray.densityPosition);
            assertEquals(ray.densityDirection, again.densityDirection, c.rounding() * 1e-11 * ray.densityDirection);
            double distance = 0.1 + 10 * random.nextDouble();
            double px = ray.ox + distance * ray.dx;
            double py = ray.oy + distance * ray.dy;
            double pz = ray.oz + distance * ray.dz;
            assertTrue(camera.sampleLens(px, py, pz, u, v, lens));
            double film = Math.min(10, c.rounding()) * 1e-9;
            assertEquals(filmX, lens.filmX, film);
            assertEquals(filmY, lens.filmY, film);
            double place = Math.min(10, c.rounding()) * 1e-12;
            assertEquals(distance, lens.distance, Math.min(1e-11, place * distance));
            assertEquals(-ray.dx, lens.wiX, place);
            assertEquals(ray.ox, lens.point.x, place);
            assertEquals(ray.oz, lens.point.z, place);
            assertEquals(!camera.hasLensArea(), lens.delta);
            double cosine = lens.point.geometricCosine(ray.dx, ray.dy, ray.dz);
            assertTrue(cosine > 0);
            double density = lens.delta ? 1 : ray.densityPosition * distance * distance / cosine;
            assertEquals(density, lens.density, 1e-10 * density);
            // The importance is the ray density times the number of pixels; the lens density is measured over the view.
            double perPixel = camera.width() * camera.height() * ray.densityDirection;
            double weight =
                    camera.isParallel() ? perPixel * ray.densityPosition / cosine : perPixel / (distance * distance);
            assertEquals(weight, lens.weight, Math.min(100, c.rounding()) * 1e-10 * weight);
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
}
