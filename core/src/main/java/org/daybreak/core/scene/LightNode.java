package org.daybreak.core.scene;

/** A light that is not a shape: point, spot, environment. */
public final class LightNode extends Node {
    private LightSource source;

    /** Creates a light. */
    public LightNode(LightSource source) {
        this.source = source;
    }

    /** What it emits. */
    public LightSource source() {
        return source;
    }

    /** Sets what it emits. */
    public void setSource(LightSource source) {
        this.source = source;
    }
}
