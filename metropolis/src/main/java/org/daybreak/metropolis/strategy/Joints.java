package org.daybreak.metropolis.strategy;

import java.util.Arrays;

/**
 * The vertices of a path at which walks can be joined: its ends, and those whose material scatters by other than delta lobes, whatever the
 * path does there. Between two that follow each other there is an edge, or a chain of mirrors and glass that walks pass as they come. Joint
 * −1 stands for what lies before the light, joint {@link #count} for what lies behind the lens. Mutable, owned by one worker.
 */
final class Joints {
    private int[] vertices = new int[8];

    /** Number of joints before one that the path could be joined behind. */
    private int[] seams = new int[8];

    private int count;
    private int length;

    /** Numbers those of a path. */
    void of(LightPath path) {
        length = path.length;
        if (vertices.length < length) {
            vertices = Arrays.copyOf(vertices, 2 * length);
            seams = Arrays.copyOf(seams, 2 * length);
        }
        count = 0;
        int sum = 0;
        for (int v = 0; v < length; v++) {
            if (v == 0 || v == length - 1 || path.connectable[v]) {
                if (v > 0 && vertices[count - 1] == v - 1 && path.joins(v - 1) && path.joins(v)) {
                    sum++;
                }
                vertices[count] = v;
                seams[count] = sum;
                count++;
            }
        }
    }

    /** Number of joints, both ends included. */
    int count() {
        return count;
    }

    /** The vertex of a joint. */
    int vertex(int joint) {
        return joint < 0 ? -1 : joint == count ? length : vertices[joint];
    }

    /** The joint at a vertex that is one. */
    int at(int vertex) {
        int joint = 0;
        while (joint < count && vertices[joint] < vertex) {
            joint++;
        }
        return vertex < 0 ? -1 : joint;
    }

    /** Whether an edge leads from a joint to the next one, at both of which the path takes no delta lobe: walks can be joined there. */
    boolean isSeam(int joint) {
        return seams[joint + 1] > seams[joint];
    }

    /** Whether there is such an edge behind one of some joints. */
    boolean hasSeam(int first, int last) {
        return last >= first && seams[last + 1] > seams[first];
    }
}
