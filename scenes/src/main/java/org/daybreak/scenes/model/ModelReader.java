package org.daybreak.scenes.model;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SceneDescription;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;

/** Describes the content of a mesh file as a scene of the type {@value #MODEL}, which needs no camera. */
public final class ModelReader {
    /** Type of the root of a description that lacks a view. */
    public static final String MODEL = "model";

    private static final Set<String> ENDINGS = Set.of("obj", "ply", "stl");

    private ModelReader() {}

    /** Whether a file's ending is that of a mesh. */
    public static boolean isModel(Path file) {
        return ENDINGS.contains(ending(file));
    }

    /** Whether z points up in files with this ending; else y does. */
    public static boolean zPointsUp(Path file) {
        return ending(file).equals("stl");
    }

    private static String ending(Path file) {
        String name = String.valueOf(file.getFileName());
        return name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
    }

    /** Describes a file. Nothing is read before the description is built. */
    public static SceneDescription read(Path file) {
        SourceLocation location = SourceLocation.of(file);
        String name = String.valueOf(file.getFileName());
        ObjectDescription shape = new ObjectDescription(
                ObjectKind.SHAPE,
                ending(file),
                null,
                location,
                List.of(new PropertyDescription("filename", new Value.Text(name), location)));
        ObjectDescription root = new ObjectDescription(
                ObjectKind.SCENE,
                MODEL,
                null,
                location,
                List.of(new PropertyDescription("", new Value.Nested(shape), location)));
        return new SceneDescription(file, root, Map.of(), List.of());
    }
}
