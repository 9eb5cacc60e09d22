package org.daybreak.bidirectional;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.RaySample;

/**
 * Samples paths of a given number of edges by a given technique: a light subpath of s vertices and an eye subpath of t joined into a
 * path of k = s + t − 1 edges, as multiplexed algorithms need it (Hachisuka et al. 2014). The numbers that a sampler has at the dimensions
 * of {@link org.daybreak.tracing.Dimensions} make the same path as in bidirectional path tracing, with the same weight; but for Russian
 * roulette, which does not end subpaths of a given length and has no part in the value.
 *
 * <p>One light is chosen for each sample, and eye subpaths do not split, whatever the settings say. One object per worker.
 */
public final class TechniqueSampler {
    private final BiDirectionalProcessor processor;
    private final TechniqueLimits limits;

    /** Creates a sampler of techniques. */
    public TechniqueSampler(Scene scene, Camera camera, BidirectionalSettings settings) {
        BidirectionalSettings single = settings.singleSample();
        limits = single.limits(camera);
        processor = new BiDirectionalProcessor(scene, camera, false, single, Integer.MAX_VALUE, null);
    }

    /**
     * Number of techniques within the limits of depth that make paths of k edges.
     *
     * @param edges k, at least 1
     */
    public int techniques(int edges) {
        return Math.max(0, mostLightVertices(edges) - leastLightVertices(edges) + 1);
    }

    /**
     * Number of light vertices s of a technique; the eye vertices are t = k + 1 − s.
     *
     * @param edges k
     * @param number of the technique, 0 … {@link #techniques} − 1
     */
    public int lightVertices(int edges, int number) {
        return leastLightVertices(edges) + number;
    }

    /**
     * Number of a technique among those of its length.
     *
     * @param edges k
     * @param lightVertices s
     */
    public int number(int edges, int lightVertices) {
        return lightVertices - leastLightVertices(edges);
    }

    private int leastLightVertices(int edges) {
        return Math.max(0, edges + 1 - limits.maxEyeVertices());
    }

    private int mostLightVertices(int edges) {
        // The lens has one vertex at least, and is joined to a light only where nothing else finds that.
        boolean lens = edges == 1 ? limits.emitterAtLens() : limits.lens();
        return Math.min(lens ? edges : edges - 1, limits.maxLightVertices());
    }

    /**
     * Samples a path.
     *
     * @param edges k
     * @param lightVertices s of a technique among {@link #techniques}
     * @param filmX film position in pixels, where t ≥ 2
     * @param sampler with numbers from {@link org.daybreak.tracing.Dimensions#FIRST_DIRECT} on
     * @param out receives w·f/p as radiance, where t ≥ 2
     * @param splats receives w·f/p as a splat, where t = 1
     * @return false if a splat was not finite and has been left out
     */
    public boolean trace(
            int edges,
            int lightVertices,
            double filmX,
            double filmY,
            Sampler sampler,
            RaySample out,
            SplatBuffer splats) {
        return processor.traceTechnique(lightVertices, edges + 1 - lightVertices, filmX, filmY, sampler, out, splats);
    }

    /** Number of rays of a kind traced so far. */
    public long rays(RayKind kind) {
        return processor.rays(kind);
    }
}
