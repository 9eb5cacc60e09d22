package org.daybreak.core.film;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * A developed film: named channels of linear values, row by row from the top. Immutable as long as the arrays it hands out
 * are not written to.
 */
public final class FilmImage {
    private final FilmSettings settings;
    private final Map<String, float[]> channels;

    FilmImage(FilmSettings settings, Map<String, float[]> channels) {
        this.settings = settings;
        this.channels = Collections.unmodifiableMap(new LinkedHashMap<>(channels));
    }

    /** Columns of the crop. */
    public int width() {
        return settings.crop().width();
    }

    /** Rows of the crop. */
    public int height() {
        return settings.crop().height();
    }

    /** Size of the whole film, and which part of it this image is. */
    public FilmSettings settings() {
        return settings;
    }

    /** Channel names: {@code R}, {@code G}, {@code B}, then those of the film's layers. */
    public List<String> channelNames() {
        return List.copyOf(channels.keySet());
    }

    /** All channels by name; the arrays are not copies. */
    public Map<String, float[]> channels() {
        return channels;
    }

    /**
     * One channel; not a copy.
     *
     * @throws IllegalArgumentException if the film was not asked for it
     */
    public float[] channel(String name) {
        float[] values = channels.get(name);
        if (values == null) {
            throw new IllegalArgumentException("the image has no channel '" + name + "', only " + channels.keySet());
        }
        return values;
    }

    /**
     * One value.
     *
     * @param x column within the crop
     * @param y row within the crop
     */
    public float get(String name, int x, int y) {
        if (x < 0 || x >= width() || y < 0 || y >= height()) {
            throw new IndexOutOfBoundsException(
                    "pixel (" + x + ", " + y + ") of an image of " + width() + "x" + height());
        }
        return channel(name)[y * width() + x];
    }

    /** Mean of a channel over all pixels. */
    public double mean(String name) {
        double sum = 0;
        for (float v : channel(name)) {
            sum += v;
        }
        return sum / ((double) width() * height());
    }
}
