package org.daybreak.tracing;

import java.util.Map;
import java.util.ServiceLoader;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.render.CancellationToken;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderListener;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.render.RendererFactory;
import org.daybreak.core.scene.Scene;

/** Renders for tests. */
final class Rendering {
    private Rendering() {}

    static RendererFactory factory(String id) {
        return ServiceLoader.load(RendererFactory.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(f -> f.id().equals(id))
                .findFirst()
                .orElseThrow();
    }

    /** A renderer; parameters as name, value, name, value. */
    static Renderer renderer(String id, Map<String, String> parameters) {
        RendererFactory factory = factory(id);
        return factory.create(ParameterValues.parse(factory.parameters(), parameters, id));
    }

    static RenderContext context(long seed, int threads, RenderBudget budget) {
        return context(seed, threads, budget, new CancellationToken(), RenderListener.NONE);
    }

    static RenderContext context(
            long seed, int threads, RenderBudget budget, CancellationToken token, RenderListener listener) {
        return new RenderContext(seed, threads, budget, new SobolSampling(), token, listener);
    }

    /** Renders and checks that nothing was wrong on the way. */
    static FilmImage image(Renderer renderer, Scene scene, long seed, int samplesPerPixel) {
        Film film = new Film(scene.film());
        RenderReport report =
                renderer.render(scene, scene.camera(), film, context(seed, 2, RenderBudget.samples(samplesPerPixel)));
        if (report.nonFiniteSamples() != 0 || report.cancelled() || report.samplesPerPixel() != samplesPerPixel) {
            throw new AssertionError(report);
        }
        return film.develop();
    }

    /** Means of a channel over blocks of pixels, for each of several seeds. */
    static double[][] blocks(
            Renderer renderer, Scene scene, String channel, int seeds, int samplesPerPixel, int block) {
        double[][] runs = new double[seeds][];
        for (int i = 0; i < seeds; i++) {
            runs[i] = blocks(image(renderer, scene, i + 1, samplesPerPixel), channel, block);
        }
        return runs;
    }

    /** Means of a channel over blocks of pixels; incomplete blocks at the edges are left out. */
    static double[] blocks(FilmImage image, String channel, int block) {
        int columns = image.width() / block;
        int rows = image.height() / block;
        double[] means = new double[columns * rows];
        for (int y = 0; y < rows * block; y++) {
            for (int x = 0; x < columns * block; x++) {
                means[y / block * columns + x / block] += image.get(channel, x, y) / ((double) block * block);
            }
        }
        return means;
    }
}
