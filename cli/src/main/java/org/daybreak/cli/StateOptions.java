package org.daybreak.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.daybreak.cli.partial.PartialFilm;
import org.daybreak.cli.partial.PartialFilmFile;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.RenderPart;
import org.daybreak.core.render.RenderState;
import org.daybreak.exr.ImageFileException;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Option;

/** The options of {@code render} that save, continue and divide a render. */
final class StateOptions {
    private static final double DEFAULT_INTERVAL = 60;
    private static final Pattern PART = Pattern.compile("([1-9][0-9]{0,8})/([1-9][0-9]{0,8})");

    @Option(
            names = "--checkpoint",
            paramLabel = "FILE",
            description = "Saves the state of the render from time to time and at its end, to go on with --resume.")
    private @Nullable Path checkpoint;

    @Option(
            names = "--checkpoint-interval",
            paramLabel = "SECONDS",
            description = "How much work may be lost at most; default: 60.")
    private @Nullable Double interval;

    @Option(
            names = "--resume",
            paramLabel = "FILE",
            description = "Goes on from a checkpoint; ends with the same bits as without the interruption.")
    private @Nullable Path resume;

    @Option(
            names = "--part",
            paramLabel = "I/N",
            description = "Renders part I of N, into a file with the ending daybreak; see 'merge'.")
    private @Nullable String part;

    /**
     * What was decided about the state of a render.
     *
     * @param part the part of the work
     * @param start the state to go on from, null to begin
     * @param checkpoint where checkpoints go, null for nowhere
     * @param intervalSeconds how much work may be lost
     */
    record Choice(
            RenderPart part,
            @Nullable RenderState start,
            @Nullable Path checkpoint,
            double intervalSeconds) {}

    /** The files that will be written. */
    List<Path> files() {
        return checkpoint == null ? List.of() : List.of(checkpoint);
    }

    /** True if some of these options, or an output file, needs a renderer that can hand out its state. */
    boolean needState() {
        return checkpoint != null || resume != null || part != null;
    }

    /** True if only a part is rendered. */
    boolean hasPart() {
        return !part().isWhole();
    }

    /** The part that is asked for; {@link ExitCode#USAGE} if it has the wrong form or does not exist. */
    RenderPart part() {
        if (part == null) {
            return RenderPart.WHOLE;
        }
        Matcher matcher = PART.matcher(part.trim());
        if (!matcher.matches()) {
            throw new CommandException(
                    ExitCode.USAGE, "--part is '" + part + "' but must be of the form I/N, such as 2/5");
        }
        try {
            return new RenderPart(Integer.parseInt(matcher.group(1)) - 1, Integer.parseInt(matcher.group(2)));
        } catch (ParameterException e) {
            throw new CommandException(ExitCode.USAGE, "--part: " + e.getMessage(), e);
        }
    }

    /** Checks what does not need the scene; {@link ExitCode#USAGE}. */
    void check() {
        part();
        if (interval != null && !(interval > 0)) {
            throw new CommandException(
                    ExitCode.USAGE, "--checkpoint-interval is " + interval + " but must be greater than 0 seconds");
        }
        if (interval != null && checkpoint == null) {
            throw new CommandException(ExitCode.USAGE, "--checkpoint-interval needs --checkpoint");
        }
    }

    /**
     * Reads the state to go on from.
     *
     * @param identity what is rendered
     */
    Choice choose(Map<String, String> identity) {
        return new Choice(part(), start(identity), checkpoint, interval == null ? DEFAULT_INTERVAL : interval);
    }

    private @Nullable RenderState start(Map<String, String> identity) {
        if (resume == null) {
            return null;
        }
        PartialFilm film;
        try {
            film = PartialFilmFile.read(resume);
        } catch (ImageFileException e) {
            throw new CommandException(ExitCode.INPUT, String.valueOf(e.getMessage()), e);
        }
        Optional<String> difference = film.difference(identity, "this render");
        if (difference.isEmpty() && !film.part().equals(part())) {
            difference = Optional.of(
                    film.part().isWhole()
                            ? "it is the whole image, not part " + part()
                            : "it is part " + film.part() + (part == null ? ": give --part " + film.part() : ""));
        }
        if (difference.isPresent()) {
            throw new CommandException(ExitCode.INPUT, resume + ": cannot be resumed here: " + difference.get());
        }
        return film.state();
    }
}
