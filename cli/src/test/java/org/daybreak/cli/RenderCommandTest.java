package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.imageio.ImageIO;
import org.daybreak.exr.Box2i;
import org.daybreak.exr.ExrAttribute;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.daybreak.exr.Pfm;
import org.daybreak.exr.PfmImage;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RenderCommandTest {
    @TempDir
    private Path folder;

    private Path scene;
    private Path exr;
    private Path stats;

    @BeforeEach
    void writeScene() throws IOException {
        scene = TestScenes.write(folder, TestScenes.usual());
        exr = folder.resolve("out.exr");
        stats = folder.resolve("stats.json");
    }

    @Test
    void writesEachFormat() throws IOException {
        Path pfm = folder.resolve("out.pfm");
        Path png = folder.resolve("OUT.PNG");
        Cli.Result result = Cli.run("render", scene, "-o", exr, "-o", pfm, "-o", png);
        assertEquals(0, result.code(), result.err());
        ExrImage image = ExrReader.read(exr);
        PfmImage map = Pfm.read(pfm);
        assertArrayEquals(image.interleaved("", "R", "G", "B"), map.samples());
        assertEquals(8, ImageIO.read(png.toFile()).getWidth());
        // The middle shows the light of radiance (4, 2, 1) and nothing else.
        assertEquals(4, image.samples("R")[3 * 8 + 3], 1e-6);
        assertEquals(0xffffff, ImageIO.read(png.toFile()).getRGB(3, 3) & 0xffffff);
        assertEquals(List.of("OUT.PNG", "out.exr", "out.pfm", "tiny.xml"), Cli.files(folder));
        assertTrue(result.err().contains("rendered in") && result.err().contains("wrote " + exr), result.err());
    }

    /** A model shows up in the middle of the picture, before the grey of its environment. */
    @Test
    void rendersABareModel() throws IOException {
        Path model = Files.writeString(folder.resolve("m.obj"), """
                v -1 -1 0
                v 1 -1 0
                v 1 1 0
                v -1 1 0
                vn 0 0 1
                f 1//1 2//1 3//1 4//1
                """);
        Cli.Result result = Cli.run("render", model, "-o", exr, "--size", "16x12", "--spp", 16, "--progress", "none");
        assertEquals(0, result.code(), result.err());
        float[] red = ExrReader.read(exr).samples("R");
        assertEquals(0.35, red[0], 1e-3, "the environment");
        assertTrue(red[6 * 16 + 8] > 0.4 && red[6 * 16 + 8] < 0.8, "the model: " + red[6 * 16 + 8]);
    }

    @Test
    void exrTellsHowItWasMade() throws IOException {
        assertEquals(
                0,
                Cli.run("render", scene, "-o", exr, "--seed", "-77", "-P", "rrDepth=9")
                        .code());
        var attributes = ExrReader.readHeader(exr).attributes();
        assertEquals(new ExrAttribute.StringValue("path"), attributes.get("renderer"));
        assertEquals(
                new ExrAttribute.StringValue("{\"maxDepth\":3,\"rrDepth\":9,\"splitting\":4}"),
                attributes.get("parameters"));
        assertEquals(new ExrAttribute.StringValue("-77"), attributes.get("seed"));
        assertEquals(new ExrAttribute.StringValue("sobol"), attributes.get("antialiasing"));
        assertEquals(new ExrAttribute.DoubleValue(4), attributes.get("samplesPerPixel"));
        assertEquals(new ExrAttribute.DoubleValue(256), attributes.get("samples"));
        assertTrue(attributes.containsKey("renderSeconds") && attributes.containsKey("software"));
        assertFalse(attributes.toString().contains(folder.toString()));
    }

    @Test
    void sizeKeepsTheFieldOfView() throws IOException {
        Path light = TestScenes.write(folder, TestScenes.lightOnly());
        for (String size : new String[] {"8x8", "16x16", "32x16"}) {
            assertEquals(0, Cli.run("render", light, "-o", exr, "--size", size).code());
            ExrImage image = ExrReader.read(exr);
            assertEquals(size, image.width() + "x" + image.height());
            int lit = 0;
            for (int x = 0; x < image.width(); x++) {
                lit += image.samples("R")[image.height() / 2 * image.width() + x] > 0 ? 1 : 0;
            }
            assertEquals(image.width() / 2, lit, "the light fills half of the width");
        }
    }

    @Test
    void cropIsThatPartOfTheWholePicture() throws IOException {
        Path part = folder.resolve("part.exr");
        assertEquals(0, Cli.run("render", scene, "-o", exr).code());
        assertEquals(
                0, Cli.run("render", scene, "-o", part, "--crop", "1,2,5,3").code());
        ExrImage whole = ExrReader.read(exr);
        ExrImage crop = ExrReader.read(part);
        assertEquals(new Box2i(1, 2, 5, 4), crop.header().dataWindow());
        assertEquals(Box2i.ofSize(8, 8), crop.header().displayWindow());
        for (int y = 0; y < 3; y++) {
            assertArrayEquals(
                    Arrays.copyOfRange(whole.samples("G"), (y + 2) * 8 + 1, (y + 2) * 8 + 6),
                    Arrays.copyOfRange(crop.samples("G"), y * 5, y * 5 + 5));
        }
    }

    @Test
    void sameSeedSamePictureOnAnyThreads() throws IOException {
        float[] one = render("--threads", "1", "--seed", "5");
        assertArrayEquals(one, render("--threads", "3", "--seed", "5"));
        assertFalse(Arrays.equals(one, render("--threads", "1", "--seed", "6")));
    }

    @Test
    void samplesComeFromOptionThenDefinitionThenScene() throws IOException {
        assertEquals(4, statistics().get("samplesPerPixel").asInt());
        assertEquals(2, statistics("-D", "spp=2").get("samplesPerPixel").asInt());
        assertEquals(
                8,
                statistics("-D", "spp=2", "--spp", "8").get("samplesPerPixel").asInt());
        TestScenes.write(folder, TestScenes.usual().replace("<integer name=\"sample_count\" value=\"$spp\"/>", ""));
        // The reader's own default for a sampler without a count is left to the renderer.
        assertEquals(64, statistics().get("samplesPerPixel").asInt());
    }

    /** Renderers by Markov chains take them as mutations, unless these are given themselves. */
    @Test
    void samplesAreTheMutationsOfMarkovChains() throws IOException {
        for (String renderer : new String[] {"metropolis", "pssmlt", "mmlt"}) {
            assertEquals(4, mutations(renderer), "the scene's");
            assertEquals(3, mutations(renderer, "--spp", "3"));
            assertEquals(5, mutations(renderer, "--spp", "3", "-P", "mutationsPerPixel=5"));
            assertEquals(5, mutations(renderer, "--time", "1000", "--spp", "5"));
            // No number of samples is asked for: the parameter's default, which then only divides the time.
            assertEquals(100, mutations(renderer, "--target-error", "0.9"));
        }
        TestScenes.write(folder, TestScenes.usual().replace("<integer name=\"sample_count\" value=\"$spp\"/>", ""));
        assertEquals(100, mutations("metropolis"));
    }

    private int mutations(String renderer, Object... options) throws IOException {
        List<Object> all = new ArrayList<>(List.of("--renderer", renderer));
        all.addAll(List.of("-P", "bootstrapSamples=500", "-P", "separateDirect=false"));
        all.addAll(List.of(options));
        JsonNode s = statistics(all.toArray());
        int mutations =
                s.get("renderer").get("parameters").get("mutationsPerPixel").asInt();
        boolean byError = List.of(options).contains("--target-error");
        if (!byError) {
            assertEquals(mutations, s.get("samplesPerPixel").asInt());
            assertEquals(mutations, s.get("figures").get("mutationsPerPixel").asDouble());
        }
        return mutations;
    }

    /** What scene files ask of these renderers are parameters that they have. */
    @Test
    void integratorsOfMitsubaAreTheRenderersByMarkovChains() throws IOException {
        String scene = TestScenes.usual()
                .replace(
                        TestScenes.INTEGRATOR,
                        "<integrator type=\"mlt\"><integer name=\"max_depth\" value=\"4\"/>"
                                + "<integer name=\"direct_samples\" value=\"8\"/>"
                                + "<integer name=\"luminance_samples\" value=\"500\"/>"
                                + "<boolean name=\"two_stage\" value=\"true\"/>"
                                + "<integer name=\"first_stage_size_reduction\" value=\"2\"/>"
                                + "<boolean name=\"lens_perturbation\" value=\"false\"/></integrator>");
        TestScenes.write(folder, scene);
        JsonNode mlt = statistics().get("renderer");
        assertEquals("metropolis", mlt.get("id").asText());
        JsonNode values = mlt.get("parameters");
        assertEquals(4, values.get("maxDepth").asInt());
        assertEquals(4, values.get("mutationsPerPixel").asInt());
        assertEquals(8, values.get("directSamples").asInt());
        assertEquals(500, values.get("bootstrapSamples").asInt());
        assertTrue(values.get("twoStage").asBoolean());
        assertEquals(2, values.get("reduction").asInt());
        for (String off : new String[] {"lensSubpath", "lens", "manifold"}) {
            assertEquals(0, values.get(off).asDouble(), off);
        }
        for (String on : new String[] {"bidirectional", "caustic", "multiChain"}) {
            assertTrue(values.get(on).asDouble() > 0, on);
        }
        scene = TestScenes.usual()
                .replace(
                        TestScenes.INTEGRATOR,
                        "<integrator type=\"pssmlt\"><integer name=\"direct_samples\" value=\"-1\"/>"
                                + "<integer name=\"luminance_samples\" value=\"500\"/>"
                                + "<integer name=\"rr_depth\" value=\"7\"/><float name=\"p_large\" value=\"0.2\"/>"
                                + "<float name=\"mutation_size_low\" value=\"0.001\"/>"
                                + "<float name=\"mutation_size_high\" value=\"0.1\"/></integrator>");
        TestScenes.write(folder, scene);
        JsonNode pssmlt = statistics().get("renderer");
        assertEquals("pssmlt", pssmlt.get("id").asText());
        values = pssmlt.get("parameters");
        assertFalse(values.get("separateDirect").asBoolean());
        assertEquals(7, values.get("rrDepth").asInt());
        assertEquals(0.2, values.get("largeStep").asDouble());
        assertEquals(0.001, values.get("smallestStep").asDouble());
        assertEquals(0.1, values.get("largestStep").asDouble());
    }

    @Test
    void timeAndSamplesWhicheverIsFirst() throws IOException {
        JsonNode few = statistics("--spp", "2", "--time", "1000");
        assertEquals(128, few.get("samples").asInt());
        JsonNode timed = statistics("--time", "0.3");
        assertTrue(timed.get("samples").asLong() > 64 * 4, "time alone is not limited to the scene's 4 samples");
        assertTrue(timed.get("seconds").get("render").get("wall").asDouble() >= 0.3);
        assertFalse(timed.get("cancelled").asBoolean());
    }

    @Test
    void rendererAndParametersComeFromOptionThenScene() throws IOException {
        JsonNode own = statistics().get("renderer");
        assertEquals("path", own.get("id").asText());
        assertEquals(3, own.get("parameters").get("maxDepth").asInt());
        JsonNode other = statistics("--renderer", "raytracer").get("renderer");
        assertEquals("raytracer", other.get("id").asText());
        assertEquals(3, other.get("parameters").get("maxDepth").asInt());
        JsonNode given = statistics("-P", "maxDepth=1", "-P", "rrDepth=2").get("renderer");
        assertEquals(1, given.get("parameters").get("maxDepth").asInt());
        assertEquals(2, given.get("parameters").get("rrDepth").asInt());
    }

    @Test
    void antialiasingTakesParameters() throws IOException {
        JsonNode grid = statistics("--antialiasing", "grid", "-A", "gridSize=3", "--spp", "1");
        assertEquals("grid", grid.get("antialiasing").get("id").asText());
        assertEquals(
                3, grid.get("antialiasing").get("parameters").get("gridSize").asInt());
        assertEquals(9, grid.get("samplesPerPixel").asInt());
    }

    @Test
    void layersGoIntoTheExr() throws IOException {
        assertEquals(
                0,
                Cli.run("render", scene, "-o", exr, "--layers", "albedo,normal,depth,variance")
                        .code());
        assertEquals(
                List.of("", "albedo", "depth", "normal", "variance"),
                ExrReader.readHeader(exr).layers());
        // The wall behind is at distance 2 along the axis, farther towards the corner.
        assertTrue(ExrReader.read(exr).samples("depth.Z")[0] > 2);
    }

    @Test
    void intersectorCanBeChosen() throws IOException {
        assertTrue(statistics("--intersector", "scalar")
                .get("intersector")
                .get("description")
                .asText()
                .contains("scalar"));
    }

    @Test
    void progressModes() throws IOException {
        assertEquals(
                "", Cli.run("render", scene, "-o", exr, "--progress", "none").err());
        String plain =
                Cli.run("render", scene, "-o", exr, "--progress", "plain").err();
        assertTrue(plain.startsWith("rendered in "), plain);
        assertEquals(
                plain.lines().count(),
                Cli.run("render", scene, "-o", exr, "--progress", "auto")
                        .err()
                        .lines()
                        .count());
        List<String> lines = Cli.run("render", scene, "-o", exr, "--progress", "json", "--time", "0.6")
                .err()
                .lines()
                .toList();
        ObjectMapper json = new ObjectMapper();
        assertTrue(lines.size() >= 2);
        for (String line : lines.subList(0, lines.size() - 1)) {
            JsonNode node = json.readTree(line);
            assertEquals("progress", node.get("event").asText());
            assertTrue(node.get("fraction").asDouble() <= 1);
        }
        JsonNode last = json.readTree(lines.get(lines.size() - 1));
        assertEquals("finished", last.get("event").asText());
        assertEquals(exr.toString(), last.get("outputs").get(0).asText());
    }

    @Test
    void statisticsAddUp() throws IOException {
        JsonNode s = statistics("--threads", "1", "--seed", "3");
        assertEquals(3, s.get("seed").asInt());
        assertEquals(1, s.get("threads").asInt());
        assertEquals(256, s.get("samples").asLong());
        assertEquals(256, s.get("rays").get("camera").asLong());
        long rays = 0;
        for (JsonNode kind : s.get("rays")) {
            rays += kind.asLong();
        }
        assertEquals(rays, s.get("raysTotal").asLong());
        double wall = 0;
        for (String phase : new String[] {"load", "compile", "render", "write"}) {
            wall += s.get("seconds").get(phase).get("wall").asDouble();
            assertTrue(s.get("seconds").get(phase).has("cpu"));
        }
        assertEquals(wall, s.get("seconds").get("total").get("wall").asDouble(), 1e-9);
        assertTrue(s.get("memory").get("peakHeapBytes").asLong() > 0);
        assertEquals(0, s.get("nonFinite").get("count").asLong());
        assertEquals(0, s.get("warnings").size());
        assertTrue(s.get("relativeError").isNumber());
    }

    @Test
    void defaultNamesFollowTheScene() {
        assertEquals("kitchen", Scenes.name(Path.of("kitchen.xml")));
        assertEquals("kitchen.v2", Scenes.name(Path.of("a", "kitchen.v2.xml")));
        assertEquals("kitchen", Scenes.name(Path.of("a", "kitchen", "scene.xml")));
        assertEquals("kitchen", Scenes.name(Path.of("kitchen", "x", "..", "scene.xml")));
        assertEquals(Path.of("").toAbsolutePath().getFileName().toString(), Scenes.name(Path.of("scene.xml")));
    }

    @Test
    void replacesAnOlderPicture() throws IOException {
        Files.writeString(exr, "old");
        assertEquals(0, Cli.run("render", scene, "-o", exr).code());
        assertEquals(8, ExrReader.read(exr).width());
    }

    @Test
    void exrAndPfmEnvironmentsAreRead() throws IOException {
        Path environment = folder.resolve("sky.pfm");
        float[] sky = new float[3 * 8];
        Arrays.fill(sky, 0.25f);
        Pfm.write(environment, new PfmImage(4, 2, 3, sky));
        String emitter = "<emitter type=\"envmap\"><string name=\"filename\" value=\"sky.pfm\"/></emitter>";
        TestScenes.write(folder, TestScenes.scene(TestScenes.SENSOR, emitter));
        float[] black = render();
        for (float value : black) {
            assertEquals(0.25f, value, 1e-5f);
        }
        org.daybreak.exr.ExrWriter.write(
                folder.resolve("sky.exr"),
                ExrImage.builder(4, 2)
                        .interleavedLayer("", org.daybreak.exr.PixelType.HALF, sky, "R", "G", "B")
                        .build());
        TestScenes.write(folder, TestScenes.scene(TestScenes.SENSOR, emitter.replace("pfm", "exr")));
        assertArrayEquals(black, render());
    }

    private float[] render(Object... options) throws IOException {
        Object[] args = new Object[4 + options.length];
        args[0] = "render";
        args[1] = scene;
        args[2] = "-o";
        args[3] = exr;
        System.arraycopy(options, 0, args, 4, options.length);
        Cli.Result result = Cli.run(args);
        assertEquals(0, result.code(), result.err());
        return ExrReader.read(exr).interleaved("", "R", "G", "B");
    }

    private JsonNode statistics(Object... options) throws IOException {
        Object[] all = Arrays.copyOf(options, options.length + 2);
        all[options.length] = "--stats";
        all[options.length + 1] = stats;
        render(all);
        return new ObjectMapper().readTree(stats.toFile());
    }
}
