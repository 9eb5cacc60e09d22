package org.daybreak.tracing;

import org.daybreak.core.camera.CameraRay;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.FilmFeatures;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.Bsdf;

/** What a {@link RayProcessor} finds for one image sample. Mutable, owned by one worker, reused. */
public final class RaySample {
    /** Radiance that arrives at the film position. */
    public final Spectrum radiance = new Spectrum();

    /** What the sample sees first; filled only if the processor was made to gather features. */
    public final FilmFeatures features = new FilmFeatures();

    /** What the sample brings to further images; of no use if the render makes none. */
    public final FurtherValues further;

    /** Creates an empty sample of a render without further images. */
    public RaySample() {
        this(0);
    }

    /** Creates an empty sample of a render with a number of further images. */
    RaySample(int furtherImages) {
        further = new FurtherValues(furtherImages);
    }

    /**
     * Fills the features with a surface that a camera ray meets.
     *
     * @param ray the camera ray; the point lies on it, possibly behind surfaces that it went straight through
     */
    public void setFeatures(Bsdf bsdf, SurfacePoint p, CameraRay ray) {
        features.hit = true;
        bsdf.albedo(p, features.albedo);
        features.nx = p.nx;
        features.ny = p.ny;
        features.nz = p.nz;
        features.depth = (p.x - ray.ox) * ray.dx + (p.y - ray.oy) * ray.dy + (p.z - ray.oz) * ray.dz;
    }
}
