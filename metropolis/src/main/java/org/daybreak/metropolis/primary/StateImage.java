package org.daybreak.metropolis.primary;

import java.util.Arrays;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.metropolis.chains.ImageImportance;
import org.daybreak.metropolis.chains.StateReader;
import org.daybreak.metropolis.chains.StateWriter;

/**
 * What a state brings to the image: f/p at some film positions, relative to the film. The expectation of the sum of luminances over uniform
 * numbers is the mean luminance of the image. Mutable, owned by a chain or a worker, reused.
 */
final class StateImage {
    private static final int STRIDE = 5;

    private double[] entries = new double[8 * STRIDE];
    private int used;

    /** Empties it. */
    void clear() {
        used = 0;
    }

    /** Adds what the state brings to a film position, unless it is black. */
    void add(double filmX, double filmY, double r, double g, double b) {
        if (r == 0 && g == 0 && b == 0) {
            return;
        }
        if (used == entries.length) {
            entries = Arrays.copyOf(entries, 2 * used);
        }
        entries[used] = filmX;
        entries[used + 1] = filmY;
        entries[used + 2] = r;
        entries[used + 3] = g;
        entries[used + 4] = b;
        used += STRIDE;
    }

    /** Film position in pixels of the first entry; there must be one. */
    double filmX() {
        return entries[0];
    }

    /** Film position in pixels, downwards, of the first entry. */
    double filmY() {
        return entries[1];
    }

    /** f*·v: the sum of luminances, each times the factor at its film position. */
    double target(ImageImportance importance) {
        double sum = 0;
        for (int i = 0; i < used; i += STRIDE) {
            sum += importance.at(entries[i], entries[i + 1])
                    * Spectrum.luminance(entries[i + 2], entries[i + 3], entries[i + 4]);
        }
        return sum;
    }

    /**
     * Splats all.
     *
     * @param factor on the values
     * @return number of splats that were not finite and have been left out
     */
    int splat(double factor, SplatBuffer splats) {
        int bad = 0;
        for (int i = 0; i < used; i += STRIDE) {
            boolean finite = splats.add(
                    entries[i],
                    entries[i + 1],
                    factor * entries[i + 2],
                    factor * entries[i + 3],
                    factor * entries[i + 4]);
            bad += finite ? 0 : 1;
        }
        return bad;
    }

    /** Writes all. */
    void save(StateWriter out) {
        out.put((long) used);
        for (int i = 0; i < used; i++) {
            out.put(entries[i]);
        }
    }

    /** Reads what {@link #save} has written. */
    void load(StateReader in) {
        used = in.nextInt();
        if (used > entries.length) {
            entries = new double[used];
        }
        for (int i = 0; i < used; i++) {
            entries[i] = in.nextDouble();
        }
    }
}
