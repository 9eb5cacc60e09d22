package org.daybreak.cli;

import java.nio.file.Path;
import java.util.OptionalLong;
import java.util.concurrent.Callable;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.render.Antialiasing;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.SampleAddress;
import org.daybreak.core.render.SampleRecord;
import org.daybreak.core.render.SampleRequest;
import org.daybreak.core.scene.Scene;
import org.daybreak.scenes.SceneFile;
import org.daybreak.scenes.build.RenderSettingsRequest;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code daybreak replay}: computes one sample of a render once more and says what happened. */
@Command(
        name = "replay",
        description = {
            "Computes one sample of a render once more and prints its paths: vertices, densities, weights.",
            "The options that the render was given must be given again: its random numbers depend on them."
        },
        footer = {
            "",
            "Examples:",
            "  daybreak replay scene.xml --renderer bidirectional --pixel 120,80 --sample 3",
            "  daybreak replay scene.xml --renderer bidirectional --spp 256 --seed 7 --pixel 0,0 --json",
            "  daybreak replay scene.xml --renderer bidirectional --address 'seed 0, pixel (3, 4), sample 5'",
            "      as statistics and warnings name samples that were infinite or not numbers"
        })
final class ReplayCommand implements Callable<Integer> {
    private final Session session;

    @Parameters(paramLabel = "SCENE", description = "Scene (Mitsuba XML) or model (obj, ply, stl).")
    private Path scene = Path.of("");

    @Option(names = "--pixel", paramLabel = "X,Y", description = "Column and row of the pixel in the whole image.")
    private @Nullable String pixel;

    @Option(names = "--sample", paramLabel = "N", description = "Number of the sample in the pixel; default: 0.")
    private @Nullable Long sample;

    @Option(
            names = "--address",
            paramLabel = "TEXT",
            description = "Seed, pixel and sample as a report names them, in place of the options for each.")
    private @Nullable String address;

    @Mixin
    private SampleOptions options = new SampleOptions();

    @Option(
            names = "--spp",
            paramLabel = "N",
            description = "Samples per pixel of the render; default: the scene's, else 64.")
    private @Nullable Long samplesPerPixel;

    @Option(names = "--seed", paramLabel = "N", description = "Seed of the render; default: the scene's, else 0.")
    private @Nullable Long seed;

    @Option(names = "--json", description = "Prints JSON.")
    private boolean json;

    ReplayCommand(Session session) {
        this.session = session;
    }

    @Override
    public Integer call() {
        checkAddress();
        SampleOptions.checkSamplesPerPixel(samplesPerPixel);
        options.checkIntersector();
        // Whatever can be wrong about the command line alone is found before the scene is read.
        Antialiasing method = options.antialiasing().create();
        options.namedRenderer();
        SceneFile file = Scenes.load(scene, options.defines(), session);
        RenderSettingsRequest request = file.request();
        FilmSettings film = options.setFilm(scene, file, null);
        long samples = samplesPerPixel != null
                ? samplesPerPixel
                : request.samplesPerPixel().orElse(RenderPlan.DEFAULT_SAMPLES);
        RendererChoice choice = options.renderer(scene, request, OptionalLong.of(samples));
        SampleRequest wanted = new SampleRequest(address(request), film, method, method.samplesPerPixel(samples));
        Scene compiled = Scenes.compile(
                scene, file, options.compilation(Runtime.getRuntime().availableProcessors()));
        SampleRecord record = choice.factory()
                .create(choice.values())
                .replay(compiled, compiled.camera(), wanted)
                .orElseThrow(() -> new CommandException(
                        ExitCode.USAGE,
                        "renderer '" + choice.factory().id() + "' cannot replay samples; 'bidirectional' can"));
        ReplayText text = new ReplayText(Scenes.name(scene), choice.factory().id(), wanted, record);
        session.out().print(json ? text.json() : text.text());
        session.out().flush();
        return ExitCode.OK.number();
    }

    private void checkAddress() {
        if (address == null && pixel == null) {
            throw new CommandException(ExitCode.USAGE, "--pixel X,Y or --address is missing");
        }
        if (address != null && (pixel != null || sample != null || seed != null)) {
            throw new CommandException(
                    ExitCode.USAGE, "--address stands for --pixel, --sample and --seed and cannot be used with them");
        }
        if (address != null) {
            parsed(address);
        } else {
            pixel();
        }
    }

    private static SampleAddress parsed(String text) {
        try {
            return SampleAddress.parse(text);
        } catch (ParameterException e) {
            throw new CommandException(ExitCode.USAGE, "--address: " + e.getMessage(), e);
        }
    }

    private int[] pixel() {
        return FilmOptions.numbers("--pixel", String.valueOf(pixel), ",", "X,Y, such as 120,80", 2);
    }

    private SampleAddress address(RenderSettingsRequest request) {
        if (address != null) {
            return parsed(address);
        }
        int[] xy = pixel();
        long actualSeed = seed != null ? seed : request.seed().orElse(0);
        return new SampleAddress(actualSeed, xy[0], xy[1], sample == null ? 0 : sample);
    }
}
