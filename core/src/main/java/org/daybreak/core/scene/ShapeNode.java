package org.daybreak.core.scene;

import org.daybreak.core.geometry.Shape;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.Texture;
import org.jspecify.annotations.Nullable;

/** A shape with material and, if it is a light, emitted radiance. */
public final class ShapeNode extends Node {
    private Shape shape;
    private Bsdf material;
    private @Nullable Texture radiance;
    private boolean flipNormals;

    /** Creates a shape that does not emit. */
    public ShapeNode(Shape shape, Bsdf material) {
        this.shape = shape;
        this.material = material;
    }

    /** The shape. */
    public Shape shape() {
        return shape;
    }

    /** Sets the shape. */
    public void setShape(Shape shape) {
        this.shape = shape;
    }

    /** The material. */
    public Bsdf material() {
        return material;
    }

    /** Sets the material. */
    public void setMaterial(Bsdf material) {
        this.material = material;
    }

    /** Emitted radiance in W/(m²·sr), on the front side; null if the shape does not emit. */
    public @Nullable Texture radiance() {
        return radiance;
    }

    /** Sets the emitted radiance, null for none. Returns this node. */
    public ShapeNode setRadiance(@Nullable Texture radiance) {
        this.radiance = radiance;
        return this;
    }

    /** True if front and back are exchanged. */
    public boolean flipNormals() {
        return flipNormals;
    }

    /** Exchanges front and back. */
    public void setFlipNormals(boolean flipNormals) {
        this.flipNormals = flipNormals;
    }
}
