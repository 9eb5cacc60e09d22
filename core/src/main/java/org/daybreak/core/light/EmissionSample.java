package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** A sampled ray leaving a light: the start of a light subpath. Mutable, owned by one worker. */
public final class EmissionSample {
    /** Origin on the light; for lights at infinity a point on a disk that covers the scene. */
    public final SurfacePoint point = new SurfacePoint();

    /** Unit direction of travel. */
    public double dx;

    public double dy;
    public double dz;

    /** {@code Le·|cos θ| / (densityPosition·densityDirection)} for this light alone; the choice of light comes on top. */
    public final Spectrum weight = new Spectrum();

    /** Density of the origin per area on the light (or on the covering disk); 1 where {@link #deltaPosition}. */
    public double densityPosition;

    /** Density of the direction per solid angle, given the origin; 1 where {@link #deltaDirection}. */
    public double densityDirection;

    /** The origin is a single point: the light cannot be hit. */
    public boolean deltaPosition;

    /** The direction is a single one. */
    public boolean deltaDirection;

    /** Room for intermediate results of the lights, so that they need not allocate. */
    final double[] scratch = new double[3];
}
