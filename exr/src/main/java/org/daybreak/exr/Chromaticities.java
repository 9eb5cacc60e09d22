package org.daybreak.exr;

/**
 * CIE 1931 xy chromaticities of the primaries and the white point of the RGB channels.
 *
 * @param red red primary
 * @param green green primary
 * @param blue blue primary
 * @param white white point
 */
public record Chromaticities(V2f red, V2f green, V2f blue, V2f white) {
    /** The primaries and D65 white of Rec. ITU-R BT.709, which sRGB shares; what a file without the attribute means. */
    public static final Chromaticities REC_709 = new Chromaticities(
            new V2f(0.64f, 0.33f), new V2f(0.30f, 0.60f), new V2f(0.15f, 0.06f), new V2f(0.3127f, 0.3290f));
}
