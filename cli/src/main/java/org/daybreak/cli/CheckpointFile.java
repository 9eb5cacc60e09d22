package org.daybreak.cli;

import java.nio.file.Path;
import java.util.Map;
import org.daybreak.cli.partial.PartialFilm;
import org.daybreak.cli.partial.PartialFilmFile;
import org.daybreak.core.render.CheckpointException;
import org.daybreak.core.render.CheckpointSink;
import org.daybreak.core.render.RenderPart;
import org.daybreak.core.render.RenderState;
import org.daybreak.exr.ImageFileException;
import org.jspecify.annotations.Nullable;

/** Writes the checkpoints of a render, each over the one before, and keeps the last state. */
final class CheckpointFile implements CheckpointSink {
    private final Map<String, String> identity;
    private final RenderPart part;
    private final @Nullable Path file;
    private final double intervalSeconds;
    private final boolean keep;
    private @Nullable PartialFilm last;

    /**
     * Creates the sink.
     *
     * @param keep whether {@link #last()} will be asked for
     */
    CheckpointFile(Map<String, String> identity, StateOptions.Choice choice, boolean keep) {
        this.identity = identity;
        this.part = choice.part();
        this.file = choice.checkpoint();
        this.intervalSeconds = file == null ? Double.POSITIVE_INFINITY : choice.intervalSeconds();
        this.keep = keep;
    }

    @Override
    public double intervalSeconds() {
        return intervalSeconds;
    }

    @Override
    public boolean takesStates() {
        return keep || file != null;
    }

    @Override
    public void save(RenderState state) {
        PartialFilm film = new PartialFilm(identity, part, state);
        if (keep) {
            last = film;
        }
        if (file != null) {
            try {
                PartialFilmFile.write(file, film);
            } catch (ImageFileException e) {
                throw new CheckpointException(
                        e.getMessage() + "; the render ends here, an earlier checkpoint in this file is intact", e);
            }
        }
    }

    /** The last state; null if none was kept. */
    @Nullable
    PartialFilm last() {
        return last;
    }
}
