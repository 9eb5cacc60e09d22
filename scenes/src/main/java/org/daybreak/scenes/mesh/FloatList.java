package org.daybreak.scenes.mesh;

import java.util.Arrays;

/** A growable array of floats. */
final class FloatList {
    private float[] values = new float[256];
    private int size;

    int size() {
        return size;
    }

    float get(int index) {
        return values[index];
    }

    void add(float value) {
        if (size == values.length) {
            values = Arrays.copyOf(values, IntList.grown(size));
        }
        values[size++] = value;
    }

    float[] toArray() {
        return Arrays.copyOf(values, size);
    }
}
