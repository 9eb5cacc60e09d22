package org.daybreak.metropolis.chains;

import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.scene.RayKind;

/**
 * Draws candidates for first states and moves chains. One object per thread; all workers of a render do the same with the same
 * arguments.
 *
 * <p>The scalar contribution f* of a state is the luminance of what it brings to the image, relative to the film: ∫ f* is the mean
 * luminance of the image. The density of chains is f*·v/b with the factor v of {@link ImageImportance} and b = ∫ f*·v.
 */
public interface ChainWorker {
    /** Told of the states that a candidate offers. */
    @FunctionalInterface
    interface Candidates {
        /**
         * A state that a chain may start from.
         *
         * @param number counts the states of this candidate from 0
         * @param filmX where it is on the film, in pixels; of several positions any
         * @param weight w·f*·v/p: the expectation of the sum over all states of a candidate is b
         */
        void found(int number, double filmX, double filmY, double weight);
    }

    /** Sets the factor on the target from now on; 1 everywhere before. */
    void setImportance(ImageImportance importance);

    /** Draws a candidate; its random numbers are those of its index in {@code StreamDomain.BOOTSTRAP}. */
    void candidate(long index, Candidates found);

    /** A chain that is nowhere yet. */
    Chain newChain(int number);

    /**
     * Puts a chain on a state: draws the candidate again and takes the state with a number.
     *
     * @param index of the candidate
     * @param number of the state
     */
    void start(Chain chain, long index, int number);

    /**
     * Moves a chain. Each step splats (1−a)·f/(f*·v) at the old state and a·f/(f*·v) at the new one, or f/(f*·v) of the state after
     * the step: the image is the sum of the splats times b times the number of pixels over that of steps.
     *
     * @param statistics adds up what happened
     */
    void advance(Chain chain, long steps, SplatBuffer splats, ChainStatistics statistics);

    /** Number of rays of a kind traced so far. */
    long rays(RayKind kind);
}
