package org.daybreak.core.scene;

import org.daybreak.core.film.FilmSettings;
import org.jspecify.annotations.Nullable;

/**
 * An editable scene: a tree of nodes, a camera and a film. Readers and programs fill it; {@link SceneCompiler} turns it into a
 * {@link Scene}. Not thread-safe.
 */
public final class SceneGraph {
    private final Group root = new Group();
    private @Nullable CameraSettings camera;
    private @Nullable FilmSettings film;

    /** Creates an empty scene. */
    public SceneGraph() {}

    /** The root group. */
    public Group root() {
        return root;
    }

    /** The camera, null until set. */
    public @Nullable CameraSettings camera() {
        return camera;
    }

    /** Sets the camera. */
    public void setCamera(CameraSettings camera) {
        this.camera = camera;
    }

    /** The film, null until set. */
    public @Nullable FilmSettings film() {
        return film;
    }

    /** Sets the film. */
    public void setFilm(FilmSettings film) {
        this.film = film;
    }
}
