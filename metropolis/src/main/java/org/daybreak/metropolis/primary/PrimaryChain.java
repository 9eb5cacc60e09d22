package org.daybreak.metropolis.primary;

import org.daybreak.metropolis.chains.Chain;
import org.daybreak.metropolis.chains.StateReader;
import org.daybreak.metropolis.chains.StateWriter;

/** A chain whose state is a vector of numbers. */
final class PrimaryChain extends Chain {
    /** The state, and what is proposed. */
    final PrimarySample numbers;

    /** What the state brings to the image. */
    StateImage image = new StateImage();

    /** Number of edges that all paths of this chain have; 0 if they may have any. */
    int edges;

    PrimaryChain(long seed, int number, SmallStep step) {
        super(seed, number);
        numbers = new PrimarySample(step);
    }

    @Override
    protected void saveState(StateWriter out) {
        out.put((long) edges);
        numbers.save(out);
        image.save(out);
    }

    @Override
    protected void loadState(StateReader in) {
        edges = in.nextInt();
        numbers.load(in);
        image.load(in);
    }
}
