package org.daybreak.convergence;

import java.nio.file.Path;
import java.util.Map;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.scenes.SceneFile;
import org.daybreak.scenes.SceneReader;
import org.daybreak.scenes.description.SceneException;

/** The scenes of the repository. */
public final class ShippedScenes {
    private ShippedScenes() {}

    /** The repository's folder. */
    public static Path repository() {
        return Path.of(System.getProperty("daybreak.root"));
    }

    /**
     * Reads a scene.
     *
     * @param file name below {@code scenes}
     */
    public static SceneFile read(String file) throws SceneException {
        return new SceneReader().load(repository().resolve("scenes").resolve(file), Map.of());
    }

    /** Compiles with the size and filter of the file. */
    public static Scene compile(SceneGraph graph) {
        return SceneCompiler.compile(graph);
    }

    /** Compiles with a size; the filter is the box of one pixel. The field of view stays, the aspect ratio should. */
    public static Scene compile(SceneGraph graph, int width, int height) {
        graph.setFilm(new FilmSettings(width, height, ReconstructionFilter.BOX));
        return SceneCompiler.compile(graph);
    }
}
