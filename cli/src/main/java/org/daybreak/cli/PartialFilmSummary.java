package org.daybreak.cli;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import org.daybreak.cli.partial.PartialFilm;
import org.daybreak.cli.partial.PartialFilmFile;
import org.daybreak.core.render.RenderState;
import org.daybreak.exr.ImageFileException;

/** What {@code info} says about a partial film. */
final class PartialFilmSummary {
    private PartialFilmSummary() {}

    /** Names and values in order; {@link ExitCode#INPUT} if the file cannot be read. */
    static Map<String, String> of(Path file) {
        PartialFilm film;
        try {
            film = PartialFilmFile.read(file);
        } catch (ImageFileException e) {
            throw new CommandException(ExitCode.INPUT, String.valueOf(e.getMessage()), e);
        }
        RenderState state = film.state();
        Map<String, String> lines = new LinkedHashMap<>();
        lines.put("format", "Daybreak partial film");
        lines.put("part", film.part().toString());
        lines.put("complete", state.complete() ? "yes" : "no");
        lines.put("samples", Long.toString(state.samples()));
        lines.put("samplesPerPixel", Long.toString(state.samplesPerPixel()));
        lines.put("renderSeconds", String.format(Locale.ROOT, "%.3f", state.seconds()));
        film.identity().forEach(lines::put);
        PartialFilmFile.checksums(film).forEach((name, sum) -> lines.put(name, String.format("%08x", sum)));
        return lines;
    }
}
