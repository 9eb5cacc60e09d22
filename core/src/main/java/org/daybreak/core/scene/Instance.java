package org.daybreak.core.scene;

/**
 * Another appearance of a group. The geometry of the prototype is stored once however often it is instanced; emitting
 * shapes inside an instance are copied, so that every light has its own identity.
 */
public final class Instance extends Node {
    private final Group prototype;

    /** Creates an instance of a group. */
    public Instance(Group prototype) {
        this.prototype = prototype;
    }

    /** The instanced group. Its own transform applies before the instance's. */
    public Group prototype() {
        return prototype;
    }
}
