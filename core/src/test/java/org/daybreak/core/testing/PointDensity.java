package org.daybreak.core.testing;

/** Density of a random point of the plane per unit of area. */
@FunctionalInterface
public interface PointDensity {
    /** The density at a point; the discrete part of the distribution is not included. */
    double density(double x, double y);
}
