package org.daybreak.scenes.write;

import java.io.IOException;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.StringJoiner;
import javax.vecmath.Matrix4d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.scenes.build.BuiltMesh;
import org.daybreak.scenes.build.LinearColors;
import org.daybreak.scenes.build.PluginDefinition;
import org.daybreak.scenes.build.Plugins;
import org.daybreak.scenes.build.PropertyDefinition;
import org.daybreak.scenes.build.SceneBuilder;
import org.daybreak.scenes.build.ValueType;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SceneDescription;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.daybreak.scenes.mesh.PlyWriter;
import org.daybreak.scenes.model.ModelReader;
import org.daybreak.scenes.view.AutoView;

/**
 * Writes a scene that has been built as a file of the native format (Mitsuba 3's XML), with its meshes as binary PLY files and
 * copies of its images in a folder beside it. Read again it is the same scene, bit for bit: numbers are written with as many
 * digits as they need. Includes, definitions, names of before Mitsuba 3 and spectra by wavelength are resolved.
 */
public final class SceneWriter {
    private final SceneDescription description;
    private final IdentityHashMap<ObjectDescription, BuiltMesh> meshes;
    private final boolean model;
    private final ObjectNames names;
    private final Attachments attachments;

    private final IdentityHashMap<TriangleMesh, String> meshFiles = new IdentityHashMap<>();
    private final IdentityHashMap<byte[], String> contentFiles = new IdentityHashMap<>();
    private final Map<Path, String> copiedFiles = new HashMap<>();
    private final Set<ObjectDescription> written = Collections.newSetFromMap(new IdentityHashMap<>());
    private final ObjectDescription neutralGrey;
    private final ObjectDescription neutralColored;

    private SceneWriter(
            SceneDescription description,
            IdentityHashMap<ObjectDescription, BuiltMesh> meshes,
            boolean model,
            Attachments attachments) {
        this.description = description;
        this.meshes = meshes;
        this.model = model;
        this.names = new ObjectNames(description);
        this.attachments = attachments;
        SourceLocation location = SourceLocation.of(description.file());
        this.neutralGrey = neutral("neutral", new Value.RealNumber(AutoView.NEUTRAL_ALBEDO), location);
        this.neutralColored = neutral("vertex_colors", vertexColors(location), location);
    }

    /**
     * Writes a scene: all of it or nothing. The other files get into a folder {@code NAME_files}, under names that contain a
     * digest of their content, where those of an older scene file stay.
     *
     * @param description what the scene was built from, without errors
     * @param result what was built from it
     * @param additions what was added to the result afterwards
     * @param panoramas encodes the light that may have been added
     * @param output the file to write or replace
     * @throws IOException if a file cannot be written, or one that the scene refers to cannot be read any more
     */
    public static void write(
            SceneDescription description,
            SceneBuilder.Result result,
            AutoView.Additions additions,
            PanoramaEncoder panoramas,
            Path output)
            throws IOException {
        boolean model = description.root().type().equals(ModelReader.MODEL);
        FilmSettings film = result.graph().film();
        if (film == null) {
            throw new IllegalArgumentException("the scene has no film");
        }
        SceneDescription complete = with(
                description, ViewDescription.of(additions, film, SourceLocation.of(description.file()), panoramas));
        try (Attachments attachments = new Attachments(output)) {
            SceneWriter writer = new SceneWriter(complete, result.meshes(), model, attachments);
            attachments.commit(out -> {
                Writer text = new OutputStreamWriter(out, StandardCharsets.UTF_8);
                writer.writeScene(new XmlOutput(text));
                text.flush();
            });
        }
    }

    /** A scene with more objects: before the others, as cameras are usually placed. */
    private static SceneDescription with(SceneDescription scene, List<PropertyDescription> more) {
        ObjectDescription root = scene.root();
        List<PropertyDescription> content = new ArrayList<>(more);
        content.addAll(root.properties());
        return new SceneDescription(
                scene.file(),
                new ObjectDescription(root.kind(), root.type(), root.id(), root.location(), content),
                scene.ids(),
                scene.folders(),
                scene.files());
    }

    private void writeScene(XmlOutput xml) throws IOException {
        String element = ObjectKind.SCENE.element();
        xml.open(element, "version", "3.0.0");
        for (ObjectDescription definition : names.definitions()) {
            writeObject(xml, "", definition);
        }
        for (PropertyDescription property : description.root().properties()) {
            ObjectDescription object = names.object(property.value());
            // A second mention of a definition has no effect.
            if (object != null && !(names.isShared(object) && written.contains(object))) {
                writeObject(xml, property.name(), object);
            }
        }
        xml.close(element);
    }

    private void writeObject(XmlOutput xml, String name, ObjectDescription object) throws IOException {
        // What cannot be referred to is written in every place; only the first has the name.
        String id = written.add(object) ? names.id(object) : null;
        BuiltMesh mesh = meshes.get(object);
        String element = object.kind().element();
        xml.open(element, "type", mesh == null ? object.type() : "ply", "id", id, "name", name.isEmpty() ? null : name);
        if (mesh != null) {
            writeMesh(xml, object, mesh);
        } else {
            for (PropertyDescription property : object.properties()) {
                writeProperty(xml, object, property);
            }
        }
        xml.close(element);
    }

    /** The properties of a mesh: how its file was to be read is in the mesh already. */
    private void writeMesh(XmlOutput xml, ObjectDescription object, BuiltMesh mesh) throws IOException {
        xml.leaf("string", "name", "filename", "value", file(object, mesh.mesh()));
        if (mesh.mesh().normals() == null) {
            xml.leaf("boolean", "name", "face_normals", "value", "true");
        }
        if (mesh.flipNormals()) {
            xml.leaf("boolean", "name", "flip_normals", "value", "true");
        }
        boolean plain = true;
        for (PropertyDescription property : object.properties()) {
            boolean nested = names.object(property.value()) != null;
            plain &= !nested;
            if (nested || property.name().equals("to_world")) {
                writeProperty(xml, object, property);
            }
        }
        if (plain && model) {
            boolean colored = mesh.mesh().colors() != null && !object.type().equals("mesh");
            ObjectDescription neutral = colored ? neutralColored : neutralGrey;
            if (written.contains(neutral)) {
                xml.leaf("ref", "id", names.id(neutral));
            } else {
                writeObject(xml, "", neutral);
            }
        }
    }

    /** What models get that name no material: {@link AutoView#neutralMaterial}, or the colours of the vertices. */
    private static ObjectDescription neutral(String id, Value reflectance, SourceLocation location) {
        ObjectDescription diffuse = new ObjectDescription(
                ObjectKind.BSDF,
                "diffuse",
                null,
                location,
                List.of(new PropertyDescription("reflectance", reflectance, location)));
        return new ObjectDescription(
                ObjectKind.BSDF,
                "twosided",
                id,
                location,
                List.of(new PropertyDescription("", new Value.Nested(diffuse), location)));
    }

    private static Value vertexColors(SourceLocation location) {
        return new Value.Nested(new ObjectDescription(
                ObjectKind.TEXTURE,
                "mesh_attribute",
                null,
                location,
                List.of(new PropertyDescription("name", new Value.Text("vertex_color"), location))));
    }

    private void writeProperty(XmlOutput xml, ObjectDescription owner, PropertyDescription property)
            throws IOException {
        String name = property.name();
        Value value = property.value();
        ObjectDescription object = names.object(value);
        if (object != null) {
            if (names.isShared(object)) {
                xml.leaf("ref", "name", name.isEmpty() ? null : name, "id", names.id(object));
            } else {
                writeObject(xml, name, object);
            }
        } else if (value instanceof Value.Transform transform) {
            writeTransform(xml, name, transform.matrix());
        } else if (value instanceof Value.WholeNumber n) {
            xml.leaf("integer", "name", name, "value", Long.toString(n.value()));
        } else if (value instanceof Value.RealNumber n) {
            xml.leaf("float", "name", name, "value", number(n.value()));
        } else if (value instanceof Value.Switch s) {
            xml.leaf("boolean", "name", name, "value", Boolean.toString(s.value()));
        } else if (value instanceof Value.Triple t) {
            xml.leaf("point", "name", name, "value", numbers(t.x(), t.y(), t.z()));
        } else if (value instanceof Value.FlatSpectrum s) {
            xml.leaf("spectrum", "name", name, "value", number(s.value()));
        } else if (value instanceof Value.Text text) {
            boolean file = type(owner, name) == ValueType.FILE;
            xml.leaf("string", "name", name, "value", file ? copied(text.value(), property.location()) : text.value());
        } else if (value instanceof Value.Content content) {
            xml.leaf("string", "name", name, "value", file(content));
        } else {
            double[] rgb = LinearColors.of(value, type(owner, name));
            if (rgb == null) {
                throw new IllegalArgumentException("'" + name + "' of " + owner.label() + " at " + property.location()
                        + " is " + value.description() + ", which scene files have no element for");
            }
            xml.leaf("rgb", "name", name, "value", numbers(rgb));
        }
    }

    /** Writes a transform unless it is the one that everything has. */
    private static void writeTransform(XmlOutput xml, String name, Matrix4d matrix) throws IOException {
        Matrix4d identity = new Matrix4d();
        identity.setIdentity();
        if (!matrix.equals(identity)) {
            xml.open("transform", "name", name);
            xml.leaf("matrix", "value", numbers(matrix));
            xml.close("transform");
        }
    }

    /** The type of a property; that of a word if the table does not have it, which a scene that could be built does not. */
    private static ValueType type(ObjectDescription owner, String name) {
        PluginDefinition plugin = Plugins.find(owner.kind(), owner.type());
        if (plugin != null) {
            for (PropertyDefinition property : plugin.properties()) {
                if (property.name().equals(name)) {
                    return property.type();
                }
            }
        }
        return ValueType.STRING;
    }

    private String file(ObjectDescription shape, TriangleMesh mesh) throws IOException {
        String known = meshFiles.get(mesh);
        if (known == null) {
            known = attachments.add(stem(shape), "ply", out -> PlyWriter.write(out, mesh));
            meshFiles.put(mesh, known);
        }
        return known;
    }

    /** A name for the mesh of a shape: the shape's own, else that of its file, else its type. */
    private static String stem(ObjectDescription shape) {
        if (shape.id() != null) {
            return shape.id();
        }
        for (PropertyDescription property : shape.properties()) {
            if (property.name().equals("filename") && property.value() instanceof Value.Text text) {
                return stem(text.value().substring(text.value().lastIndexOf('\\') + 1));
            }
        }
        return shape.type();
    }

    private static String stem(String file) {
        String name = String.valueOf(Path.of(file).getFileName());
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }

    private String file(Value.Content content) throws IOException {
        String known = contentFiles.get(content.bytes());
        if (known == null) {
            known = attachments.add(content.name(), content.ending(), out -> out.write(content.bytes()));
            contentFiles.put(content.bytes(), known);
        }
        return known;
    }

    private String copied(String name, SourceLocation location) throws IOException {
        Path source = description.resolve(name, location.file());
        Path key = source.toAbsolutePath().normalize();
        String known = copiedFiles.get(key);
        if (known == null) {
            String file = String.valueOf(source.getFileName());
            known = attachments.add(
                    stem(file), file.substring(file.lastIndexOf('.') + 1), out -> Files.copy(source, out));
            copiedFiles.put(key, known);
        }
        return known;
    }

    private static String numbers(Matrix4d m) {
        double[] rows = new double[16];
        for (int i = 0; i < rows.length; i++) {
            // The reader multiplies transforms, which leaves no negative zeros; adding 0 does the same.
            rows[i] = m.getElement(i / 4, i % 4) + 0.0;
        }
        return numbers(rows);
    }

    private static String numbers(double... values) {
        StringJoiner text = new StringJoiner(" ");
        for (double value : values) {
            text.add(number(value));
        }
        return text.toString();
    }

    /** The shortest digits that stand for this number and no other. */
    private static String number(double value) {
        String text = Double.toString(value);
        return text.endsWith(".0") ? text.substring(0, text.length() - 2) : text;
    }
}
