package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** A sampled point of a light as seen from a reference point (next-event estimation). Mutable, owned by one worker. */
public final class LightSample {
    /** Unit direction from the reference point to the light. */
    public double wiX;

    public double wiY;
    public double wiZ;

    /** Distance to the light point; positive infinity for lights at infinity. */
    public double distance;

    /**
     * Incident contribution divided by density: {@code L(wi)/pdf(wi)}; for delta lights the irradiance on a surface
     * facing the light (for a point light I/d²). Multiply with {@code f·|cos θ_i|} and visibility.
     */
    public final Spectrum weight = new Spectrum();

    /** Density per solid angle at the reference point; 1 for delta lights, which no scattering direction can hit. */
    public double density;

    /** True if the light cannot be hit by a sampled direction: the weight of this technique is then 1. */
    public boolean delta;

    /**
     * The point on the light. For lights at infinity only the geometric normal is meaningful (it points along the
     * light's travel direction); for point lights only the position is.
     */
    public final SurfacePoint point = new SurfacePoint();

    /** Room for intermediate results of the lights, so that they need not allocate. */
    final double[] scratch = new double[3];
}
