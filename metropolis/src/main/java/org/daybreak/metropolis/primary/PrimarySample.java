package org.daybreak.metropolis.primary;

import java.util.Arrays;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.metropolis.chains.StateReader;
import org.daybreak.metropolis.chains.StateWriter;

/**
 * The numbers of a state, as a sampler: a point of the infinite-dimensional unit cube of which only the coordinates are known that
 * have been read (Kelemen et al. 2002). A proposal changes all of them; {@link #accept} makes it the state.
 *
 * <p>A coordinate is changed when it is read. Then it first catches up with the accepted small steps that it has missed, which
 * becomes part of the state whether or not the proposal in hand is accepted; so the state goes the very way that it would go if
 * all coordinates were changed in each step. Those not read since the last large step are uniform still, and are drawn when they are
 * needed.
 *
 * <p>Mutable, one for each chain. After warming up it allocates nothing.
 */
final class PrimarySample extends Sampler {
    private final SmallStep step;
    private RandomStream random = new RandomStream();

    /** The state, with what a small step proposes. */
    private Coordinates state = new Coordinates();

    /** What a large step proposes. */
    private Coordinates fresh = new Coordinates();

    /** Where numbers are read from that are drawn anew; null in a small step. */
    private Coordinates drawn = state;

    private boolean small;

    /** Number of accepted small steps since the last large one. */
    private long time;

    /** Counts proposals; those of a lifetime. */
    private long proposal;

    private int dimension;

    /** Creates a sample that must be {@linkplain #begin begun}. */
    PrimarySample(SmallStep step) {
        this.step = step;
    }

    /**
     * Forgets all: the numbers that are read from now on are drawn and are the state.
     *
     * @param source of random numbers
     */
    void begin(RandomStream source) {
        state.clear();
        time = 0;
        small = false;
        drawn = state;
        random = source;
        dimension = 0;
    }

    /**
     * Proposes another point: the numbers that are read from now on are its coordinates.
     *
     * @param large whether it is independent of the state
     * @param source of random numbers
     */
    void propose(boolean large, RandomStream source) {
        random = source;
        small = !large;
        dimension = 0;
        proposal++;
        if (large) {
            fresh.clear();
            drawn = fresh;
        }
    }

    /** Makes the proposal the state. */
    void accept() {
        if (small) {
            time++;
            state.accept(proposal, time);
        } else {
            Coordinates old = state;
            state = fresh;
            fresh = old;
            time = 0;
        }
    }

    /**
     * Sets a coordinate of the state.
     *
     * @param value in [0,1)
     */
    void set(int coordinate, double value) {
        int at = state.find(coordinate);
        if (at < 0) {
            state.add(coordinate, value, time);
        } else {
            state.values[at] = value;
            state.times[at] = time;
        }
    }

    /** Number of coordinates of the state that are known. */
    int size() {
        return state.size;
    }

    @Override
    public double next() {
        int coordinate = dimension++;
        return small ? changed(coordinate) : drawn(coordinate);
    }

    private double drawn(int coordinate) {
        int at = drawn.find(coordinate);
        if (at < 0) {
            at = drawn.add(coordinate, random.nextDouble(), 0);
        }
        return drawn.values[at];
    }

    private double changed(int coordinate) {
        int at = state.find(coordinate);
        if (at < 0) {
            at = state.add(coordinate, random.nextDouble(), time);
        } else if (state.proposals[at] == proposal) {
            return state.proposed[at];
        } else {
            double value = state.values[at];
            for (long missed = time - state.times[at]; missed > 0; missed--) {
                value = step.move(value, random.nextDouble());
            }
            state.values[at] = value;
            state.times[at] = time;
        }
        double changed = step.move(state.values[at], random.nextDouble());
        state.proposed[at] = changed;
        state.proposals[at] = proposal;
        return changed;
    }

    @Override
    protected void seat(long pixelIndex, long sampleIndex) {
        dimension = 0;
    }

    @Override
    public int dimension() {
        return dimension;
    }

    @Override
    public void setDimension(int newDimension) {
        dimension = newDimension;
    }

    @Override
    public Sampler copy() {
        throw new UnsupportedOperationException("the numbers of a state belong to one chain");
    }

    /** Writes the state. */
    void save(StateWriter out) {
        out.put(time);
        state.save(out);
    }

    /** Reads what {@link #save} has written. */
    void load(StateReader in) {
        time = in.next();
        state.load(in);
    }

    /** Known coordinates: arrays in the order in which they were added, and a table of places in them with open addressing. */
    private static final class Coordinates {
        private static final int INITIAL_CAPACITY = 64;
        private static final int FIBONACCI = 0x9E3779B9;

        int[] dimensions = new int[INITIAL_CAPACITY];
        double[] values = new double[INITIAL_CAPACITY];

        /** {@link PrimarySample#time} when the value was valid. */
        long[] times = new long[INITIAL_CAPACITY];

        /** Value in a small step, valid if it is the one with the number in {@link #proposals}. */
        double[] proposed = new double[INITIAL_CAPACITY];

        long[] proposals = new long[INITIAL_CAPACITY];
        int size;

        /** Place plus one, 0 if there is none; twice as many as places. */
        private int[] table = new int[2 * INITIAL_CAPACITY];

        void clear() {
            Arrays.fill(table, 0);
            size = 0;
        }

        /** Place of a coordinate, or -1. */
        int find(int coordinate) {
            int mask = table.length - 1;
            for (int slot = slot(coordinate); table[slot] > 0; slot = slot + 1 & mask) {
                int at = table[slot] - 1;
                if (dimensions[at] == coordinate) {
                    return at;
                }
            }
            return -1;
        }

        /** Adds a coordinate that is not there; returns its place. */
        int add(int coordinate, double value, long time) {
            if (size == values.length) {
                grow();
            }
            int at = size++;
            dimensions[at] = coordinate;
            values[at] = value;
            times[at] = time;
            proposals[at] = 0;
            enter(at);
            return at;
        }

        void accept(long proposal, long time) {
            for (int i = 0; i < size; i++) {
                if (proposals[i] == proposal) {
                    values[i] = proposed[i];
                    times[i] = time;
                }
            }
        }

        private int slot(int coordinate) {
            return (coordinate * FIBONACCI) >>> Integer.numberOfLeadingZeros(table.length - 1);
        }

        private void enter(int at) {
            int mask = table.length - 1;
            int slot = slot(dimensions[at]);
            while (table[slot] > 0) {
                slot = (slot + 1) & mask;
            }
            table[slot] = at + 1;
        }

        private void grow() {
            int capacity = 2 * values.length;
            dimensions = Arrays.copyOf(dimensions, capacity);
            values = Arrays.copyOf(values, capacity);
            times = Arrays.copyOf(times, capacity);
            proposed = Arrays.copyOf(proposed, capacity);
            proposals = Arrays.copyOf(proposals, capacity);
            table = new int[2 * capacity];
            for (int i = 0; i < size; i++) {
                enter(i);
            }
        }

        void save(StateWriter out) {
            out.put((long) size);
            for (int i = 0; i < size; i++) {
                out.put((long) dimensions[i]);
                out.put(values[i]);
                out.put(times[i]);
            }
        }

        void load(StateReader in) {
            clear();
            int count = in.nextInt();
            for (int i = 0; i < count; i++) {
                int coordinate = in.nextInt();
                double value = in.nextDouble();
                add(coordinate, value, in.next());
            }
        }
    }
}
