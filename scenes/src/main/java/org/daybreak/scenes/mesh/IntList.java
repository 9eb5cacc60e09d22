package org.daybreak.scenes.mesh;

import java.util.Arrays;

/** A growable array of integers. */
final class IntList {
    private static final int LONGEST = Integer.MAX_VALUE - 8;

    private int[] values = new int[256];
    private int size;

    int size() {
        return size;
    }

    int get(int index) {
        return values[index];
    }

    void add(int value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, grown(size));
        }
        values[size++] = value;
    }

    int[] toArray() {
        return Arrays.copyOf(values, size);
    }

    /** Next capacity of an array that is full. */
    static int grown(int size) {
        if (size == LONGEST) {
            throw new OutOfMemoryError("an array would need more than " + LONGEST + " elements");
        }
        return (int) Math.min(LONGEST, size + (size >> 1) + 16L);
    }
}
