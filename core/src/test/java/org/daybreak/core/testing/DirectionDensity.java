package org.daybreak.core.testing;

/** Density of a random direction per solid angle. */
@FunctionalInterface
public interface DirectionDensity {
    /** The density at a unit vector; the discrete part of the distribution is not included. */
    double density(double x, double y, double z);
}
