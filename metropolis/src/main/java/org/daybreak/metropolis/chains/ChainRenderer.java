package org.daybreak.metropolis.chains;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.Film;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.Reports;

/**
 * Renders by Markov chains: the life that all such renderers share, whatever a state is and however it moves ({@link
 * ChainAlgorithm}).
 *
 * <ol>
 *   <li>With {@link ChainSettings#separateDirect()}, paths of at most two edges are rendered by path tracing, with the antialiasing
 *       of the render; the chains then have longer paths only. An algorithm may let bidirectional samples find more: which kinds of
 *       paths, a pilot with random numbers of its own says before.
 *   <li>With {@link ChainSettings#twoStage()}, a first run with a tenth of the steps and of the candidates makes a rough image,
 *       whose inverse is a factor on the target of the chains from then on. Its random numbers are its own, so the factor
 *       is independent of all that follows, and the mean does not depend on it.
 *   <li>Candidates are drawn. They give the brightness b and, by resampling, the starts of all chains ({@link StartDistribution}).
 *   <li>The chains move in rounds, and splat as they go. The image is Σ splats · b · pixels / steps.
 * </ol>
 *
 * <p>The image has the same bits for any number of threads. The number of pixels is that of the whole film, and chains do
 * not depend on the crop: a crop is a part of the whole image, bit for bit.
 *
 * <p><b>End.</b> After {@link ChainSettings#mutationsPerPixel()}, whatever the budget's number of samples per pixel is; only without
 * limit if that is {@link Integer#MAX_VALUE}, as it is when nothing but time or a target error is given. When time is over,
 * some chains have taken a round more than others. As all steps have the same weight in the image, and the mean of each step of each
 * chain is right, this does not matter.
 *
 * <p><b>Parts</b> are ranges of chains, and of tiles of the direct light. All of them draw the same candidates and make the same
 * rough image, so b and the starts are the same. Each has the chains of the whole render; their sums are added up in another
 * order than there.
 */
public final class ChainRenderer implements Renderer {
    private final ChainAlgorithm algorithm;
    private final ChainSettings settings;
    private final DirectPart direct;

    /**
     * Creates a renderer.
     *
     * @param algorithm what a state is and how it moves
     * @param maxEyeDepth largest number of vertices of an eye subpath, -1 for no limit: below 3, path tracing cannot render the direct
     *     light apart, and it is left to the chains
     * @param maxDepth largest number of edges of a path, -1 for no limit
     */
    public ChainRenderer(ChainAlgorithm algorithm, ChainSettings settings, int maxEyeDepth, int maxDepth) {
        this.algorithm = algorithm;
        this.settings = settings;
        direct = new DirectPart(settings, maxEyeDepth, maxDepth);
    }

    /**
     * {@inheritDoc}
     *
     * @throws ParameterException if the film does not fit the camera, or if there are more parts than chains or tiles
     */
    @Override
    public RenderReport render(Scene scene, Camera camera, Film film, RenderContext context) {
        Reports.checkFilm(camera, film);
        return ChainRun.of(algorithm, settings, direct, scene, camera, film, context);
    }

    @Override
    public boolean isResumable() {
        return true;
    }
}
