package org.daybreak.core.render;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.daybreak.core.film.FilmState;

/**
 * A render between two of its work units: with it, the same settings and the same scene, a render goes on and ends with the same
 * bits as one that was not interrupted. Immutable as long as the arrays are not written to.
 *
 * @param film what the film has accumulated
 * @param position where the renderer is in its work, by names of its own
 * @param samples image samples (or light subpaths) taken
 * @param samplesPerPixel samples per pixel in finished passes
 * @param complete true if nothing remains to be done
 * @param nonFiniteSamples number of samples that were NaN or infinite
 * @param nonFiniteAddresses addresses of the first few of them
 * @param seconds wall-clock seconds of rendering so far
 */
public record RenderState(
        FilmState film,
        Map<String, long[]> position,
        long samples,
        long samplesPerPixel,
        boolean complete,
        long nonFiniteSamples,
        List<String> nonFiniteAddresses,
        double seconds) {
    /** Copies the collections. */
    public RenderState {
        position = Collections.unmodifiableMap(new LinkedHashMap<>(position));
        nonFiniteAddresses = List.copyOf(nonFiniteAddresses);
    }

    /**
     * An entry of the position.
     *
     * @param length how many numbers it must have
     * @throws ParameterException if it is not there or has another length: the state is another renderer's
     */
    public long[] position(String name, int length) {
        long[] values = position.get(name);
        if (values == null || values.length != length) {
            throw new ParameterException("the state to go on from does not belong to this renderer: it has no '" + name
                    + "' of " + length + " numbers");
        }
        return values;
    }
}
