package org.daybreak.core.render;

/**
 * When a render ends: at whichever comes first. Only a budget in samples alone is reproducible.
 *
 * @param samplesPerPixel samples per pixel; light subpaths per pixel for light tracing
 * @param seconds wall-clock seconds of rendering, infinite for no limit
 * @param targetError stop when the film's relative error estimate falls below this; 0 for never
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
