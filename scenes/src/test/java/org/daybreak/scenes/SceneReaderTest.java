package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Stream;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import org.daybreak.core.geometry.Cylinder;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.Plastic;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Structure of scene files: transforms, shapes, definitions, includes, references, encodings. */
class SceneReaderTest extends SceneReading {
    /** Transforms and the matrices that Mitsuba 3.9.1 makes of them. */
    static Stream<Arguments> transforms() {
        return Stream.of(
                arguments(
                        "<translate x='1' y='2'/><rotate z='1' angle='30'/><scale value='2'/>",
                        "1.7320508 -1 0 -0.26794919 1 1.7320508 0 4.4641018 0 0 2 0 0 0 0 1"),
                arguments(
                        "<rotate x='0.6' y='0.8' angle='40'/><translate value='1,2,3'/>",
                        "0.85026842 0.11229867 0.51423007 1 0.11229867 0.91577601 -0.38567257 2"
                                + " -0.51423007 0.38567257 0.76604444 3 0 0 0 1"),
                arguments(
                        "<lookat origin='1,2,3' target='0,0.5,0' up='0,1,0'/>",
                        "-0.94868332 -0.13552618 -0.28571430 1 0 0.90350789 -0.42857143 2"
                                + " 0.31622776 -0.40657857 -0.85714287 3 0 0 0 1"),
                arguments(
                        "<scale x='2'/><lookat origin='1,2,3' target='0,0.5,0' up='0.1,1,0.3'/>",
                        "-1.8973666 -0.13552618 -0.28571430 1 0 0.90350789 -0.42857143 2"
                                + " 0.63245553 -0.40657857 -0.85714287 3 0 0 0 1"),
                arguments(
                        "<lookat origin='1,2,3' target='0,0.5,0'/>",
                        "-0.06593407 0.95604396 -0.28571430 1 0.90109890 -0.06593407 -0.42857143 2"
                                + " -0.42857143 -0.28571430 -0.85714287 3 0 0 0 1"),
                arguments("<matrix value='1 2 3 4 0 1 5 6 7 0 1 8 0 0 0 1'/>", "1 2 3 4 0 1 5 6 7 0 1 8 0 0 0 1"),
                arguments("<matrix value='1 2 3 0 1 5 7 0 1'/>", "1 2 3 0 0 1 5 0 7 0 1 0 0 0 0 1"),
                arguments(
                        "<rotate angle='30' value='0 1 0'/>", "0.8660254 0 0.5 0 0 1 0 0 -0.5 0 0.8660254 0 0 0 0 1"));
    }

    @ParameterizedTest
    @MethodSource("transforms")
    void transformsAreThoseOfMitsuba(String transform, String expected) throws IOException, SceneException {
        ShapeNode node =
                shape("<shape type='rectangle'><transform name='to_world'>" + transform + "</transform></shape>");
        Matrix4d m = node.transform();
        String[] words = expected.split(" ", -1);
        for (int i = 0; i < 16; i++) {
            // Mitsuba prints single precision.
            assertEquals(Double.parseDouble(words[i]), m.getElement(i / 4, i % 4), 2e-6, "element " + i + " of " + m);
        }
    }

    @Test
    void readsAnalyticShapes() throws IOException, SceneException {
        Sphere sphere = assertInstanceOf(
                Sphere.class,
                shape(
                                "<shape type='sphere'><point name='center' x='1' y='2' z='3'/><integer name='radius' value='4'/></shape>")
                        .shape());
        assertEquals(new Point3d(1, 2, 3), sphere.centre());
        assertEquals(4, sphere.radius());
        Cylinder cylinder = assertInstanceOf(
                Cylinder.class,
                shape(
                                "<shape type='cylinder'><vector name='p1' value='0 0 5'/><float name='radius' value='.5'/></shape>")
                        .shape());
        assertEquals(new Point3d(0, 0, 5), cylinder.to());
        assertEquals(0.5, cylinder.radius());
        for (String type : List.of("rectangle", "disk", "cube")) {
            ShapeNode node = shape("<shape type='" + type + "'><boolean name='flip_normals' value='TRUE'/></shape>");
            assertTrue(node.flipNormals());
            assertEquals(type, node.shape().getClass().getSimpleName().toLowerCase(Locale.ROOT));
        }
    }

    @Test
    void definesGoBeforeDefaultsAndTheLongestNameIsTaken() throws IOException, SceneException {
        Path file = SceneTexts.write(
                folder,
                "scene.xml",
                SceneTexts.scene("<default name='r' value='1'/><default name='ra' value='2'/>"
                        + "<shape type='sphere'><float name='radius' value='$r$ra'/></shape>"
                        + "<bsdf type='diffuse' id='\\$x'/><shape type='sphere' id='s$rx'><ref id='\\$x'/></shape>"));
        List<ShapeNode> shapes = SceneTexts.shapes(
                new SceneReader().load(file, Map.of("r", "4")).graph().root());
        assertEquals(42, ((Sphere) shapes.get(0).shape()).radius());
        assertEquals("s4x", shapes.get(1).name());
    }

    @Test
    void includesFilesRelativeToTheIncludingFile() throws IOException, SceneException {
        SceneTexts.write(folder, "a/one.xml", "<scene version='3.0.0'><include filename='b/two.xml'/></scene>");
        SceneTexts.write(
                folder,
                "a/b/two.xml",
                "<shape version='3.0.0' type='obj'><string name='filename' value='m/$mesh'/><ref id='late'/></shape>");
        SceneTexts.write(folder, "a/b/m/t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        SceneFile file = load("<default name='mesh' value='t.obj'/><include filename='a/one.xml'/>"
                + "<bsdf type='plastic' id='late'/>");
        ShapeNode node = SceneTexts.onlyShape(file);
        assertInstanceOf(TriangleMesh.class, node.shape());
        assertInstanceOf(Plastic.class, node.material());
    }

    @Test
    void sharesMaterialsMeshesAndGroups() throws IOException, SceneException {
        SceneTexts.write(folder, "t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        SceneFile file = load("<bsdf type='diffuse' id='m'/><alias id='m' as='n'/>"
                + "<shape type='shapegroup' id='g'><shape type='obj'><string name='filename' value='t.obj'/><ref id='m'/></shape></shape>"
                + "<shape type='instance'><ref id='g'/><transform name='to_world'><translate x='5'/></transform></shape>"
                + "<shape type='instance'><ref id='g'/></shape>"
                + "<shape type='obj'><string name='filename' value='./t.obj'/><ref id='n'/></shape>");
        assertEquals(4, file.graph().root().children().size(), "light, two instances, shape");
        List<ShapeNode> shapes = SceneTexts.shapes(file.graph().root());
        assertEquals(3, shapes.size());
        assertSame(shapes.get(0), shapes.get(1));
        assertSame(shapes.get(0).shape(), shapes.get(2).shape());
        assertSame(shapes.get(0).material(), shapes.get(2).material());
        assertEquals(5, file.graph().root().children().get(1).transform().m03);
    }

    @Test
    void warnsOfDarkness() throws IOException, SceneException {
        SceneFile file = SceneTexts.load(folder, "<scene version='3.0.0'>" + SceneTexts.SENSOR + "</scene>");
        assertEquals(1, file.warnings().size());
        assertTrue(file.warnings().get(0).toString().contains("scene.xml:1:1: the scene has no light"));
    }

    @Test
    void readsOtherEncodings() throws IOException, SceneException {
        String text = "<?xml version='1.0' encoding='%s'?>" + SceneTexts.scene("<shape type='sphere' id='Kugel ö'/>");
        Path file = folder.resolve("scene.xml");
        Files.write(file, String.format(text, "ISO-8859-1").getBytes(StandardCharsets.ISO_8859_1));
        assertEquals(
                "Kugel ö",
                SceneTexts.onlyShape(new SceneReader().load(file, Map.of())).name());
        Files.write(file, ("\ufeff" + String.format(text, "UTF-16")).getBytes(StandardCharsets.UTF_16LE));
        assertEquals(
                "Kugel ö",
                SceneTexts.onlyShape(new SceneReader().load(file, Map.of())).name());
        Files.write(file, ("\ufeff" + String.format(text, "UTF-8")).getBytes(StandardCharsets.UTF_8));
        assertEquals(
                "Kugel ö",
                SceneTexts.onlyShape(new SceneReader().load(file, Map.of())).name());
    }
}
