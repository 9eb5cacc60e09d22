package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import javax.imageio.ImageIO;
import org.daybreak.scenes.build.PluginDefinition;
import org.daybreak.scenes.build.PropertyDefinition;
import org.daybreak.scenes.build.ValueType;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.mesh.SerializedReaderTest;
import org.daybreak.scenes.mesh.StlReaderTest;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class InputFormatsTest {
    @TempDir
    Path folder;

    static List<PluginDefinition> plugins() {
        return InputFormats.plugins();
    }

    /** Whether every default is admissible, and every type of object has its builder. */
    @ParameterizedTest
    @MethodSource("plugins")
    void everyTypeLoadsWithItsDefaultsSpelledOut(PluginDefinition plugin) throws IOException, SceneException {
        SceneTexts.write(folder, "t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        SceneTexts.write(folder, "t.ply", """
                ply
                format ascii 1.0
                element vertex 3
                property float x
                property float y
                property float z
                element face 1
                property list uchar int vertex_index
                end_header
                0 0 0 1 0 0 0 1 0 3 0 1 2
                """);
        SceneTexts.write(folder, "t.stl", StlReaderTest.FACET);
        for (String curve : new String[] {"t.bsplinecurve", "t.linearcurve"}) {
            SceneTexts.write(folder, curve, "0 0 0 1\n1 0 0 1\n2 1 0 1\n3 1 1 0.5\n");
        }
        Files.write(folder.resolve("t.serialized"), SerializedReaderTest.file(4, 0x1000, 1));
        ImageIO.write(
                new BufferedImage(2, 2, BufferedImage.TYPE_INT_RGB),
                "png",
                folder.resolve("t.png").toFile());
        SceneTexts.write(folder, "t.ies", "IESNA:LM-63-2002\nTILT=NONE\n1 1 1 2 1 1 2 0 0 0\n1 1 1\n0 90\n0\n1 1\n");
        String object = object(plugin);
        String content = switch (plugin.kind()) {
            case SCENE -> "";
            case FILM, SAMPLER -> "<sensor type='perspective'>" + object + "</sensor>";
            case RFILTER -> "<sensor type='perspective'><film type='hdrfilm'>" + object + "</film></sensor>";
            case EMITTER -> plugin.type().equals("area") ? "<shape type='disk'>" + object + "</shape>" : object;
            default -> object;
        };
        String sensor = content.contains("<sensor") ? "" : SceneTexts.SENSOR;
        SceneFile file =
                SceneTexts.load(folder, "<scene version='3.0.0'>" + sensor + SceneTexts.LIGHT + content + "</scene>");
        assertTrue(
                file.warnings().stream().allMatch(w -> w.message().contains("no effect")),
                () -> file.warnings().toString());
    }

    private static String object(PluginDefinition plugin) {
        StringBuilder xml = new StringBuilder("<" + plugin.kind().element() + " type='" + plugin.type() + "'>");
        for (PropertyDefinition p : plugin.properties()) {
            String value = p.defaultValue();
            boolean exclusive = p.name().equals("focal_length")
                    || p.name().equals("B")
                    || p.name().equals("C");
            if (p.type() == ValueType.OBJECT && p.required()) {
                xml.append(
                        plugin.type().equals("instance")
                                ? "<shape type='shapegroup'><shape type='disk'/></shape>"
                                : nested(p.kind()).repeat((int) p.minimum()));
            } else if (p.type() == ValueType.FILE) {
                boolean image =
                        plugin.kind() != ObjectKind.SHAPE || plugin.type().equals("heightfield");
                String ending = p.name().equals("ies") ? "ies" : image ? "png" : plugin.type();
                xml.append("<string name='")
                        .append(p.name())
                        .append("' value='t.")
                        .append(ending)
                        .append("'/>");
            } else if (p.name().equals("aperture_radius")) {
                xml.append("<float name='aperture_radius' value='0.1'/>");
            } else if (p.name().equals("fov_axis")) {
                xml.append("<float name='fov' value='40'/><string name='fov_axis' value='")
                        .append(value)
                        .append("'/>");
            } else if (value != null && !exclusive) {
                xml.append("<")
                        .append(element(p, value))
                        .append(" name='")
                        .append(p.name())
                        .append("' value='");
                xml.append(value).append("'/>");
            }
        }
        return xml.append("</").append(plugin.kind().element()).append(">").toString();
    }

    private static String nested(@Nullable ObjectKind kind) {
        return kind == ObjectKind.SHAPE
                ? "<shape type='disk'/>"
                : kind == ObjectKind.TEXTURE ? "<texture type='checkerboard'/>" : "<bsdf type='diffuse'/>";
    }

    private static String element(PropertyDefinition p, String value) {
        return switch (p.type()) {
            case INTEGER -> "integer";
            case FLOAT, TEXTURED_NUMBER -> "float";
            case BOOLEAN -> "boolean";
            case POINT -> "point";
            case COLOR, REFLECTANCE, EMISSION, TEXTURED_EMISSION -> "rgb";
            case REFRACTIVE_INDEX, STRING, CHOICE, FILE -> "string";
            case TRANSFORM, OBJECT, MESH -> throw new AssertionError(value);
        };
    }

    @Test
    void namesAreUniqueAndDocumented() {
        Set<String> seen = new HashSet<>();
        for (PluginDefinition plugin : plugins()) {
            assertTrue(seen.add(plugin.kind() + " " + plugin.type()));
            assertFalse(plugin.doc().isBlank());
            Set<String> names = new HashSet<>();
            for (PropertyDefinition p : plugin.properties()) {
                assertTrue(names.add(p.name()), p.name());
                assertFalse(p.doc().isBlank(), p.name());
            }
        }
    }

    @Test
    void markdownListsEveryTypeAndProperty() {
        String text = InputFormats.markdown();
        for (PluginDefinition plugin : plugins()) {
            assertTrue(text.contains("### `" + plugin.type() + "`"), plugin.type());
        }
        assertTrue(text.contains("| `radius` | a float greater than 0 | 1 | Radius. |"), text);
    }
}
