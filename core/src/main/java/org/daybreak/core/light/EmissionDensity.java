package org.daybreak.core.light;

/** The two densities of an emitted ray. Mutable, owned by one worker. */
public final class EmissionDensity {
    /** Density of the origin per area on the light, or on the covering disk for lights at infinity. */
    public double position;

    /** Density of the direction per solid angle, given the origin. */
    public double direction;
}
