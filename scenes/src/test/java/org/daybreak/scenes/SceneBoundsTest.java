package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.description.SceneProblem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * Files whose parts make more of each other, so that few lines ask for more time or memory than there is. They are longer
 * than what a fuzzer comes up with.
 */
@Timeout(value = 30, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
class SceneBoundsTest {
    @TempDir
    Path folder;

    private void refuses(String content, String message) throws IOException {
        List<SceneProblem> errors = SceneTexts.errors(folder, SceneTexts.scene(content));
        assertTrue(
                errors.stream().anyMatch(error -> error.message().contains(message)),
                () -> errors.subList(0, Math.min(3, errors.size())).toString());
    }

    @Test
    void texturesUsedTwiceByTexturesUsedTwice() throws IOException {
        StringBuilder content = new StringBuilder("<texture type='checkerboard' id='t0'/>\n");
        for (int i = 1; i < 60; i++) {
            String nested = "id='t" + (i - 1) + "'/>";
            content.append("<texture type='product' id='t" + i + "'><ref name='first' " + nested)
                    .append("<ref name='second' " + nested + "</texture>\n");
        }
        refuses(content.toString(), "<texture type=\"product\"> has more than 4096 parts");
    }

    @Test
    void materialsUsedTwiceByMaterialsUsedTwice() throws IOException {
        StringBuilder content = new StringBuilder("<bsdf type='diffuse' id='b0'/>\n");
        for (int i = 1; i < 60; i++) {
            String nested = "<ref id='b" + (i - 1) + "'/>";
            content.append("<bsdf type='blendbsdf' id='b" + i + "'><float name='weight' value='0.5'/>" + nested
                            + nested)
                    .append("</bsdf>\n");
        }
        refuses(content.toString(), "<bsdf type=\"blendbsdf\"> has more than 4096 parts");
    }

    /** As many parts as files need are no error: each use of a material counts for itself only. */
    @Test
    void materialThatManyShapesUse() throws IOException, SceneException {
        String bsdf = "<bsdf type='twosided' id='b'><bsdf type='diffuse'/></bsdf>\n";
        String shapes = "<shape type='sphere'><ref id='b'/></shape>\n".repeat(5000);
        assertEquals(
                5000,
                SceneTexts.shapes(SceneTexts.load(folder, SceneTexts.scene(bsdf + shapes))
                                .graph()
                                .root())
                        .size());
    }

    @Test
    void filesIncludedTwiceByFilesIncludedTwice() throws IOException {
        for (int i = 0; i < 14; i++) {
            SceneTexts.write(
                    folder,
                    "f" + i + ".xml",
                    "<scene version='3.0.0'>" + ("<include filename='f" + (i + 1) + ".xml'/>").repeat(9) + "</scene>");
        }
        SceneTexts.write(folder, "f14.xml", "<scene version='3.0.0'/>");
        refuses("<include filename='f0.xml'/>", "a scene may include files 4096 times in all");
    }

    @Test
    void longDefinitionUsedOften() throws IOException {
        refuses(
                "<default name='a' value='" + "x".repeat(60_000) + "'/>\n"
                        + "<texture type='bitmap'><string name='filename' value='$a'/></texture>\n".repeat(30_000),
                "attributes have more than 16777216 characters in all");
    }

    @Test
    void longUndefinedName() throws IOException {
        refuses("<default name='a' value='1'/>\n<string name='b' value='$" + "c".repeat(4_000_000) + "'/>", "'$ccc");
    }

    @Test
    void asManyUnknownNamesAsKnownOnes() throws IOException {
        StringBuilder content = new StringBuilder();
        for (int i = 0; i < 10_000; i++) {
            content.append("<bsdf type='diffuse' id='material " + i + "'/><shape type='sphere'><ref id='m" + i
                    + "'/></shape>\n");
        }
        refuses(content.toString(), "no object has the id 'm0'; did you mean");
    }

    @Test
    void textureWithManyOptions() throws IOException, SceneException {
        SceneTexts.write(
                folder,
                "m.mtl",
                "newmtl m\nmap_Kd " + "-cc on ".repeat(200_000) + "-s 2 3 -mm 0 1 no such image.png\n");
        Path model = SceneTexts.write(folder, "m.obj", "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl m\nf 1 2 3\n");
        SceneFile file = new SceneReader().load(model, Map.of());
        assertEquals(
                List.of("the texture 'no such image.png' does not exist"),
                file.warnings().stream().map(SceneProblem::message).toList());
    }
}
