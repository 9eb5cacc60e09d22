package org.daybreak.metropolis.chains;

import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.RenderPart;

/**
 * Divides chains into lanes: what the chains of a lane bring is added up apart, and the film merges lanes in order. A
 * part of a render moves the chains of some lanes. Immutable.
 */
final class ChainLanes {
    /** Chains are divided into so many lanes, if the images of these have no more pixels than that together. */
    private static final int MOST_LANES = 16;

    private static final int LEAST_LANES = 4;
    private static final long PIXELS_OF_LANES = 1L << 24;

    private final int chains;
    private final int lanes;
    private final int first;
    private final int end;

    /**
     * Divides.
     *
     * @param chains number of chains of the whole render
     * @param pixels of the film
     * @param part that moves some of them
     */
    ChainLanes(int chains, long pixels, RenderPart part) {
        this.chains = chains;
        long fitting = Math.max(LEAST_LANES, Math.min(MOST_LANES, PIXELS_OF_LANES / pixels));
        lanes = (int) Math.min(chains, fitting);
        first = start(part.first(lanes));
        end = start(part.end(lanes));
    }

    /** Refuses more parts than lanes. */
    void check(RenderPart part, long pixels) {
        if (part.count() > lanes) {
            throw new ParameterException("what " + chains + " Markov chains bring to an image of " + pixels
                    + " pixels is added up in " + lanes + " lanes: it can be cut into at most so many parts, not "
                    + part.count());
        }
    }

    private int start(long lane) {
        return (int) (chains * lane / lanes);
    }

    /** Number of chains of the whole render. */
    int chains() {
        return chains;
    }

    /** The first chain that is moved here. */
    int first() {
        return first;
    }

    /** The chain after the last one. */
    int end() {
        return end;
    }

    /** Number of chains that are moved here. */
    int count() {
        return end - first;
    }

    /** The lane of a chain: the largest one that starts at or before it. */
    int laneOf(int chain) {
        return (int) ((lanes * (chain + 1L) - 1) / chains);
    }
}
