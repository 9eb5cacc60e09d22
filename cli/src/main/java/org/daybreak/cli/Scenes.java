package org.daybreak.cli;

import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.Map;
import org.daybreak.cli.partial.RenderIdentity;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.scenes.SceneFile;
import org.daybreak.scenes.SceneReader;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.image.StandardImageLoader;

/** Reads and compiles scene files; what is wrong with them becomes {@link ExitCode#INPUT}. */
final class Scenes {
    private Scenes() {}

    /** Reads a scene file and hands its warnings to the user. */
    static SceneFile load(Path file, Map<String, String> defines, Session session) {
        try {
            SceneFile scene =
                    new SceneReader(new LinearImageLoader().or(new StandardImageLoader())).load(file, defines);
            scene.warnings().forEach(warning -> session.warning(warning.toString()));
            return scene;
        } catch (SceneException e) {
            throw new CommandException(ExitCode.INPUT, String.valueOf(e.getMessage()), e);
        }
    }

    /** A digest of all that a scene depends on; {@link ExitCode#INPUT} if a file cannot be read any more. */
    static String digest(SceneFile scene, Path file, Map<String, String> defines) {
        try {
            return RenderIdentity.sceneDigest(scene.files(), defines);
        } catch (UncheckedIOException e) {
            throw new CommandException(ExitCode.INPUT, file + ": " + e.getMessage(), e);
        }
    }

    /** Compiles a scene. */
    static Scene compile(Path file, SceneFile scene, SceneCompiler.Options options) {
        try {
            return SceneCompiler.compile(scene.graph(), options);
        } catch (IllegalArgumentException e) {
            throw new CommandException(ExitCode.INPUT, file + ": " + e.getMessage(), e);
        }
    }

    /** The name of a scene: its file's without the ending, or that of the folder if the file is called scene. */
    static String name(Path file) {
        Path last = file.getFileName();
        String stem = last == null ? "scene" : stem(last.toString());
        Path folder = file.toAbsolutePath().normalize().getParent();
        Path folderName = folder == null ? null : folder.getFileName();
        return stem.equals("scene") && folderName != null ? folderName.toString() : stem;
    }

    private static String stem(String name) {
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }
}
