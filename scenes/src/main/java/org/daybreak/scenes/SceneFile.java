package org.daybreak.scenes;

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
 */
public record SceneFile(SceneGraph graph, RenderSettingsRequest request, List<SceneProblem> warnings) {
    /** Copies the warnings. */
    public SceneFile {
        warnings = List.copyOf(warnings);
    }
}
