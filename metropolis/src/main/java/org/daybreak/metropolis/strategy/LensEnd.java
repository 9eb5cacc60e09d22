package org.daybreak.metropolis.strategy;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.camera.LensSample;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.scene.RayKind;
import org.daybreak.metropolis.chains.Outcome;

/**
 * Makes the end x_k of a {@link LightPath} on the lens: as the start of a walk from a film position, or joined to a
 * vertex that came from the light. One object per worker.
 */
final class LensEnd {
    private final Camera camera;
    private final EdgeTracer edges;
    private final Failure failure;
    private final CameraRay cameraRay = new CameraRay();
    private final LensSample lens = new LensSample();

    LensEnd(Camera camera, EdgeTracer edges, Failure failure) {
        this.camera = camera;
        this.edges = edges;
        this.failure = failure;
    }

    /** Draws a point on the lens. */
    void sample(LightPath y, RandomStream random) {
        y.lensU = random.nextDouble();
        y.lensV = random.nextDouble();
    }

    /**
     * Sets the lens and a film position, and traces to x_{k−1}; with k = 1 that may lie at infinity.
     *
     * @param k index of the lens
     */
    boolean look(LightPath y, int k, double filmX, double filmY, RandomStream random) {
        y.filmX = filmX;
        y.filmY = filmY;
        if (!camera.sampleRay(filmX, filmY, y.lensU, y.lensV, cameraRay)) {
            return failure.because(Outcome.OFF_FILM);
        }
        SurfacePoint z = y.points[k];
        z.x = cameraRay.ox;
        z.y = cameraRay.oy;
        z.z = cameraRay.oz;
        z.gx = cameraRay.dx;
        z.gy = cameraRay.dy;
        z.gz = cameraRay.dz;
        z.offset = 0;
        z.shape = -1;
        y.setEnd(k);
        y.dx[k - 1] = -cameraRay.dx;
        y.dy[k - 1] = -cameraRay.dy;
        y.dz[k - 1] = -cameraRay.dz;
        return edges.trace(y, k, k - 1, RayKind.CAMERA, random);
    }

    /**
     * Joins x_{k−1} to the point on the lens.
     *
     * @return false if that lies outside of the film
     */
    boolean aim(LightPath y, int k) {
        SurfacePoint p = y.points[k - 1];
        if (!camera.sampleLens(p.x, p.y, p.z, y.lensU, y.lensV, lens)) {
            return failure.because(Outcome.OFF_FILM);
        }
        y.points[k].set(lens.point);
        y.setEnd(k);
        y.filmX = lens.filmX;
        y.filmY = lens.filmY;
        return true;
    }
}
