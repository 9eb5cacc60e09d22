package org.daybreak.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.daybreak.cli.partial.PartialFilmFile;
import org.daybreak.cli.partial.RenderIdentity;
import org.daybreak.core.accel.Intersectors;
import org.daybreak.core.film.FilmLayer;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderPart;
import org.daybreak.core.render.RendererFactory;
import org.daybreak.core.scene.Scene;
import org.daybreak.scenes.SceneFile;
import org.daybreak.scenes.build.RenderSettingsRequest;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code daybreak render}: renders a scene file. */
@Command(
        name = "render",
        description = "Renders a scene or model.",
        footer = {
            "",
            "Examples:",
            "  daybreak render scene.xml",
            "      renders as the scene asks; writes <name>.exr and <name>.png here",
            "  daybreak render scene.xml -o picture.exr --spp 256 --seed 7",
            "  daybreak render model.glb --size 1280x960 -o model.png",
            "  daybreak render scene.xml --time 60 --size 1920x1080 -o big.png",
            "  daybreak render scene.xml --renderer raytracer -P maxDepth=4",
            "  daybreak render scene.xml --antialiasing grid -A gridSize=4 -D spp=16",
            "  daybreak render scene.xml --spp 4096 --checkpoint c.daybreak",
            "  daybreak render scene.xml --spp 4096 --checkpoint c.daybreak --resume c.daybreak",
            "  daybreak render scene.xml --layers albedo,normal -o layers.exr --stats s.json",
            "",
            "Ctrl-C writes the image so far; a second Ctrl-C ends the program at once."
        })
final class RenderCommand implements Callable<Integer> {
    private static final int MOST_THREADS = 1024;

    private final Session session;

    @Parameters(paramLabel = "SCENE", description = "Scene (xml, gltf, glb) or model (obj, ply, stl).")
    private Path scene = Path.of("");

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            description = "Image to write, by its ending: exr, pfm, png, hdr, jpg or daybreak; may be repeated."
                    + " Default: <name>.exr and <name>.png in the working directory.")
    private List<Path> outputs = new ArrayList<>();

    @Mixin
    private SampleOptions options = new SampleOptions();

    @Option(names = "--crop", paramLabel = "X,Y,W,H", description = "Renders this part of the image only.")
    private @Nullable String crop;

    @Option(
            names = "--spp",
            paramLabel = "N",
            description = {
                "Samples per pixel; mutations of Markov chains.",
                "Default: the scene's, else 64 (chains: 100);",
                "unlimited with --time or --target-error."
            })
    private @Nullable Long samplesPerPixel;

    @Option(
            names = "--time",
            paramLabel = "SECONDS",
            description = "Stop after this time, counted from the compiled scene on.")
    private @Nullable Double seconds;

    @Option(
            names = "--target-error",
            paramLabel = "E",
            description = "Stop after the pass at which the estimated relative error of the image is below E.")
    private @Nullable Double targetError;

    @Option(
            names = "--seed",
            paramLabel = "N",
            description = "Seed of all random numbers; default: the scene's, else 0.")
    private @Nullable Long seed;

    @Option(
            names = "--threads",
            paramLabel = "N",
            description = "Threads; default: all processors. Same image for any N.")
    private @Nullable Integer threads;

    @Option(
            names = "--layers",
            paramLabel = "LAYER",
            split = ",",
            description = "Further images in the EXR file: albedo, normal, depth, variance.")
    private List<String> layers = new ArrayList<>();

    @Option(names = "--progress", paramLabel = "MODE", description = "Progress on stderr: auto, plain, json or none.")
    private String progress = "auto";

    @Option(names = "--stats", paramLabel = "FILE", description = "Writes statistics as JSON.")
    private @Nullable Path statistics;

    @Mixin
    private StateOptions states = new StateOptions();

    RenderCommand(Session session) {
        this.session = session;
    }

    @Override
    public Integer call() {
        PhaseTimes times = new PhaseTimes();
        times.begin("load");
        states.check();
        List<OutputFile> files = outputFiles();
        ProgressMode mode = ProgressMode.of(progress);
        options.checkIntersector();
        if (!options.namesIntersector()) {
            Intersectors.warmUp();
        }
        // Whatever can be wrong about the command line alone is found before the scene is read.
        SampleOptions.AntialiasingChoice antialiasing = options.antialiasing();
        Set<FilmLayer> filmLayers = filmLayers(files);
        int threadCount = threads();
        RenderBudget given = budget(RenderPlan.DEFAULT_SAMPLES);
        if (given.targetError() > 0 && states.hasPart()) {
            throw new CommandException(ExitCode.USAGE, "--target-error cannot be used with --part");
        }
        options.namedRenderer()
                .ifPresent(named ->
                        SheetFolder.check(SheetFolder.of(named.factory(), named.values()), outputPaths(files)));

        SceneFile file = Scenes.load(scene, options.defines(), session);
        RenderSettingsRequest request = file.request();
        FilmSettings film = options.setFilm(scene, file, crop);
        RenderBudget budget = request.samplesPerPixel().isPresent()
                ? budget(request.samplesPerPixel().getAsInt())
                : given;
        RendererChoice choice = options.renderer(scene, request, samplesAskedFor(request));
        RendererFactory factory = choice.factory();
        ParameterValues values = choice.values();
        List<SheetFolder> folders = SheetFolder.of(factory, values);
        SheetFolder.check(folders, outputPaths(files));
        checkResumable(factory, values, files);
        long actualSeed = seed != null ? seed : request.seed().orElse(0);
        Map<String, String> identity = identity(file, needState(files), film, filmLayers, budget);
        identity.put(RenderIdentity.RENDERER, factory.id());
        identity.put(RenderIdentity.PARAMETERS, JsonText.line(choice.imageParameters()));
        identity.put(RenderIdentity.ANTIALIASING, antialiasing.factory().id());
        identity.put(
                RenderIdentity.ANTIALIASING_PARAMETERS,
                JsonText.line(antialiasing.values().asMap()));
        identity.put(RenderIdentity.SEED, Long.toString(actualSeed));
        RenderPlan plan = new RenderPlan(
                scene,
                factory,
                values,
                antialiasing.create(),
                antialiasing.values(),
                film,
                filmLayers,
                budget,
                actualSeed,
                threadCount,
                files,
                folders,
                identity,
                states.choose(identity));
        times.begin("compile");
        Scene compiled = Scenes.compile(scene, file, options.compilation(threadCount));
        RenderJob job = new RenderJob(plan, mode, statistics, session, times);
        return job.run(compiled, file.warnings()).number();
    }

    private boolean needState(List<OutputFile> files) {
        return states.needState() || files.stream().anyMatch(f -> f.format() == OutputFile.Format.DAYBREAK);
    }

    private void checkResumable(RendererFactory factory, ParameterValues values, List<OutputFile> files) {
        if (needState(files) && !factory.create(values).isResumable()) {
            String further = SheetFolder.of(factory, values).stream()
                    .map(folder -> " with -P " + folder.parameter())
                    .collect(Collectors.joining());
            throw new CommandException(
                    ExitCode.USAGE,
                    "renderer '" + factory.id() + "'" + further
                            + " can neither be resumed nor cut into parts: leave out"
                            + " --checkpoint, --resume, --part and outputs with the ending daybreak");
        }
    }

    /**
     * What the bits of the image depend on, but for the algorithms.
     *
     * @param withScene false to leave out the digest of the scene, for which all its files are read once more
     */
    private Map<String, String> identity(
            SceneFile file, boolean withScene, FilmSettings film, Set<FilmLayer> filmLayers, RenderBudget budget) {
        Map<String, String> identity = new LinkedHashMap<>();
        identity.put(RenderIdentity.SOFTWARE, Version.software());
        if (withScene) {
            identity.put(RenderIdentity.SCENE, Scenes.digest(file, scene, options.defines()));
        }
        identity.put(RenderIdentity.SAMPLES_PER_PIXEL, Long.toString(budget.samplesPerPixel()));
        identity.put(RenderIdentity.TARGET_ERROR, Double.toString(budget.targetError()));
        identity.put(RenderIdentity.SIZE, film.width() + "x" + film.height());
        identity.put(RenderIdentity.CROP, film.crop().toString());
        identity.put(
                RenderIdentity.FILTER,
                film.filter().kind().id() + " " + film.filter().radius() + " "
                        + film.filter().parameter() + (film.filterSampling() ? " sampled" : ""));
        List<String> names = new ArrayList<>();
        for (FilmLayer layer : FilmLayer.values()) {
            if (filmLayers.contains(layer)) {
                names.add(layer.id());
            }
        }
        identity.put(RenderIdentity.LAYERS, String.join(",", names));
        return identity;
    }

    private List<OutputFile> outputFiles() {
        List<Path> paths = outputs;
        if (paths.isEmpty()) {
            String name = Scenes.name(scene);
            RenderPart part = states.part();
            paths = part.isWhole()
                    ? List.of(Path.of(name + ".exr"), Path.of(name + ".png"))
                    : List.of(Path.of(
                            name + "." + (part.index() + 1) + "of" + part.count() + "." + PartialFilmFile.ENDING));
        }
        List<OutputFile> files = new ArrayList<>();
        for (Path path : paths) {
            files.add(OutputFile.of(path));
        }
        if (states.hasPart() && files.stream().anyMatch(f -> f.format() != OutputFile.Format.DAYBREAK)) {
            throw new CommandException(
                    ExitCode.USAGE,
                    "a part of an image can only be written to a file with the ending " + PartialFilmFile.ENDING);
        }
        OutputFile.checkWritable(outputPaths(files));
        return files;
    }

    private List<Path> outputPaths(List<OutputFile> files) {
        List<Path> all = new ArrayList<>();
        files.forEach(file -> all.add(file.path()));
        all.addAll(states.files());
        if (statistics != null) {
            all.add(statistics);
        }
        return all;
    }

    private Set<FilmLayer> filmLayers(List<OutputFile> files) {
        Set<FilmLayer> chosen = FilmOptions.layers(layers);
        if (!chosen.isEmpty()
                && files.stream()
                        .noneMatch(file -> file.format() == OutputFile.Format.EXR
                                || file.format() == OutputFile.Format.DAYBREAK)) {
            throw new CommandException(ExitCode.USAGE, "--layers needs an output file with the ending exr");
        }
        return chosen;
    }

    private int threads() {
        if (threads == null) {
            return Runtime.getRuntime().availableProcessors();
        }
        if (threads < 1 || threads > MOST_THREADS) {
            throw new CommandException(
                    ExitCode.USAGE, "--threads is " + threads + " but must be from 1 to " + MOST_THREADS);
        }
        return threads;
    }

    /** Samples per pixel of the command line, else of the scene if there is no other limit; empty if nobody asks for a number. */
    private OptionalLong samplesAskedFor(RenderSettingsRequest request) {
        if (samplesPerPixel != null) {
            return OptionalLong.of(samplesPerPixel);
        }
        return seconds == null
                        && targetError == null
                        && request.samplesPerPixel().isPresent()
                ? OptionalLong.of(request.samplesPerPixel().getAsInt())
                : OptionalLong.empty();
    }

    private RenderBudget budget(int samplesOtherwise) {
        SampleOptions.checkSamplesPerPixel(samplesPerPixel);
        if (seconds != null && !(seconds > 0)) {
            throw new CommandException(ExitCode.USAGE, "--time is " + seconds + " but must be greater than 0 seconds");
        }
        if (targetError != null && !(targetError > 0 && targetError < 1)) {
            throw new CommandException(
                    ExitCode.USAGE, "--target-error is " + targetError + " but must be between 0 and 1");
        }
        long samples = samplesPerPixel != null
                ? samplesPerPixel
                : seconds == null && targetError == null ? samplesOtherwise : Integer.MAX_VALUE;
        return new RenderBudget(
                samples, seconds == null ? Double.POSITIVE_INFINITY : seconds, targetError == null ? 0 : targetError);
    }
}
