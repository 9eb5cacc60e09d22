package org.daybreak.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.Callable;
import org.daybreak.cli.partial.PartialFilm;
import org.daybreak.cli.partial.PartialFilmFile;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.render.NonFiniteLog;
import org.daybreak.core.render.RenderPart;
import org.daybreak.core.render.RenderState;
import org.daybreak.exr.ImageFileException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code daybreak merge}: puts parts of a render together. */
@Command(
        name = "merge",
        description = {
            "Puts the parts of a render together: all parts, in any order, or a single checkpoint.",
            "The image has the same bits as that of the undivided render."
        },
        footer = {
            "",
            "Examples:",
            "  daybreak render scene.xml --part 1/2 -o a.daybreak     on one machine",
            "  daybreak render scene.xml --part 2/2 -o b.daybreak     on another",
            "  daybreak merge a.daybreak b.daybreak -o picture.exr -o picture.png",
            "  daybreak merge checkpoint.daybreak -o so_far.png       what a render has so far"
        })
final class MergeCommand implements Callable<Integer> {
    private final Session session;

    @Parameters(paramLabel = "FILE", arity = "1..*", description = "Parts, or a checkpoint.")
    private List<Path> files = new ArrayList<>();

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            required = true,
            description =
                    "Image to write, by its ending; daybreak for a film that can be merged again. May be repeated.")
    private List<Path> outputs = new ArrayList<>();

    MergeCommand(Session session) {
        this.session = session;
    }

    @Override
    public Integer call() {
        List<OutputFile> targets = new ArrayList<>();
        for (Path output : outputs) {
            targets.add(OutputFile.of(output));
        }
        OutputFile.checkWritable(outputs);
        PartialFilm merged = merge();
        RenderState state = merged.state();
        Film film = new Film(state.film().settings(), state.film().layers());
        film.restore(state.film());
        FilmImage image = film.develop();
        boolean failed = false;
        for (OutputFile target : targets) {
            try {
                if (target.format() == OutputFile.Format.DAYBREAK) {
                    PartialFilmFile.write(target.path(), merged);
                } else {
                    target.write(image, ImageAttributes.of(merged.identity(), state));
                }
            } catch (ImageFileException e) {
                session.error(String.valueOf(e.getMessage()));
                failed = true;
            }
        }
        if (failed) {
            return ExitCode.OUTPUT.number();
        }
        if (state.nonFiniteSamples() > 0) {
            session.warning(state.nonFiniteSamples() + " samples were infinite or not numbers and were left out");
            return ExitCode.NON_FINITE.number();
        }
        return ExitCode.OK.number();
    }

    private PartialFilm merge() {
        PartialFilm first = read(files.get(0));
        if (first.part().isWhole()) {
            if (files.size() > 1) {
                throw new CommandException(
                        ExitCode.INPUT, files.get(0) + ": is a whole image, to which nothing can be added");
            }
            if (!first.state().complete()) {
                session.warning("the render in " + files.get(0) + " is not complete");
            }
            return first;
        }
        Map<Integer, Path> found = find(first);
        Film film =
                new Film(first.state().film().settings(), first.state().film().layers());
        NonFiniteLog nonFinite = new NonFiniteLog();
        long samples = 0;
        long samplesPerPixel = Long.MAX_VALUE;
        double seconds = 0;
        // One part after the other, in their order: the lanes of splats are added up in it.
        for (Path file : found.values()) {
            RenderState state = read(file).state();
            try {
                film.merge(state.film());
            } catch (IllegalArgumentException e) {
                throw new CommandException(ExitCode.INPUT, file + ": cannot be merged: " + e.getMessage(), e);
            }
            nonFinite.addAll(state.nonFiniteSamples(), state.nonFiniteAddresses());
            samples += state.samples();
            samplesPerPixel = Math.min(samplesPerPixel, state.samplesPerPixel());
            seconds += state.seconds();
        }
        FilmSettings settings = film.settings();
        if (film.samples() == 0) {
            samplesPerPixel = samples / ((long) settings.width() * settings.height());
        }
        RenderState state = new RenderState(
                film.state(List.of(settings.crop())),
                Map.of(),
                samples,
                samplesPerPixel,
                true,
                nonFinite.count(),
                nonFinite.addresses(),
                seconds);
        return new PartialFilm(first.identity(), RenderPart.WHOLE, state);
    }

    /** The files by the number of their part, each of which must be there once. */
    private Map<Integer, Path> find(PartialFilm first) {
        Map<Integer, Path> found = new TreeMap<>();
        for (Path file : files) {
            PartialFilm film = read(file);
            Optional<String> difference =
                    film.difference(first.identity(), files.get(0).toString());
            if (difference.isEmpty() && film.part().count() != first.part().count()) {
                difference =
                        Optional.of("it is part " + film.part() + ", " + files.get(0) + " is part " + first.part());
            }
            if (difference.isEmpty() && !film.state().complete()) {
                difference = Optional.of("it is not complete: finish it with render --resume");
            }
            if (difference.isPresent()) {
                throw new CommandException(ExitCode.INPUT, file + ": cannot be merged: " + difference.get());
            }
            Path other = found.put(film.part().index(), file);
            if (other != null) {
                throw new CommandException(ExitCode.INPUT, file + ": is part " + film.part() + ", and so is " + other);
            }
        }
        List<String> missing = new ArrayList<>();
        for (int i = 0; i < first.part().count(); i++) {
            if (!found.containsKey(i)) {
                missing.add(new RenderPart(i, first.part().count()).toString());
            }
        }
        if (!missing.isEmpty()) {
            throw new CommandException(ExitCode.INPUT, "missing parts: " + String.join(", ", missing));
        }
        return found;
    }

    private static PartialFilm read(Path file) {
        try {
            return PartialFilmFile.read(file);
        } catch (ImageFileException e) {
            throw new CommandException(ExitCode.INPUT, String.valueOf(e.getMessage()), e);
        }
    }
}
