package org.daybreak.core.film;

import java.util.Arrays;
import org.daybreak.core.color.Spectrum;

/**
 * Splats of one work unit: contributions whose film position is not chosen but found, as when a light subpath is joined to
 * the lens. Mutable, owned by one worker at a time, reused; {@link Film#commit(SplatBuffer, long)} adds it to the film.
 *
 * <p>It is a list and not an image, so its size follows the work unit and not film and lanes, and units can be committed in
 * order while others are being computed.
 */
public final class SplatBuffer {
    static final int STRIDE = 5;

    private double[] splats = new double[STRIDE * 256];
    private int used;

    /** Creates an empty buffer. */
    public SplatBuffer() {}

    /** Empties the buffer; keeps its memory. */
    public void clear() {
        used = 0;
    }

    /**
     * Adds a splat. A splat is an estimate whose sum over a pixel's area, divided by the number of light subpaths, is the
     * pixel's value.
     *
     * @param filmX film position in pixels
     * @return false if a value is not finite: it is then left out, and the caller records the splat's address
     */
    public boolean add(double filmX, double filmY, Spectrum value) {
        return add(filmX, filmY, value.r, value.g, value.b);
    }

    /** Adds a splat given by components, as {@link #add(double, double, Spectrum)} does. */
    public boolean add(double filmX, double filmY, double r, double g, double b) {
        if (!Double.isFinite(r) || !Double.isFinite(g) || !Double.isFinite(b)) {
            return false;
        }
        if (used == splats.length) {
            splats = Arrays.copyOf(splats, 2 * used);
        }
        splats[used] = filmX;
        splats[used + 1] = filmY;
        splats[used + 2] = r;
        splats[used + 3] = g;
        splats[used + 4] = b;
        used += STRIDE;
        return true;
    }

    /** Number of splats. */
    public int size() {
        return used / STRIDE;
    }

    /** Film position in pixels of a splat. */
    public double filmX(int splat) {
        return splats[STRIDE * splat];
    }

    /** Film position in pixels, downwards, of a splat. */
    public double filmY(int splat) {
        return splats[STRIDE * splat + 1];
    }

    /**
     * A component of a splat.
     *
     * @param component 0 red, 1 green, 2 blue
     */
    public double value(int splat, int component) {
        return splats[STRIDE * splat + 2 + component];
    }

    /** Luminance of a splat. */
    public double luminance(int splat) {
        int at = splat * STRIDE;
        return Spectrum.luminance(splats[at + 2], splats[at + 3], splats[at + 4]);
    }

    /** Film x, film y, red, green and blue of each splat; the first {@code STRIDE·size()} entries count. */
    double[] entries() {
        return splats;
    }
}
