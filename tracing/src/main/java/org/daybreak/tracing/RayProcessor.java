package org.daybreak.tracing;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;

/**
 * The mathematics of one image sample: computes the radiance that arrives at a film position (the thesis' "ray processor").
 * One object per worker; it keeps scratch space, but no state from sample to sample that would change the image.
 */
public interface RayProcessor {
    /**
     * A work unit begins: samples that are always computed one after the other by one processor, whatever the number of threads.
     * What a processor learns from samples it may keep until the next call only.
     */
    default void beginUnit() {}

    /**
     * Computes one sample.
     *
     * @param filmX film position in pixels
     * @param sampler started at the sample, its next dimension is {@link Dimensions#FIRST_DIRECT}: the first two were the position in
     *     the pixel
     * @param out receives the radiance and, if asked for, the features
     * @param splats receives contributions to other film positions, for algorithms that find some ({@link Factory#splats})
     * @return false if a splat was not finite and has been left out
     */
    boolean trace(double filmX, double filmY, Sampler sampler, RaySample out, SplatBuffer splats);

    /** Number of rays of a kind traced so far. */
    long rays(RayKind kind);

    /** Makes processors. */
    @FunctionalInterface
    interface Factory {
        /**
         * Makes a processor for one worker.
         *
         * @param features whether to fill {@link RaySample#features}
         */
        RayProcessor create(Scene scene, Camera camera, boolean features);

        /** Whether the processors find contributions to other film positions. */
        default boolean splats() {
            return false;
        }

        /** Whether the processors learn from the samples of a work unit, so that a sample depends on those before it there. */
        default boolean learns() {
            return false;
        }
    }
}
