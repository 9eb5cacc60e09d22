package org.daybreak.scenes.description;

import java.util.Locale;

/** Kinds of objects a scene consists of. */
public enum ObjectKind {
    /** The scene itself. */
    SCENE,
    /** A rendering method. */
    INTEGRATOR,
    /** A camera. */
    SENSOR,
    /** The image of a camera. */
    FILM,
    /** A reconstruction filter of a film. */
    RFILTER,
    /** A sample generator. */
    SAMPLER,
    /** Geometry. */
    SHAPE,
    /** A material. */
    BSDF,
    /** A value that varies over a surface. */
    TEXTURE,
    /** A light. */
    EMITTER;

    /** Name of the element in scene files. */
    public String element() {
        return name().toLowerCase(Locale.ROOT);
    }
}
