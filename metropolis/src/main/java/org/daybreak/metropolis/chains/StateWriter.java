package org.daybreak.metropolis.chains;

import java.util.Arrays;

/** Takes the state of chains as numbers, for checkpoints. */
public final class StateWriter {
    private long[] values = new long[1024];
    private int used;

    /** Creates an empty writer. */
    public StateWriter() {}

    /** Appends a number. */
    public void put(long value) {
        if (used == values.length) {
            values = Arrays.copyOf(values, 2 * used);
        }
        values[used++] = value;
    }

    /** Appends the bits of a number. */
    public void put(double value) {
        put(Double.doubleToRawLongBits(value));
    }

    /** All that was appended. */
    public long[] toArray() {
        return Arrays.copyOf(values, used);
    }
}
