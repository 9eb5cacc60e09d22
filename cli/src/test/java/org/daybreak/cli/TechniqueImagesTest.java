package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** The images that {@code -P techniques=DIR} asks for. */
class TechniqueImagesTest {
    @TempDir
    private Path folder;

    private Path scene;

    @BeforeEach
    void writeScene() throws IOException {
        scene = BidirectionalScene.write(folder);
    }

    private Cli.Result render(Path views, String... more) {
        List<Object> args = new ArrayList<>(List.of(
                "render",
                scene,
                "--renderer",
                "bidirectional",
                "-P",
                "techniques=" + views,
                "-o",
                folder.resolve("image.exr")));
        args.addAll(List.of(more));
        return Cli.run(args.toArray());
    }

    /** Pixels hold floats of sums of doubles: each layer is off by at most half a unit in its last place. */
    private static void assertSums(ImageData layers) {
        for (String c : new String[] {"R", "G", "B"}) {
            float[] image = layers.channels().get(c);
            double[] sum = new double[image.length];
            layers.channels().forEach((name, plane) -> {
                if (name.startsWith("weighted.") && name.endsWith("." + c)) {
                    for (int i = 0; i < sum.length; i++) {
                        sum[i] += plane[i];
                    }
                }
            });
            for (int i = 0; i < sum.length; i++) {
                assertEquals(image[i], sum[i], 1e-6 * Math.abs(sum[i]) + 1e-12, c + " of pixel " + i);
            }
        }
    }

    @ParameterizedTest
    @CsvSource({
        "box, 4, efficiency, 6",
        "box, 4, throughput, 2",
        "gaussian, 4, efficiency, 6",
        "box, -1, efficiency, 3",
        "box, -1, throughput, 1"
    })
    void weightedImagesAddUpToTheImage(String filter, int depth, String roulette, int shown) throws IOException {
        Path views = folder.resolve("views");
        Cli.Result result = render(
                views,
                "-D",
                "filter=" + filter,
                "-D",
                "depth=" + depth,
                "-P",
                "russianRoulette=" + roulette,
                "-P",
                "techniquesDepth=" + shown);
        assertEquals(0, result.code(), result.err());
        ImageData layers = ImageData.read(views.resolve("techniques.exr"));
        assertSums(layers);
        ImageData image = ImageData.read(folder.resolve("image.exr"));
        for (String c : new String[] {"R", "G", "B"}) {
            assertArrayEquals(image.channels().get(c), layers.channels().get(c));
        }
        assertEquals(depth < 0 || shown < depth, layers.channels().containsKey("weighted.longer.R"));
    }

    @Test
    void layersAreTheTechniquesOfTheConfiguration() {
        Path views = folder.resolve("views");
        assertEquals(
                0,
                render(views, "-P", "maxEyeDepth=3", "-P", "maxLightDepth=2", "-P", "maxDepth=3")
                        .code());
        Set<String> expected = new TreeSet<>(Set.of("R", "G", "B"));
        for (String technique : new String[] {"s0t2", "s0t3", "s1t2", "s2t1", "s1t3", "s2t2"}) {
            for (String c : new String[] {"R", "G", "B"}) {
                expected.add("weighted." + technique + "." + c);
                expected.add("unweighted." + technique + "." + c);
            }
        }
        ImageData layers = ImageData.read(views.resolve("techniques.exr"));
        assertEquals(expected, new TreeSet<>(layers.channels().keySet()));
        // A picture wide enough for the labels, of two tables with three rows each.
        ImageData page = ImageData.read(views.resolve("techniques.png"));
        assertTrue(page.width() > 3 * 6 * 24 && page.height() > 2 * 3 * 6 * 20, page.width() + "x" + page.height());
    }

    @Test
    void withoutCausticMapNothingIsSplatted() {
        Path views = folder.resolve("views");
        assertEquals(
                0,
                render(views, "-P", "causticMap=false", "--antialiasing", "adaptive")
                        .code());
        ImageData layers = ImageData.read(views.resolve("techniques.exr"));
        assertFalse(layers.channels().containsKey("weighted.s2t1.R"));
        assertSums(layers);
    }

    /** The views change nothing, and are the same for any number of threads. */
    @Test
    void sameBitsWithAndWithoutOnAnyThreads() throws IOException {
        Path one = folder.resolve("one");
        Path three = folder.resolve("three");
        assertEquals(0, render(one, "--threads", "1", "--size", "70x40").code());
        ImageData image = ImageData.read(folder.resolve("image.exr"));
        assertEquals(0, render(three, "--threads", "3", "--size", "70x40").code());
        ImageData a = ImageData.read(one.resolve("techniques.exr"));
        ImageData b = ImageData.read(three.resolve("techniques.exr"));
        assertEquals(a.channels().keySet(), b.channels().keySet());
        a.channels()
                .forEach((name, plane) ->
                        assertTrue(Arrays.equals(plane, b.channels().get(name)), name));
        assertArrayEquals(
                Files.readAllBytes(one.resolve("techniques.png")), Files.readAllBytes(three.resolve("techniques.png")));
        Cli.run("render", scene, "--renderer", "bidirectional", "--size", "70x40", "-o", folder.resolve("plain.exr"));
        ImageData plain = ImageData.read(folder.resolve("plain.exr"));
        for (String c : new String[] {"R", "G", "B"}) {
            assertArrayEquals(plain.channels().get(c), image.channels().get(c));
        }
        // No path of this machine gets into the image.
        assertFalse(
                image.attributes().get("parameters").contains("techniques\""),
                image.attributes().toString());
    }

    @Test
    void foldersAreCheckedBeforeTheSceneIsRead() throws IOException {
        scene = folder.resolve("missing.xml");
        Path file = Files.writeString(folder.resolve("file"), "");
        for (Path views : new Path[] {file, folder.resolve("no/such")}) {
            Cli.Result result = render(views);
            assertEquals(4, result.code(), result.err());
            assertEquals(1, result.messages().size(), result.err());
            assertTrue(result.err().contains("cannot be written to: "), result.err());
        }
        Path views = Files.createDirectory(folder.resolve("views"));
        Files.createDirectory(views.resolve("techniques.png"));
        Cli.Result result = render(views);
        assertEquals(4, result.code(), result.err());
        assertTrue(result.err().contains("is a directory"), result.err());
    }

    @ParameterizedTest
    @ValueSource(strings = {"--checkpoint c.daybreak", "--part 1/2 -o p.daybreak"})
    void neitherPartsNorCheckpoints(String options) throws IOException {
        List<Object> args = new ArrayList<>(List.of("render", scene, "--renderer", "bidirectional"));
        args.addAll(List.of("-P", "techniques=" + folder.resolve("views")));
        for (String option : options.split(" ", -1)) {
            args.add(option.endsWith(".daybreak") ? folder.resolve(option) : option);
        }
        if (!options.contains("-o")) {
            args.addAll(List.of("-o", folder.resolve("a.png")));
        }
        Cli.Result result = Cli.run(args.toArray());
        assertEquals(2, result.code(), result.err());
        assertTrue(result.err().contains("with -P techniques can neither be resumed"), result.err());
        assertEquals(List.of("views.xml"), Cli.files(folder));
    }
}
