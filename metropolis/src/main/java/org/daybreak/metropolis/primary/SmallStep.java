package org.daybreak.metropolis.primary;

import org.daybreak.core.render.ParameterException;

/**
 * How a small step changes a number: by ±s₂·(s₁/s₂)^ξ on the circle of circumference 1, ξ uniform in [0,1) (Kelemen et
 * al. 2002). Steps of all sizes between both bounds are equally likely on a logarithmic scale. The law is symmetric, so that uniform
 * numbers stay uniform. Immutable.
 */
final class SmallStep {
    private final double largest;
    private final double logRatio;

    /**
     * Creates a law.
     *
     * @param smallest s₁, positive
     * @param largest s₂, less than 1
     * @throws ParameterException if the smallest change is larger than the largest one
     */
    SmallStep(double smallest, double largest) {
        if (smallest > largest) {
            throw new ParameterException("parameter '" + PrimarySettings.SMALLEST_STEP + "' is '" + smallest
                    + "' but must be at most '" + PrimarySettings.LARGEST_STEP + "', which is '" + largest + "'");
        }
        this.largest = largest;
        logRatio = Math.log(smallest / largest);
    }

    /**
     * Changes a number.
     *
     * @param value in [0,1)
     * @param u uniform number in [0,1)
     * @return in [0,1)
     */
    double move(double value, double u) {
        boolean up = u < 0.5;
        double change = largest * Math.exp(logRatio * (up ? 2 * u : 2 * u - 1));
        double moved = up ? value + change : value - change;
        if (moved < 0) {
            moved++;
        }
        // A tiny negative number plus 1 is 1.
        return moved >= 1 ? moved - 1 : moved;
    }
}
