package org.daybreak.scenes.gltf;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import javax.vecmath.Matrix4d;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SceneDescription;
import org.daybreak.scenes.description.SceneProblem;
import org.daybreak.scenes.description.Value;

/** What a glTF file was read as, and ways to look into it. */
record Descriptions(ObjectDescription root, List<String> warnings) {
    static Descriptions read(Path file) {
        ProblemList problems = new ProblemList();
        Optional<SceneDescription> description = GltfReader.read(file, problems);
        assertEquals(List.of(), problems.errors());
        return new Descriptions(
                description.orElseThrow().root(),
                problems.warnings().stream().map(SceneProblem::message).toList());
    }

    static Descriptions read(GltfText text, Path folder) throws IOException {
        return read(text.write(folder));
    }

    /** The messages of the errors that a file is refused with. */
    static List<String> errors(Path file) {
        ProblemList problems = new ProblemList();
        GltfReader.read(file, problems);
        return problems.errors().stream().map(SceneProblem::message).toList();
    }

    List<ObjectDescription> all(ObjectKind kind) {
        return children(root, kind);
    }

    ObjectDescription only(ObjectKind kind) {
        List<ObjectDescription> found = all(kind);
        assertEquals(1, found.size(), () -> "number of " + kind);
        return found.get(0);
    }

    TriangleMesh mesh() {
        return mesh(only(ObjectKind.SHAPE));
    }

    static TriangleMesh mesh(ObjectDescription shape) {
        return assertInstanceOf(Value.Mesh.class, value(shape, "mesh")).mesh();
    }

    static List<ObjectDescription> children(ObjectDescription object, ObjectKind kind) {
        return object.properties().stream()
                .map(PropertyDescription::value)
                .filter(Value.Nested.class::isInstance)
                .map(v -> ((Value.Nested) v).object())
                .filter(o -> o.kind() == kind)
                .toList();
    }

    static ObjectDescription child(ObjectDescription object, ObjectKind kind) {
        List<ObjectDescription> found = children(object, kind);
        assertEquals(1, found.size(), () -> "number of " + kind + " in " + object);
        return found.get(0);
    }

    static Optional<Value> find(ObjectDescription object, String name) {
        return object.properties().stream()
                .filter(p -> p.name().equals(name))
                .map(PropertyDescription::value)
                .findFirst();
    }

    static Value value(ObjectDescription object, String name) {
        Value found = find(object, name).orElse(null);
        assertNotNull(found, () -> name + " of " + object);
        return found;
    }

    static ObjectDescription nested(ObjectDescription object, String name) {
        return assertInstanceOf(Value.Nested.class, value(object, name)).object();
    }

    static double number(ObjectDescription object, String name) {
        Value value = value(object, name);
        return value instanceof Value.WholeNumber n ? n.value() : ((Value.RealNumber) value).value();
    }

    static String text(ObjectDescription object, String name) {
        return ((Value.Text) value(object, name)).value();
    }

    static Matrix4d transform(ObjectDescription object) {
        return ((Value.Transform) value(object, "to_world")).matrix();
    }
}
