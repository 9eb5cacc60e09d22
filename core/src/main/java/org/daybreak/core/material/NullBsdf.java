package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** No surface: everything passes straight through. For shapes that are lights only, or mark a place. */
public final class NullBsdf extends DeltaBsdf {
    /** Creates the material; all are alike. */
    public NullBsdf() {}

    @Override
    public boolean textured() {
        return false;
    }

    @Override
    public boolean choosesLobe() {
        return false;
    }

    @Override
    public double transparency(SurfacePoint point) {
        return 1;
    }

    @Override
    public boolean maybeTransparent() {
        return true;
    }

    @Override
    public boolean sample(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double u,
            double v,
            double w,
            TransportMode mode,
            BsdfSample out) {
        out.setPassThrough(woX, woY, woZ, 1);
        return true;
    }

    @Override
    public void albedo(SurfacePoint point, Spectrum out) {
        out.set(1);
    }
}
