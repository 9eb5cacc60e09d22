package org.daybreak.scenes.build;

/** Kind of value a property takes. */
public enum ValueType {
    /** A whole number. */
    INTEGER,
    /** A real number. */
    FLOAT,
    /** True or false. */
    BOOLEAN,
    /** A text. */
    STRING,
    /** One word out of several. */
    CHOICE,
    /** A file name, relative to the file it stands in, or a file contained in it. */
    FILE,
    /** A mesh in memory. */
    MESH,
    /** A point. */
    POINT,
    /** A refractive index or the name of a substance. */
    REFRACTIVE_INDEX,
    /** A colour, the same everywhere on the surface, not limited to 1. */
    COLOR,
    /** A colour or a texture with values from 0 to 1. */
    REFLECTANCE,
    /** A number from a range or a texture of such numbers, of colours their luminance. */
    TEXTURED_NUMBER,
    /** Emitted radiance or intensity: a colour, the same everywhere. */
    EMISSION,
    /** Emitted radiance: a colour or a texture. */
    TEXTURED_EMISSION,
    /** An affine transform. */
    TRANSFORM,
    /** Nested objects of one kind. */
    OBJECT;

    /** True if a texture can take the place of a value. */
    boolean isTextured() {
        return this == REFLECTANCE || this == TEXTURED_NUMBER || this == TEXTURED_EMISSION;
    }
}
