package org.daybreak.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.daybreak.core.film.FilmLayer;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.render.Antialiasing;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RendererFactory;

/**
 * All that was decided about a render by the command line, the scene file and the defaults, in this order. Everything in it
 * is validated.
 *
 * @param scene the scene file
 * @param renderer the renderer
 * @param parameters its parameters
 * @param antialiasing the antialiasing method
 * @param antialiasingParameters its parameters
 * @param film size, crop and filter
 * @param layers auxiliary images
 * @param budget when to stop
 * @param seed seed of all random numbers
 * @param threads number of threads
 * @param outputs image files
 * @param folders folders for images besides the film's
 * @param identity all that the bits of the image depend on, see {@link org.daybreak.cli.partial.RenderIdentity}
 * @param state what is saved, continued and divided
 */
record RenderPlan(
        Path scene,
        RendererFactory renderer,
        ParameterValues parameters,
        Antialiasing antialiasing,
        ParameterValues antialiasingParameters,
        FilmSettings film,
        Set<FilmLayer> layers,
        RenderBudget budget,
        long seed,
        int threads,
        List<OutputFile> outputs,
        List<SheetFolder> folders,
        Map<String, String> identity,
        StateOptions.Choice state) {
    /** Renderer where neither command line nor scene names one. */
    static final String DEFAULT_RENDERER = "path";

    /** Antialiasing method where the command line names none. */
    static final String DEFAULT_ANTIALIASING = "sobol";

    /** Samples per pixel where neither command line nor scene gives a number. */
    static final int DEFAULT_SAMPLES = 64;

    /** Copies the collections. */
    RenderPlan {
        layers = Set.copyOf(layers);
        outputs = List.copyOf(outputs);
        folders = List.copyOf(folders);
    }

    /** The renderer's parameters by name. */
    Map<String, Object> parameterMap() {
        return parameters.asMap();
    }
}
