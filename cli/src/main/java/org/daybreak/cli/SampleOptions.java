package org.daybreak.cli;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.render.Antialiasing;
import org.daybreak.core.render.AntialiasingFactory;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RendererFactory;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.scenes.SceneFile;
import org.daybreak.scenes.build.RenderSettingsRequest;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/**
 * The options that {@code render} and {@code replay} share, as each sample depends on them. Those for the number of samples and the seed
 * say something else in each, and are theirs.
 */
final class SampleOptions {
    @Option(names = "--renderer", paramLabel = "ID", description = "Renderer; default: the scene's, else path.")
    private @Nullable String renderer;

    @Option(names = "-P", paramLabel = "NAME=VALUE", description = "Parameter of the renderer; may be repeated.")
    private Map<String, String> parameters = new LinkedHashMap<>();

    @Option(names = "-D", paramLabel = "NAME=VALUE", description = "Value for $NAME in the scene; may be repeated.")
    private Map<String, String> defines = new LinkedHashMap<>();

    @Option(names = "--antialiasing", paramLabel = "ID", description = "Antialiasing method; default: sobol.")
    private String antialiasing = RenderPlan.DEFAULT_ANTIALIASING;

    @Option(names = "-A", paramLabel = "NAME=VALUE", description = "Parameter of the antialiasing; may be repeated.")
    private Map<String, String> antialiasingParameters = new LinkedHashMap<>();

    @Option(names = "--intersector", paramLabel = "ID", description = "Intersector; default: the fastest here.")
    private @Nullable String intersector;

    @Option(names = "--size", paramLabel = "WxH", description = "Size of the image; keeps the field of view.")
    private @Nullable String size;

    /**
     * The antialiasing method.
     *
     * @param factory the method
     * @param values all its parameters
     */
    record AntialiasingChoice(AntialiasingFactory factory, ParameterValues values) {
        Antialiasing create() {
            return factory.create(values);
        }
    }

    /** Values for the names in the scene. */
    Map<String, String> defines() {
        return defines;
    }

    /** True if an intersector is named, in place of the fastest. */
    boolean namesIntersector() {
        return intersector != null;
    }

    /** Checks the intersector, if one is named; {@link ExitCode#USAGE}. */
    void checkIntersector() {
        if (intersector != null) {
            Services.checkIntersector(intersector);
        }
    }

    /**
     * The antialiasing method with its parameters; {@link ExitCode#USAGE} if there is none of the name.
     *
     * @throws ParameterException if a parameter or value is wrong
     */
    AntialiasingChoice antialiasing() {
        AntialiasingFactory factory = Services.antialiasing(antialiasing);
        return new AntialiasingChoice(
                factory, ParameterValues.parse(factory.parameters(), antialiasingParameters, factory.id()));
    }

    /**
     * The renderer, if the command line names one, with the parameters of the command line alone, to find what is wrong about them before
     * the scene is read; {@link ExitCode#USAGE} if there is none of the name.
     *
     * @throws ParameterException if a parameter or value is wrong
     */
    Optional<RendererChoice> namedRenderer() {
        if (renderer == null) {
            return Optional.empty();
        }
        RendererFactory factory = Services.renderer(renderer);
        return Optional.of(
                new RendererChoice(factory, ParameterValues.parse(factory.parameters(), parameters, renderer)));
    }

    /** The renderer with all its parameters, see {@link RendererChoice#of}. */
    RendererChoice renderer(Path scene, RenderSettingsRequest request, OptionalLong samplesPerPixel) {
        return RendererChoice.of(renderer, parameters, scene, request, samplesPerPixel);
    }

    /**
     * Gives the scene's film the size and crop of the command line; {@link ExitCode#INPUT} if it has no camera.
     *
     * @param crop {@code X,Y,W,H} in pixels, null for the scene's
     */
    FilmSettings setFilm(Path scene, SceneFile file, @Nullable String crop) {
        FilmSettings own = file.graph().film();
        if (own == null || file.graph().camera() == null) {
            throw new CommandException(ExitCode.INPUT, scene + ": the scene has no camera (<sensor>)");
        }
        FilmSettings film = FilmOptions.apply(own, size, crop);
        file.graph().setFilm(film);
        return film;
    }

    /** How the scene is compiled. */
    SceneCompiler.Options compilation(int threads) {
        return new SceneCompiler.Options(threads, intersector);
    }

    /** Checks a number of samples per pixel, if there is one; {@link ExitCode#USAGE}. */
    static void checkSamplesPerPixel(@Nullable Long samplesPerPixel) {
        if (samplesPerPixel != null && (samplesPerPixel < 1 || samplesPerPixel > Integer.MAX_VALUE)) {
            throw new CommandException(
                    ExitCode.USAGE, "--spp is " + samplesPerPixel + " but must be from 1 to " + Integer.MAX_VALUE);
        }
    }
}
