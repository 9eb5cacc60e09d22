package org.daybreak.core.material;

/** What the tangents of a shading frame must follow for a material to look as it should. */
public enum TangentFrame {
    /** Nothing: the material looks the same however the frame is turned about the normal. */
    ARBITRARY,
    /** The texture coordinates; where a normal or bump map asks for the second ones, those. */
    ANY_UVS,
    /** The first texture coordinates. */
    FIRST_UVS,
    /** The second texture coordinates; on meshes without, the first ones. */
    SECOND_UVS;

    /**
     * What a material of two parts needs.
     *
     * @throws IllegalArgumentException if one part needs the first and the other the second coordinates: a point has one
     *     frame
     */
    TangentFrame and(TangentFrame other) {
        TangentFrame stronger = compareTo(other) < 0 ? other : this;
        TangentFrame weaker = stronger == this ? other : this;
        if (stronger == SECOND_UVS && weaker == FIRST_UVS) {
            throw new IllegalArgumentException("the parts of one material must not have normal or bump maps over the"
                    + " first and over the second texture coordinates");
        }
        return stronger;
    }
}
