package org.daybreak.core.testing;

/** Maps three uniform numbers to a random direction. */
@FunctionalInterface
public interface DirectionSampler {
    /**
     * Samples a direction.
     *
     * @param u uniform in [0, 1)
     * @param v uniform in [0, 1)
     * @param w uniform in [0, 1), for a choice between components
     * @param direction receives a unit vector
     * @return false if there is no direction, or one of a discrete distribution which the density does not describe
     */
    boolean sample(double u, double v, double w, double[] direction);
}
