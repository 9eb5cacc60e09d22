package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertThrows;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.daybreak.core.scene.Group;
import org.daybreak.core.scene.Instance;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.Node;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.description.SceneProblem;

/** Scenes as texts for tests. */
final class SceneTexts {
    static final String SENSOR = "<sensor type=\"perspective\"><film type=\"hdrfilm\">"
            + "<integer name=\"width\" value=\"8\"/><integer name=\"height\" value=\"4\"/></film></sensor>\n";
    static final String LIGHT = "<emitter type=\"constant\"/>\n";

    private SceneTexts() {}

    /** A scene with a camera, a light and what is given, from line 4. */
    static String scene(String content) {
        return "<scene version=\"3.0.0\">\n" + SENSOR + LIGHT + content + "\n</scene>\n";
    }

    static Path write(Path folder, String name, String text) throws IOException {
        Path file = folder.resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    static SceneFile load(Path folder, String text) throws IOException, SceneException {
        return new SceneReader().load(write(folder, "scene.xml", text), Map.of());
    }

    /** The errors of a scene that must not load. */
    static List<SceneProblem> errors(Path folder, String text) throws IOException {
        Path file = write(folder, "scene.xml", text);
        return assertThrows(SceneException.class, () -> new SceneReader().load(file, Map.of()))
                .problems();
    }

    /** The places of all marks in a text as line:column of what follows them. */
    static List<String> marks(String marked) {
        List<String> places = new ArrayList<>();
        int line = 1;
        int column = 1;
        for (int i = 0; i < marked.length(); i++) {
            char c = marked.charAt(i);
            if (c == '§') {
                places.add(line + ":" + column);
            } else if (c == '\n') {
                line++;
                column = 1;
            } else {
                column++;
            }
        }
        return places;
    }

    /** All shapes below a group, instances followed. */
    static List<ShapeNode> shapes(Group group) {
        return group.children().stream().flatMap(SceneTexts::shapesOf).toList();
    }

    private static Stream<ShapeNode> shapesOf(Node node) {
        if (node instanceof ShapeNode shape) {
            return Stream.of(shape);
        }
        if (node instanceof Instance instance) {
            return shapes(instance.prototype()).stream();
        }
        return node instanceof Group group ? shapes(group).stream() : Stream.empty();
    }

    /** The light after that of every scene. */
    static LightNode lightNode(SceneFile file) {
        return (LightNode) file.graph().root().children().get(1);
    }

    static ShapeNode onlyShape(SceneFile file) {
        List<ShapeNode> shapes = shapes(file.graph().root());
        if (shapes.size() != 1) {
            throw new AssertionError("expected one shape but found " + shapes.size());
        }
        return shapes.get(0);
    }
}
