package org.daybreak.core.accel;

import java.util.Objects;
import org.jspecify.annotations.Nullable;

/** Node of the binary tree from which the traversal layouts are made; garbage after that. */
final class BinaryNode {
    float minX;
    float minY;
    float minZ;
    float maxX;
    float maxY;
    float maxZ;

    /** Children; both null in a leaf. */
    @Nullable
    BinaryNode left;

    @Nullable
    BinaryNode right;

    /** First record of the range and number of records below this node. */
    int start;

    int count;

    /** Left child of an inner node. */
    BinaryNode left() {
        return Objects.requireNonNull(left);
    }

    /** Right child of an inner node. */
    BinaryNode right() {
        return Objects.requireNonNull(right);
    }

    boolean isLeaf() {
        return left == null;
    }

    float halfArea() {
        float x = maxX - minX;
        float y = maxY - minY;
        float z = maxZ - minZ;
        return x * (y + z) + y * z;
    }
}
