package org.daybreak.core.camera;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.daybreak.core.math.Transform;
import org.daybreak.core.testing.ChiSquareTest;
import org.junit.jupiter.api.Test;

/** Orthographic and environment cameras. */
class OtherCamerasTest {
    /** False-alarm rate of each kind of test here, over all its cases. */
    private static final double SIGNIFICANCE = 1e-4;

    private static final Transform PLACE = CameraTest.PLACE;

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
