package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** The scenes beside this module's sources load without a warning. */
class ShippedScenesTest {
    static List<Path> scenes() throws IOException {
        try (Stream<Path> all = Files.walk(Path.of("."))) {
            return all.filter(p -> p.getFileName().toString().matches("scene.*\\.xml"))
                    .filter(p -> !p.toString().contains("target"))
                    .sorted()
                    .toList();
        }
    }

    @Test
    void allAreFound() throws IOException {
        assertTrue(
                scenes().size() >= 23,
                () -> "the test runs in the wrong folder: " + Path.of("").toAbsolutePath());
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void loads(Path scene) throws SceneException {
        SceneFile file = new SceneReader().load(scene, Map.of("spp", "3"));
        assertEquals(List.of(), file.warnings());
        assertEquals(OptionalInt.of(3), file.request().samplesPerPixel());
        assertEquals("path", file.request().rendererId().orElseThrow());
        assertNotNull(file.graph().camera());
        assertNotNull(file.graph().film());
    }

    @Test
    void doorAjarIsComplete() throws SceneException {
        SceneFile file = new SceneReader().load(Path.of("door_ajar/scene.xml"), Map.of());
        List<ShapeNode> shapes = SceneTexts.shapes(file.graph().root());
        assertEquals(18, shapes.size());
        FilmSettings film = file.graph().film();
        assertNotNull(film);
        assertEquals(450, film.width());
        assertEquals(250, film.height());
        CameraSettings camera = file.graph().camera();
        assertNotNull(camera);
        assertEquals(57, camera.fieldOfViewDegrees());
        assertEquals(64, file.request().samplesPerPixel().orElseThrow());
        List<ShapeNode> pots =
                shapes.stream().filter(s -> s.transform().m13 == 0.741).toList();
        assertEquals(3, pots.size());
        assertTrue(pots.get(0).shape() == pots.get(1).shape(), "one mesh serves both pots");
        assertTrue(pots.get(2).shape() instanceof TriangleMesh m && m.normals() != null && m.triangleCount() > 20_000);
    }
}
