package org.daybreak.core.render;

/**
 * State of a running render.
 *
 * @param fraction part of the budget spent, in [0,1]
 * @param samples image samples (or light subpaths) taken so far
 * @param samplesPerSecond rate since rendering began
 * @param secondsElapsed wall-clock seconds since rendering began
 * @param secondsLeft estimate of what remains; NaN if unknown
 * @param relativeError estimate of the image's relative standard error; NaN if unknown
 */
public record Progress(
        double fraction,
        long samples,
        double samplesPerSecond,
        double secondsElapsed,
        double secondsLeft,
        double relativeError) {}
