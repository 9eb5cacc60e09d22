package org.daybreak.scenes.gltf;

import java.util.Arrays;

/** Turns the corners of a primitive into separate triangles (glTF 2.0 specification, 3.7.2.1). */
final class Triangulation {
    static final int TRIANGLES = 4;
    static final int STRIP = 5;
    static final int FAN = 6;

    private Triangulation() {}

    /** Corners that make no whole triangle and are left over. */
    static int leftOver(int mode, int corners) {
        return mode == TRIANGLES ? corners % 3 : corners < 3 ? corners : 0;
    }

    /**
     * Three corners for each triangle, all wound the same way.
     *
     * @param mode {@link #TRIANGLES}, {@link #STRIP} or {@link #FAN}
     */
    static int[] triangles(int mode, int[] corners) {
        if (mode == TRIANGLES) {
            return corners.length % 3 == 0 ? corners : Arrays.copyOf(corners, corners.length - corners.length % 3);
        }
        int count = Math.max(0, corners.length - 2);
        int[] out = new int[Math.multiplyExact(3, count)];
        for (int i = 0; i < count; i++) {
            if (mode == STRIP) {
                out[3 * i] = corners[i];
                out[3 * i + 1] = corners[i + 1 + i % 2];
                out[3 * i + 2] = corners[i + 2 - i % 2];
            } else {
                out[3 * i] = corners[i + 1];
                out[3 * i + 1] = corners[i + 2];
                out[3 * i + 2] = corners[0];
            }
        }
        return out;
    }
}
