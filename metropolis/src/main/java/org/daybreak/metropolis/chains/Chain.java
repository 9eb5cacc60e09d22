package org.daybreak.metropolis.chains;

import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;

/**
 * A Markov chain: where it is, and its random numbers. Between two calls of its worker all of its state is here, so any worker
 * can take it on. Not thread-safe; one worker has it at a time.
 */
public abstract class Chain {
    /** Number of the chain among all of the render. */
    public final int number;

    /** The random numbers of this chain, and of no other. */
    public final RandomStream random = new RandomStream();

    /** Steps taken. */
    public long steps;

    /** Rejections since the last accepted proposal. */
    public long rejections;

    /** Creates a chain that is nowhere yet: {@link ChainWorker#start} puts it on a seed. */
    protected Chain(long seed, int number) {
        this.number = number;
        random.seat(seed, StreamDomain.CHAIN, number, 0);
    }

    /** Writes the state that the algorithm keeps. */
    protected abstract void saveState(StateWriter out);

    /** Reads what {@link #saveState} has written. */
    protected abstract void loadState(StateReader in);

    /** Writes all of the chain. */
    public final void save(StateWriter out) {
        out.put(random.position());
        out.put(steps);
        out.put(rejections);
        saveState(out);
    }

    /** Reads what {@link #save} has written: the chain goes on with the same bits. */
    public final void load(StateReader in) {
        random.skipTo(in.next());
        steps = in.next();
        rejections = in.next();
        loadState(in);
    }
}
