package org.daybreak.exr;

import java.util.List;

/**
 * A Radiance HDR image. Samples are the numbers that stand in the file: radiance in W/(sr·m²) times exposure and colour
 * correction. Divide by {@link #exposure} and {@link #colorCorrection} to get radiance; nothing here does so.
 *
 * @param width columns, at least 1
 * @param height rows, at least 1
 * @param samples three components for each pixel, index {@code (y * width + x) * 3 + c}, rows from top to bottom, each
 *     from left to right; not copied
 * @param colorSpace what the components are
 * @param exposure product of all {@code EXPOSURE} lines of the header; 1 without any
 * @param colorCorrection products of the three numbers of all {@code COLORCORR} lines of the header; 1, 1, 1 without any
 * @param header all further lines of the header in order, such as {@code VIEW=} or comments; written back unchanged
 */
public record HdrImage(
        int width,
        int height,
        float[] samples,
        ColorSpace colorSpace,
        double exposure,
        List<Double> colorCorrection,
        List<String> header) {
    /** What the three components of a pixel are. */
    public enum ColorSpace {
        /** Red, green and blue; primaries as the header line {@code PRIMARIES} says. */
        RGB("32-bit_rle_rgbe"),
        /** CIE 1931 X, Y and Z. */
        XYZ("32-bit_rle_xyze");

        private final String format;

        ColorSpace(String format) {
            this.format = format;
        }

        /** The value of the header line FORMAT. */
        String format() {
            return format;
        }
    }

    private static final List<Double> NO_CORRECTION = List.of(1.0, 1.0, 1.0);

    /**
     * Checks the sizes; the lists are copied.
     *
     * @throws IllegalArgumentException if a size is below 1, the array has another length, a factor is not positive and
     *     finite, or a header line is empty, has a line break or characters beyond Latin-1, or is one that the fields of this record stand for
     */
    public HdrImage {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("an image needs at least one pixel, not " + width + " x " + height);
        }
        // Divided, as the product of three ints may not fit a long.
        if (samples.length % 3 != 0 || samples.length / 3 != (long) width * height) {
            throw new IllegalArgumentException(samples.length + " samples for " + width + " x " + height + " x 3");
        }
        checkFactor("exposure", exposure);
        colorCorrection = List.copyOf(colorCorrection);
        if (colorCorrection.size() != 3) {
            throw new IllegalArgumentException("a colour correction has 3 factors, not " + colorCorrection.size());
        }
        for (double factor : colorCorrection) {
            checkFactor("colour correction", factor);
        }
        header = List.copyOf(header);
        for (String line : header) {
            checkLine(line);
        }
    }

    /**
     * Creates an RGB image without exposure, correction and header lines.
     *
     * @param width columns
     * @param height rows
     * @param samples three components for each pixel, rows from top to bottom; not copied
     * @throws IllegalArgumentException as the canonical constructor
     */
    public HdrImage(int width, int height, float[] samples) {
        this(width, height, samples, ColorSpace.RGB, 1, NO_CORRECTION, List.of());
    }

    private static void checkFactor(String what, double factor) {
        if (!(factor > 0 && factor <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("the " + what + " must be positive and finite, not " + factor);
        }
    }

    private static void checkLine(String line) {
        boolean reserved = line.startsWith("#?")
                || line.startsWith(RadianceHdr.FORMAT)
                || line.startsWith(RadianceHdr.EXPOSURE)
                || line.startsWith(RadianceHdr.COLOR_CORRECTION);
        boolean unprintable = line.chars().anyMatch(c -> c == '\n' || c == 0 || c > 0xff);
        if (line.isEmpty() || reserved || unprintable) {
            throw new IllegalArgumentException("'" + line + "' is not valid as a further header line");
        }
    }
}
