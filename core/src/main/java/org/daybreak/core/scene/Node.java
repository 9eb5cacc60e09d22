package org.daybreak.core.scene;

import javax.vecmath.Matrix4d;
import org.jspecify.annotations.Nullable;

/**
 * A node of the editable scene graph: everything has an optional name and a transform to its parent's coordinates. Not
 * thread-safe; the compiled {@link Scene} is.
 */
public abstract sealed class Node permits Group, Instance, ShapeNode, LightNode {
    private @Nullable String name;
    private final Matrix4d transform = identity();

    /** Creates a node with identity transform and no name. */
    protected Node() {}

    /** The name, used in messages and statistics. */
    public final @Nullable String name() {
        return name;
    }

    /** Sets the name. */
    public final void setName(@Nullable String name) {
        this.name = name;
    }

    /** A copy of the transform from this node's to its parent's coordinates. */
    public final Matrix4d transform() {
        return new Matrix4d(transform);
    }

    /** Sets the transform from this node's to its parent's coordinates: affine, invertible, mirroring allowed. */
    public final void setTransform(Matrix4d toParent) {
        transform.set(toParent);
    }

    private static Matrix4d identity() {
        Matrix4d m = new Matrix4d();
        m.setIdentity();
        return m;
    }
}
