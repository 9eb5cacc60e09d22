package org.daybreak.core.render;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The address of an image sample: with the settings of the render, all its random numbers follow from it. Reports name samples
 * by their {@linkplain #toString() text}.
 *
 * @param seed seed of the random numbers
 * @param x column of the pixel in the whole film
 * @param y row of the pixel
 * @param sample number of the sample within the pixel, from 0
 */
public record SampleAddress(long seed, int x, int y, long sample) {
    private static final Pattern TEXT =
            Pattern.compile("seed (-?\\d{1,19}), pixel \\((\\d{1,9}), (\\d{1,9})\\), sample (\\d{1,18})");

    /**
     * The address of a text, as {@link #toString} makes it.
     *
     * @throws ParameterException if the text has another form
     */
    public static SampleAddress parse(String text) {
        Matcher matcher = TEXT.matcher(text.trim());
        try {
            if (matcher.matches()) {
                return new SampleAddress(
                        Long.parseLong(matcher.group(1)),
                        Integer.parseInt(matcher.group(2)),
                        Integer.parseInt(matcher.group(3)),
                        Long.parseLong(matcher.group(4)));
            }
        } catch (NumberFormatException e) {
            throw invalid(text, e);
        }
        throw invalid(text, null);
    }

    private static ParameterException invalid(String text, @org.jspecify.annotations.Nullable Exception cause) {
        return new ParameterException(
                "'" + text + "' is no address of a sample, such as 'seed 0, pixel (3, 4), sample 5'", cause);
    }

    /** {@code seed 0, pixel (3, 4), sample 5}. */
    @Override
    public String toString() {
        return "seed " + seed + ", pixel (" + x + ", " + y + "), sample " + sample;
    }
}
