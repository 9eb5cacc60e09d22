package org.daybreak.cli;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.daybreak.cli.partial.RenderIdentity;
import org.daybreak.core.light.RadianceMap;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrWriteOptions;
import org.daybreak.exr.ExrWriter;
import org.daybreak.exr.PixelType;
import org.daybreak.scenes.InputFormats;
import org.daybreak.scenes.SceneConverter;
import org.daybreak.scenes.SceneFile;
import org.daybreak.scenes.SceneReader;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.image.ImageLoader;
import org.daybreak.scenes.image.StandardImageLoader;

/** Reads and compiles scene files; what is wrong with them becomes {@link ExitCode#INPUT}. */
final class Scenes {
    private Scenes() {}

    /** Whether a file's ending is that of a scene or model. */
    static boolean isScene(Path file) {
        return InputFormats.formats().stream()
                .anyMatch(format -> format.endings().contains(ImageLoader.ending(file)));
    }

    /** Reads a scene file and hands its warnings to the user. */
    static SceneFile load(Path file, Map<String, String> defines, Session session) {
        try {
            SceneFile scene = new SceneReader(images()).load(file, defines);
            scene.warnings().forEach(warning -> session.warning(warning.toString()));
            return scene;
        } catch (SceneException e) {
            throw new CommandException(ExitCode.INPUT, String.valueOf(e.getMessage()), e);
        }
    }

    /** Writes a scene in the native format; {@link ExitCode#OUTPUT} if that fails. */
    static void convert(Path input, Map<String, String> defines, Path output, Session session) {
        try {
            new SceneConverter(images(), Scenes::exr)
                    .convert(input, defines, output)
                    .forEach(warning -> session.warning(warning.toString()));
        } catch (SceneException e) {
            throw new CommandException(ExitCode.INPUT, String.valueOf(e.getMessage()), e);
        } catch (AccessDeniedException e) {
            throw new CommandException(ExitCode.OUTPUT, output + ": cannot be written: permission is denied", e);
        } catch (IOException e) {
            throw new CommandException(ExitCode.OUTPUT, output + ": cannot be written: " + e.getMessage(), e);
        }
    }

    private static ImageLoader images() {
        return new LinearImageLoader().or(new StandardImageLoader());
    }

    private static byte[] exr(RadianceMap panorama) throws IOException {
        float[] rgb = panorama.rgb();
        ExrImage.Builder image = ExrImage.builder(panorama.width(), panorama.height());
        for (int c = 0; c < 3; c++) {
            float[] plane = new float[rgb.length / 3];
            for (int i = 0; i < plane.length; i++) {
                plane[i] = rgb[3 * i + c];
            }
            image.channel("RGB".substring(c, c + 1), PixelType.FLOAT, plane);
        }
        return ExrWriter.toBytes("the light", List.of(image.build()), ExrWriteOptions.defaults());
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
