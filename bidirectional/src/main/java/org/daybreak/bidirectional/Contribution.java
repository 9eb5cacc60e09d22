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
public final class Contribution {
    /** Told of contributions, for debug views and tests. */
    @FunctionalInterface
    public interface Listener {
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

    /** Numbers of the point on the lens; without meaning for t = 0. */
    double lensU;

    double lensV;

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

    /** Number of vertices from the light. */
    public int lightVertices() {
        return s;
    }

    /** Number of vertices from the lens. */
    public int eyeVertices() {
        return t;
    }

    /** The light subpath; see the class comment for what of it belongs to the path. */
    public PathValues light() {
        return light;
    }

    /** The eye subpath. */
    public PathValues eye() {
        return eye;
    }

    /** The light sample, for s = 1 and t ≥ 2. */
    public LightSample lightSample() {
        return lightSample;
    }

    /** The lens sample, for t ≤ 1. */
    public LensSample lens() {
        return lens;
    }

    /** Index of the light. */
    public int lightIndex() {
        return lightIndex;
    }

    /** Film position in pixels. */
    public double filmX() {
        return filmX;
    }

    /** Film position in pixels, downwards. */
    public double filmY() {
        return filmY;
    }

    /** First number of the point on the lens. */
    public double lensU() {
        return lensU;
    }

    /** Second number of the point on the lens. */
    public double lensV() {
        return lensV;
    }

    /** Red of f/p: {@link #r}. */
    public double red() {
        return r;
    }

    /** Green of f/p. */
    public double green() {
        return g;
    }

    /** Blue of f/p. */
    public double blue() {
        return b;
    }

    /** Weight w_{s,t}. */
    public double weight() {
        return weight;
    }

    /** The densities of the full path, from which the weight follows. */
    CombinedPathValues densities() {
        return complement.combine();
    }
}
