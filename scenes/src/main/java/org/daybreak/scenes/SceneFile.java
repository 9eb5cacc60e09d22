package org.daybreak.scenes;

import java.nio.file.Path;
import java.util.List;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.scenes.build.RenderSettingsRequest;
import org.daybreak.scenes.description.SceneProblem;

/**
 * A scene that was read from a file.
 *
 * @param graph the scene, with camera and film set
 * @param request what the file asks of the renderer; parts it does not mention are empty
 * @param warnings what was put right or passed over
 * @param files all files that were read for it, the main file first: what the scene is depends on nothing else but the
 *     definitions that were given
 */
public record SceneFile(
        SceneGraph graph, RenderSettingsRequest request, List<SceneProblem> warnings, List<Path> files) {
    /** Copies the lists. */
    public SceneFile {
        warnings = List.copyOf(warnings);
        files = List.copyOf(files);
    }
}
