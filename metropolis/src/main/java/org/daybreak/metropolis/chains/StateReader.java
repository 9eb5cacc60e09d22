package org.daybreak.metropolis.chains;

import org.daybreak.core.render.ParameterException;

/** Gives back what a {@link StateWriter} has taken, in the same order. */
public final class StateReader {
    private final long[] values;
    private int next;

    /** Creates a reader. */
    public StateReader(long[] values) {
        this.values = values;
    }

    /**
     * The next number.
     *
     * @throws ParameterException if there is none: the state is another renderer's
     */
    public long next() {
        if (next == values.length) {
            throw new ParameterException("the state to go on from does not belong to this renderer: it is too short");
        }
        return values[next++];
    }

    /**
     * A count of numbers to come.
     *
     * @throws ParameterException if there are not so many: the state is another renderer's
     */
    int checkCount(long count) {
        if (count < 0 || count > values.length - next) {
            throw new ParameterException("the state to go on from does not belong to this renderer: it is too short");
        }
        return (int) count;
    }

    /** The next number, as bits of a double. */
    public double nextDouble() {
        return Double.longBitsToDouble(next());
    }

    /** The next number as an int. */
    public int nextInt() {
        return (int) next();
    }
}
