package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrWriter;
import org.daybreak.exr.Pfm;
import org.daybreak.exr.PfmImage;
import org.daybreak.exr.PixelType;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ListInfoDiffTest {
    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({
        "renderers, path", "renderers, raytracer", "renderers, light", "antialiasing, grid", "intersectors, scalar",
        "materials, roughconductor", "lights, envmap", "shapes, ply", "textures, checkerboard", "formats, exr"
    })
    void listsNameWhatThereIs(String what, String id) throws IOException {
        Cli.Result list = Cli.run("list", what);
        assertEquals(0, list.code(), list.err());
        assertTrue(
                Pattern.compile("^" + id + "\\b", Pattern.MULTILINE)
                        .matcher(list.out())
                        .find(),
                list.out());
        JsonNode json =
                new ObjectMapper().readTree(Cli.run("list", what, "--json").out());
        boolean found = false;
        for (JsonNode item : json) {
            found |= item.get("id").asText().equals(id);
        }
        assertTrue(found, json.toString());
    }

    @Test
    void renderersShowTheirParameters() {
        String out = Cli.run("list", "renderers").out();
        assertTrue(out.contains("maxDepth \"Recursion depth\": a whole number, at least -1; default -1"), out);
    }

    @Test
    void unknownLists() {
        Cli.Result result = Cli.run("list", "rendrers");
        assertEquals(2, result.code());
        assertTrue(result.err().contains("did you mean 'renderers'?"), result.err());
    }

    @Test
    void infoOfAScene() throws IOException {
        Cli.Result info = Cli.run("info", TestScenes.write(folder, TestScenes.usual()));
        assertEquals(0, info.code(), info.err());
        assertLine(info.out(), "shapes", "2 (2 Rectangle)");
        assertLine(info.out(), "lights", "2 (1 Area, 1 Point); 2 in the compiled scene");
        assertLine(info.out(), "film", "8x8, crop 0,0,8,8, filter box of radius 0.5");
        assertLine(info.out(), "renderer", "path, maxDepth=3, 4 samples per pixel");
        assertLine(info.out(), "camera", "pinhole, field of view 90.00 degrees (x)");
    }

    @Test
    void infoOfImages() throws IOException {
        Path exr = write("a.exr", 1, Float.NaN, 3, 4);
        String out = Cli.run("info", exr).out();
        assertLine(out, "size", "2x2");
        assertLine(out, "G", "float, minimum 1.00000, mean 2.66667, maximum 4.00000, 1 infinite or not numbers");
        assertLine(out, "artist", "nobody");
        Path pfm = folder.resolve("a.pfm");
        Pfm.write(pfm, new PfmImage(2, 1, 1, new float[] {1, 2}));
        assertLine(Cli.run("info", pfm).out(), "Y", "float, minimum 1.00000, mean 1.50000, maximum 2.00000");
    }

    @Test
    void diffOfKnownImages() throws IOException {
        Path image = write("a.exr", 1, 2, 3, 5);
        Path reference = write("b.exr", 1, 2, 2, 3);
        JsonNode json = new ObjectMapper()
                .readTree(Cli.run("diff", image, reference, "--json").out());
        for (String channel : new String[] {"R", "G", "B", "all"}) {
            JsonNode figures = json.get(channel);
            assertEquals(Math.sqrt(5 / 4.0), figures.get("rmse").asDouble(), 1e-12);
            assertEquals((1 / 4.01 + 4 / 9.01) / 4, figures.get("relmse").asDouble(), 1e-12);
            assertEquals(0.75, figures.get("bias").asDouble(), 1e-12);
            assertEquals(3 / 8.0, figures.get("relativeBias").asDouble(), 1e-12);
        }
        Cli.Result table = Cli.run("diff", image, reference);
        assertEquals(0, table.code());
        assertTrue(table.out().contains("+7.50000e-01"), table.out());
    }

    @Test
    void diffOfLayersAndFormats() throws IOException {
        Path exr = write("a.exr", 1, 2, 3, 4);
        Path pfm = folder.resolve("a.pfm");
        Pfm.write(pfm, new PfmImage(2, 2, 3, new float[] {1, 1, 1, 2, 2, 2, 3, 3, 3, 4, 4, 4}));
        assertTrue(Cli.run("diff", exr, pfm).out().contains("0.00000e+00"));
        Cli.Result layer = Cli.run("diff", "--layer", "albedo", exr, pfm);
        assertEquals(5, layer.code());
        assertTrue(layer.err().contains("no channel in common in the layer 'albedo'"), layer.err());
    }

    @Test
    void diffRefusesOtherSizesAndCountsNonFinite() throws IOException {
        Path exr = write("a.exr", 1, Float.POSITIVE_INFINITY, 3, 4);
        Path pfm = folder.resolve("a.pfm");
        Pfm.write(pfm, new PfmImage(2, 1, 3, new float[6]));
        Cli.Result size = Cli.run("diff", exr, pfm);
        assertEquals(5, size.code());
        assertTrue(size.err().contains("2x2 pixels") && size.err().contains("2x1"), size.err());
        Cli.Result infinite = Cli.run("diff", exr, exr);
        assertEquals(6, infinite.code());
        assertTrue(infinite.err().contains("3 values are infinite or not numbers"), infinite.err());
    }

    @Test
    void wrongImages() throws IOException {
        Path damaged = Files.writeString(folder.resolve("bad.exr"), "no image");
        for (Path file : new Path[] {damaged, folder.resolve("none.exr"), Files.createFile(folder.resolve("e.pfm"))}) {
            for (Cli.Result result : new Cli.Result[] {Cli.run("info", file), Cli.run("diff", file, file)}) {
                assertEquals(3, result.code(), result.err());
                assertEquals(1, result.err().lines().count(), result.err());
            }
        }
        assertEquals(3, Cli.run("diff", folder.resolve("a.gif"), damaged).code());
    }

    private Path write(String name, float... grey) throws IOException {
        Path file = folder.resolve(name);
        ExrWriter.write(
                file,
                ExrImage.builder(2, 2)
                        .channel("R", PixelType.FLOAT, grey)
                        .channel("G", PixelType.FLOAT, grey)
                        .channel("B", PixelType.FLOAT, grey)
                        .attribute("artist", "nobody")
                        .build());
        return file;
    }

    private static void assertLine(String text, String name, String value) {
        assertTrue(text.contains(String.format("%-16s %s%n", name, value)), text);
    }
}
