package org.daybreak.scenes;

import java.io.IOException;
import java.nio.file.Path;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.io.TempDir;

/** What tests of the scene reader share: a folder, and scenes in it with some content. */
abstract class SceneReading {
    @TempDir
    Path folder;

    /** A scene with a camera, a light and what is given. */
    SceneFile load(String content) throws IOException, SceneException {
        return SceneTexts.load(folder, SceneTexts.scene(content));
    }

    /** The only shape of what is given. */
    ShapeNode shape(String content) throws IOException, SceneException {
        return SceneTexts.onlyShape(load(content));
    }
}
