package org.daybreak.core.light;

/**
 * An equirectangular image of radiance. Immutable: the array is taken over.
 *
 * <p>The convention is that of Mitsuba's {@code envmap}, which is not the same across and down. Down, the first row lies
 * on the zenith (+y) and the last on the nadir: row r stands for the polar angle θ = π·r/(height − 1). Across, pixels
 * have their centres within: column c stands for u = (c + ½)/width. The direction is
 * (sin(2πu)·sin θ, cos θ, −cos(2πu)·sin θ). Between pixels the radiance is bilinear, wrapped around across.
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
