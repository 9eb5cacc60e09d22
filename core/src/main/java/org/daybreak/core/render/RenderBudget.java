package org.daybreak.core.render;

/**
 * When a render ends: at whichever comes first. A budget in samples or a target error is reproducible, one in seconds is
 * not.
 *
 * <p>The target error is compared with {@link org.daybreak.core.film.Film#relativeError()} after each pass. An image that ends
 * by it is biased: it is more likely to end when the samples so far happen to agree. The bias is of the order of the target error
 * squared, and goes to zero faster than the error itself.
 *
 * @param samplesPerPixel samples per pixel; light subpaths per pixel for light tracing
 * @param seconds wall-clock seconds of rendering, infinite for no limit
 * @param targetError stop after the pass at which the film's relative error estimate is below this; 0 for never
 */
public record RenderBudget(long samplesPerPixel, double seconds, double targetError) {
    /** Checks the ranges. */
    public RenderBudget {
        if (samplesPerPixel < 1) {
            throw new ParameterException("samples per pixel must be at least 1 but are " + samplesPerPixel);
        }
        if (!(seconds > 0)) {
            throw new ParameterException("the time limit must be positive but is " + seconds + " s");
        }
        if (!(targetError >= 0)) {
            throw new ParameterException("the target error must not be negative but is " + targetError);
        }
    }

    /** A budget in samples alone. */
    public static RenderBudget samples(long samplesPerPixel) {
        return new RenderBudget(samplesPerPixel, Double.POSITIVE_INFINITY, 0);
    }

    /** A budget in time alone. */
    public static RenderBudget seconds(double seconds) {
        return new RenderBudget(Integer.MAX_VALUE, seconds, 0);
    }
}
