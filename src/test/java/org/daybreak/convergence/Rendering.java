package org.daybreak.convergence;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.render.Antialiasing;
import org.daybreak.core.render.CancellationToken;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderListener;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.render.RendererFactory;
import org.daybreak.core.scene.Scene;

/** Short ways to an image. */
final class Rendering {
    private static final Antialiasing SOBOL = new SobolSampling();

    private Rendering() {}

    /**
     * A renderer with some parameters; those that it does not have are left out, the others have their defaults.
     *
     * @param id identifier of the renderer
     */
    static Renderer renderer(String id, Map<String, String> parameters) {
        RendererFactory factory = ServiceLoader.load(RendererFactory.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(candidate -> candidate.id().equals(id))
                .findFirst()
                .orElseThrow();
        Map<String, String> known = new HashMap<>(parameters);
        List<String> names = factory.parameters().stream().map(Parameter::name).toList();
        known.keySet().retainAll(names);
        return factory.create(ParameterValues.parse(factory.parameters(), known, id));
    }

    /** A renderer with its default parameters. */
    static Renderer renderer(String id) {
        return renderer(id, Map.of());
    }

    /**
     * Parameters from one text.
     *
     * @param settings as {@code name=value} with spaces between them
     */
    static Map<String, String> parameters(String settings) {
        Map<String, String> parameters = new HashMap<>();
        for (String setting : settings.split(" ", -1)) {
            int equals = setting.indexOf('=');
            if (equals > 0) {
                parameters.put(setting.substring(0, equals), setting.substring(equals + 1));
            }
        }
        return parameters;
    }

    /** The image of a scene's own camera, with Sobol' points and all processors. */
    static FilmImage render(Renderer renderer, Scene scene, long seed, long samplesPerPixel) {
        Film film = new Film(scene.film());
        RenderReport report = render(
                renderer,
                scene,
                film,
                seed,
                samplesPerPixel,
                Runtime.getRuntime().availableProcessors(),
                SOBOL);
        assertEquals(0, report.nonFiniteSamples(), () -> "not finite: " + report.nonFiniteAddresses());
        assertFalse(report.cancelled());
        return film.develop();
    }

    /** Renders into a film. */
    static RenderReport render(
            Renderer renderer,
            Scene scene,
            Film film,
            long seed,
            long samplesPerPixel,
            int threads,
            Antialiasing antialiasing) {
        RenderContext context = new RenderContext(
                seed,
                threads,
                RenderBudget.samples(samplesPerPixel),
                antialiasing,
                new CancellationToken(),
                RenderListener.NONE);
        return renderer.render(scene, scene.camera(), film, context);
    }
}
