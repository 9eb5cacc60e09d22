package org.daybreak.core.testing;

/** Maps three uniform numbers to a random point of the plane. */
@FunctionalInterface
public interface PointSampler {
    /**
     * Samples a point.
     *
     * @param u uniform in [0, 1)
     * @param v uniform in [0, 1)
     * @param w uniform in [0, 1), for a choice between components
     * @param point receives x and y
     * @return false if there is no point, or one of a discrete distribution which the density does not describe
     */
    boolean sample(double u, double v, double w, double[] point);
}
