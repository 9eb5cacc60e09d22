package org.daybreak.cli;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.daybreak.cli.partial.PartialFilm;
import org.daybreak.cli.partial.PartialFilmFile;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.render.CheckpointException;
import org.daybreak.core.render.ImageSheet;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.RenderState;
import org.daybreak.core.scene.Scene;
import org.daybreak.exr.AtomicFiles;
import org.daybreak.exr.ExrAttribute;
import org.daybreak.exr.ImageFileException;
import org.daybreak.scenes.description.SceneProblem;
import org.jspecify.annotations.Nullable;

/** Renders a compiled scene and writes what comes out of it. */
final class RenderJob {
    private final RenderPlan plan;
    private final ProgressMode mode;
    private final @Nullable Path statistics;
    private final Session session;
    private final PhaseTimes times;

    /**
     * Creates a job.
     *
     * @param statistics file for the statistics, null for none
     * @param times receives the phases to come
     */
    RenderJob(RenderPlan plan, ProgressMode mode, @Nullable Path statistics, Session session, PhaseTimes times) {
        this.plan = plan;
        this.mode = mode;
        this.statistics = statistics;
        this.session = session;
        this.times = times;
    }

    /**
     * Renders and writes.
     *
     * @param sceneWarnings what the scene file's reader warned of; goes into the statistics
     */
    ExitCode run(Scene scene, List<SceneProblem> sceneWarnings) {
        Film film = newFilm();
        boolean writesState = plan.outputs().stream().anyMatch(o -> o.format() == OutputFile.Format.DAYBREAK);
        CheckpointFile checkpoints = new CheckpointFile(plan.identity(), plan.state(), writesState);
        ProgressDisplay progress = ProgressDisplay.of(mode, session);
        RenderContext context = new RenderContext(
                plan.seed(),
                plan.threads(),
                plan.budget(),
                plan.antialiasing(),
                session.interrupts().cancellation(),
                progress,
                plan.state().part(),
                plan.state().start(),
                checkpoints);
        session.interrupts().protectImage();
        times.begin("render");
        RenderReport report;
        try {
            report = plan.renderer().create(plan.parameters()).render(scene, scene.camera(), film, context);
        } catch (CheckpointException e) {
            throw new CommandException(ExitCode.OUTPUT, String.valueOf(e.getMessage()), e);
        } finally {
            times.end();
            progress.close();
        }
        times.begin("write");
        FilmImage image = film.develop();
        RenderState start = plan.state().start();
        double seconds = times.wall("render") + (start == null ? 0 : start.seconds());
        Map<String, ExrAttribute> attributes = ImageAttributes.of(plan, report, seconds);
        List<OutputFile> written = new ArrayList<>();
        boolean failed = !write(image, attributes, checkpoints.last(), written);
        failed |= !writeSheets(report, image, attributes, written);
        times.end();
        List<String> warnings = new ArrayList<>();
        for (SceneProblem warning : sceneWarnings) {
            warnings.add(warning.toString());
        }
        warnings.addAll(ownWarnings(report));
        failed |= !writeStatistics(scene, report, film.relativeError(), warnings, written);
        progress.finished(report, times.wall("render"), written);
        if (failed) {
            return ExitCode.OUTPUT;
        }
        return report.nonFiniteSamples() > 0 ? ExitCode.NON_FINITE : ExitCode.OK;
    }

    private Film newFilm() {
        try {
            return new Film(plan.film(), plan.layers());
        } catch (IllegalArgumentException e) {
            throw new CommandException(ExitCode.USAGE, String.valueOf(e.getMessage()), e);
        }
    }

    /** Writes all images, also if one fails: a render is too dear to lose the others. */
    private boolean write(
            FilmImage image,
            Map<String, ExrAttribute> attributes,
            @Nullable PartialFilm state,
            List<OutputFile> written) {
        boolean all = true;
        for (OutputFile output : plan.outputs()) {
            try {
                if (output.format() != OutputFile.Format.DAYBREAK) {
                    output.write(image, attributes);
                } else if (state != null) {
                    PartialFilmFile.write(output.path(), state);
                }
                written.add(output);
            } catch (ImageFileException e) {
                session.error(String.valueOf(e.getMessage()));
                all = false;
            }
        }
        return all;
    }

    private boolean writeSheets(
            RenderReport report, FilmImage image, Map<String, ExrAttribute> attributes, List<OutputFile> written) {
        boolean all = true;
        for (SheetFolder folder : plan.folders()) {
            ImageSheet sheet = report.sheets().get(folder.parameter());
            if (sheet == null) {
                continue;
            }
            try {
                folder.write(sheet, image, attributes, written);
            } catch (ImageFileException e) {
                session.error(String.valueOf(e.getMessage()));
                all = false;
            }
        }
        return all;
    }

    private boolean writeStatistics(
            Scene scene, RenderReport report, double relativeError, List<String> warnings, List<OutputFile> written) {
        Path file = statistics;
        if (file == null) {
            return true;
        }
        Map<String, Object> values =
                new Statistics(plan, times, scene, report, relativeError, warnings, written).values();
        try {
            AtomicFiles.write(file, JsonText.document(values).getBytes(StandardCharsets.UTF_8));
            return true;
        } catch (ImageFileException e) {
            session.error(String.valueOf(e.getMessage()));
            return false;
        }
    }

    private List<String> ownWarnings(RenderReport report) {
        List<String> warnings = new ArrayList<>(report.warnings());
        if (report.nonFiniteSamples() > 0) {
            warnings.add(
                    report.nonFiniteSamples() + " samples were infinite or not numbers and were left out; the first: "
                            + String.join("; ", report.nonFiniteAddresses()));
        }
        if (report.cancelled()) {
            warnings.add("interrupted: the image holds what was rendered so far");
        }
        warnings.forEach(session::warning);
        return warnings;
    }
}
