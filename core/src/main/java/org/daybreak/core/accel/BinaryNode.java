package org.daybreak.core.accel;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** Node of the binary tree from which the traversal layouts are made; garbage after that. */
final class BinaryNode {
    /** First record of the range and number of records below this node. */
    final int start;

    final int count;

    /** Scaled bounds. */
    float minX;

    float minY;
    float minZ;
    float maxX;
    float maxY;
    float maxZ;

    /** Number of nodes and of blocks below this node, itself included, in the wide layout. */
    int wideNodes;

    int blocks;

    /** Children in the wide layout; null until they are gathered. */
    BinaryNode @Nullable [] wideChildren;

    private @Nullable BinaryNode left;
    private @Nullable BinaryNode right;

    BinaryNode(int start, int count) {
        this.start = start;
        this.count = count;
    }

    /** Makes this an inner node: cuts the range in two. */
    void split(int middle) {
        left = new BinaryNode(start, middle - start);
        right = new BinaryNode(middle, start + count - middle);
    }

    boolean isLeaf() {
        return left == null;
    }

    /** Left child of an inner node. */
    BinaryNode left() {
        return Objects.requireNonNull(left);
    }

    /** Right child of an inner node. */
    BinaryNode right() {
        return Objects.requireNonNull(right);
    }

    /** Half of the surface area. */
    float halfArea() {
        float x = maxX - minX;
        float y = maxY - minY;
        float z = maxZ - minZ;
        return x * (y + z) + y * z;
    }

    /** Takes the bounds of a leaf from its primitives. */
    void fit(PrimitiveRecords records, float[] box) {
        records.fit(start, count, box);
        minX = box[0];
        minY = box[1];
        minZ = box[2];
        maxX = box[3];
        maxY = box[4];
        maxZ = box[5];
    }

    /** Takes the bounds of an inner node from its children. */
    void unite() {
        BinaryNode a = left();
        BinaryNode b = right();
        minX = Math.min(a.minX, b.minX);
        minY = Math.min(a.minY, b.minY);
        minZ = Math.min(a.minZ, b.minZ);
        maxX = Math.max(a.maxX, b.maxX);
        maxY = Math.max(a.maxY, b.maxY);
        maxZ = Math.max(a.maxZ, b.maxZ);
    }
}
