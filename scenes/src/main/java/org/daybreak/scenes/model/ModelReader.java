package org.daybreak.scenes.model;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SceneDescription;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.daybreak.scenes.image.ImageLoader;
import org.jspecify.annotations.Nullable;

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

    /**
     * Describes a file. Of the mesh itself only the names of materials are read.
     *
     * @param images reads bump maps of material files
     * @param problems receives errors and warnings about material files
     */
    public static SceneDescription read(Path file, ImageLoader images, ProblemList problems) {
        List<Path> files = new ArrayList<>(List.of(file));
        List<ObjectDescription> shapes =
                ending(file).equals("obj") ? objShapes(file, images, problems, files) : List.of();
        if (shapes.isEmpty()) {
            shapes = List.of(shape(file, null, List.of()));
        }
        SourceLocation location = SourceLocation.of(file);
        List<PropertyDescription> content = new ArrayList<>();
        for (ObjectDescription shape : shapes) {
            content.add(new PropertyDescription("", new Value.Nested(shape), location));
        }
        ObjectDescription root = new ObjectDescription(ObjectKind.SCENE, MODEL, null, location, content);
        return new SceneDescription(file, root, Map.of(), List.of(), files);
    }

    private static ObjectDescription shape(Path file, @Nullable String material, List<PropertyDescription> more) {
        SourceLocation location = SourceLocation.of(file);
        List<PropertyDescription> properties = new ArrayList<>(more);
        properties.add(
                new PropertyDescription("filename", new Value.Text(String.valueOf(file.getFileName())), location));
        if (material != null) {
            properties.add(new PropertyDescription("material", new Value.Text(material), location));
        }
        return new ObjectDescription(
                ObjectKind.SHAPE,
                ending(file),
                material == null || material.isEmpty() ? null : material,
                location,
                properties);
    }

    /** One shape for each material; none if the file uses no materials or cannot be read, which is reported elsewhere. */
    private static List<ObjectDescription> objShapes(
            Path file, ImageLoader images, ProblemList problems, List<Path> files) {
        ObjMaterials used;
        try {
            used = ObjMaterials.of(file);
        } catch (IOException e) {
            return List.of();
        }
        if (used.names().isEmpty() || (used.names().size() == 1 && used.names().contains(""))) {
            return List.of();
        }
        Map<String, MtlMaterial> materials = new HashMap<>();
        for (String library : used.libraries()) {
            for (MtlMaterial material : MtlReader.read(file, library, problems, files)) {
                materials.putIfAbsent(material.name(), material);
            }
        }
        List<ObjectDescription> shapes = new ArrayList<>();
        for (String name : used.names()) {
            MtlMaterial material = materials.get(name);
            if (material == null && !name.isEmpty()) {
                problems.unknownNameWarning(
                        SourceLocation.of(file), "no material file defines '" + name + "'", name, materials.keySet());
            }
            shapes.add(shape(file, name, material == null ? List.of() : material.describe(images)));
        }
        return shapes;
    }
}
