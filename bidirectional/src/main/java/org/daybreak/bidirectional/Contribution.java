package org.daybreak.bidirectional;

import org.daybreak.core.camera.LensSample;
import org.daybreak.core.light.LightSample;

/**
 * A full path that some technique (s, t) has found, as a {@link Listener} sees it: what it adds to the image and the
 * subpaths it is made of. Owned by one worker; valid during the call.
 *
 * <p>The light's vertices are {@link #light}[0…s−1] for s ≥ 2 and for t = 1, the point of {@link #lightSample} for s = 1, t ≥ 2,
 * and the last one of {@link #eye} for s = 0. The lens is {@link #eye}[0] for t ≥ 2 and the point of {@link #lens} for t ≤ 1; for t = 0 it
 * takes the place of y_{s−1}. With s = t = 1 and a light at infinity {@link #lens} has the direction, too.
 */
final class Contribution {
    /** Told of contributions, for debug views and tests. */
    @FunctionalInterface
    interface Listener {
        /** Something has been added to the image, or would have been if its weight were not 0. */
        void found(Contribution contribution);

        /** Something would have been added, with the value that it has here, if no surface were in the way. */
        default void occluded(Contribution contribution) {}

        /** Something with this value would have been tested for occlusion if the roulette had not left it out. */
        default void leftOut(Contribution contribution) {}

        /**
         * A subpath has been traced and will be joined. Of an eye subpath that splits, first the part that all branches share, then
         * each branch after it.
         *
         * @param path of length 0 if there is none
         * @param light where it starts; -1 for the lens
         */
        default void traced(PathValues path, int light) {}
    }

    final PathValues light;
    final PathValues eye;
    final LightSample lightSample;
    final LensSample lens;
    private final ComplementTracer complement;

    /** Number of vertices from the light. */
    int s;

    /** Number of vertices from the lens. */
    int t;

    /** The light. */
    int lightIndex;

    /** Film position in pixels. */
    double filmX;

    double filmY;

    /**
     * f/p, visibility and Russian roulette included, without the weight. Summed over a pixel it gives the pixel's radiance as this
     * technique finds it, divided by the number of samples: of the pixel for t ≥ 2, of the whole image for t ≤ 1.
     */
    double r;

    double g;
    double b;

    /** Weight w_{s,t}. */
    double weight;

    Contribution(
            PathValues light, PathValues eye, LightSample lightSample, LensSample lens, ComplementTracer complement) {
        this.light = light;
        this.eye = eye;
        this.lightSample = lightSample;
        this.lens = lens;
        this.complement = complement;
    }

    /** The densities of the full path, from which the weight follows. */
    CombinedPathValues densities() {
        return complement.combine();
    }
}
