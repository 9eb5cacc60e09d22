package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** A material of delta lobes only: nothing to evaluate, nothing to connect to. */
abstract class DeltaBsdf implements Bsdf {
    /** Instead of the number of a lobe: the one that a random number chooses. */
    static final int CHOOSE = -1;

    @Override
    public final boolean connectable() {
        return false;
    }

    @Override
    public final double evaluate(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ,
            TransportMode mode,
            Spectrum value) {
        value.setZero();
        return 0;
    }

    @Override
    public final double density(
            SurfacePoint point,
            double woX,
            double woY,
            double woZ,
            double wiX,
            double wiY,
            double wiZ,
            TransportMode mode) {
        return 0;
    }
}
