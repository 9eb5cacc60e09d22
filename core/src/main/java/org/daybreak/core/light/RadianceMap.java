package org.daybreak.core.light;

/**
 * An equirectangular image of radiance. Immutable: the array is taken over.
 *
 * <p>Row 0 is the zenith (+y), the last row the nadir. Column position u in [0,1] maps to the direction
 * (sin(2πu)·sin θ, cos θ, −cos(2πu)·sin θ) with θ = π·v, the convention of Mitsuba's {@code envmap}.
 */
public final class RadianceMap {
    private final int width;
    private final int height;
    private final float[] rgb;

    /**
     * Creates a map.
     *
     * @param rgb linear RGB interleaved, row by row from the top; finite and not negative
     * @throws IllegalArgumentException if sizes do not fit or a value is negative or not finite
     */
    public RadianceMap(int width, int height, float[] rgb) {
        if (width < 1 || height < 1 || rgb.length != 3L * width * height) {
            throw new IllegalArgumentException(
                    "an environment image of " + width + "x" + height + " does not fit " + rgb.length + " values");
        }
        for (int i = 0; i < rgb.length; i++) {
            if (!(rgb[i] >= 0) || Float.isInfinite(rgb[i])) {
                throw new IllegalArgumentException("pixel (" + i / 3 % width + ", " + i / 3 / width
                        + ") of the environment image is negative or not finite");
            }
        }
        this.width = width;
        this.height = height;
        this.rgb = rgb;
    }

    /** Width in pixels. */
    public int width() {
        return width;
    }

    /** Height in pixels. */
    public int height() {
        return height;
    }

    /** Interleaved linear RGB; not a copy, do not change. */
    public float[] rgb() {
        return rgb;
    }
}
