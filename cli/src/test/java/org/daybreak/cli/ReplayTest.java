package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.TreeSet;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ReplayTest {
    private static final int WIDTH = 24;
    private static final int HEIGHT = 20;

    @TempDir
    private Path folder;

    private Path scene;

    @BeforeEach
    void writeScene() throws IOException {
        scene = BidirectionalScene.write(folder);
    }

    private Cli.Result replay(Object... options) {
        List<Object> args = new ArrayList<>(List.of("replay", scene, "--renderer", "bidirectional"));
        args.addAll(List.of(options));
        return Cli.run(args.toArray());
    }

    private JsonNode json(Object... options) throws IOException {
        List<Object> args = new ArrayList<>(List.of(options));
        args.add("--json");
        Cli.Result result = replay(args.toArray());
        assertEquals(0, result.code(), result.err());
        return new ObjectMapper().readTree(result.out());
    }

    /** A render of one sample in one pixel holds its radiance, and the splats that come back to this pixel. */
    @ParameterizedTest
    @CsvSource({"one, 4, 1", "all, 4, 1", "one, -1, 3", "all, -1, 1"})
    void sumsToThePixelOfARenderOfOneSample(String lights, int depth, int splitting) throws IOException {
        TreeSet<String> outcomes = new TreeSet<>();
        for (int[] pixel : new int[][] {{3, 4}, {6, 14}, {17, 12}, {12, 18}, {12, 1}}) {
            Path image = folder.resolve("pixel.pfm");
            Object[] settings = {
                "--spp",
                1,
                "--seed",
                5,
                "-D",
                "depth=" + depth,
                "-P",
                "lightsPerPath=" + lights,
                "-P",
                "russianRoulette=throughput",
                "-P",
                "splitting=" + splitting
            };
            List<Object> render = new ArrayList<>(List.of("render", scene, "--renderer", "bidirectional"));
            render.addAll(List.of(settings));
            render.addAll(List.of("--crop", pixel[0] + "," + pixel[1] + ",1,1", "-o", image));
            assertEquals(0, Cli.run(render.toArray()).code());
            List<Object> again = new ArrayList<>(List.of(settings));
            again.addAll(List.of("--pixel", pixel[0] + "," + pixel[1]));
            JsonNode record = json(again.toArray());
            List<String> channels = List.of("R", "G", "B");
            ImageData rendered = ImageData.read(image);
            for (int c = 0; c < channels.size(); c++) {
                double added = 0;
                double splatted = 0;
                for (JsonNode contribution : record.get("contributions")) {
                    outcomes.add(contribution.get("outcome").asText());
                    double value = contribution.get("unweighted").path(c).asDouble()
                            * contribution.get("weight").asDouble();
                    JsonNode at = contribution.get("filmPosition");
                    if (contribution.get("outcome").asText().equals("added")) {
                        added += value;
                    } else if (contribution.get("outcome").asText().equals("splatted")
                            && (int) at.get(0).asDouble() == pixel[0]
                            && (int) at.get(1).asDouble() == pixel[1]) {
                        splatted += value;
                    }
                }
                double radiance = record.get("radiance").get(c).asDouble();
                assertEquals(radiance, added, 1e-12 * radiance);
                double expected = radiance + splatted;
                assertEquals(expected, rendered.channels().get(channels.get(c))[0], 1e-6 * expected);
            }
        }
        assertTrue(
                outcomes.containsAll(List.of("added", "splatted", "occluded", "zero", "not admissible: delta vertex")),
                outcomes.toString());
        assertEquals(depth > 0, outcomes.contains("not admissible: depth"));
    }

    @Test
    void whatTheRouletteLeavesOutIsTold() throws IOException {
        int leftOut = 0;
        for (String pixel : List.of("6,14", "17,12", "12,18", "3,17", "20,8")) {
            Object[] options = {"--spp", 6, "--seed", 5, "-D", "depth=6", "--sample", 3, "--pixel", pixel};
            int inText = 0;
            for (String line : replay(options).out().lines().toList()) {
                inText += line.endsWith("  left out by roulette") ? 1 : 0;
            }
            for (JsonNode contribution : json(options).get("contributions")) {
                if (contribution.get("outcome").asText().equals("left out by roulette")) {
                    assertTrue(contribution.get("unweighted").get(1).asDouble() > 0);
                    assertTrue(contribution.get("weight").asDouble() > 0);
                    inText--;
                    leftOut++;
                }
            }
            assertEquals(0, inText, pixel);
        }
        assertTrue(leftOut > 0, "nothing is left out");
    }

    @Test
    void textNamesVerticesAndOutcomes() {
        Cli.Result result = replay("--pixel", "6,14", "--sample", "2");
        assertEquals(0, result.code(), result.err());
        assertTrue(result.out().contains("seed 0, pixel (6, 14), sample 2 of 4"), result.out());
        assertTrue(result.out().contains("note: the roulette"), result.out());
        assertTrue(result.out().contains("(Dielectric), goes on by a delta lobe, cannot be joined"), result.out());
        assertTrue(result.out().contains("eye subpath 0, vertices: "), result.out());
        assertTrue(result.out().contains("subpath from light "), result.out());
        assertTrue(result.out().contains("not admissible: delta vertex"), result.out());
        assertFalse(
                replay("--pixel", "6,14", "-P", "russianRoulette=none").out().contains("note: "));
    }

    /** Statistics and warnings name samples in this form. */
    @Test
    void addressOfAReportIsTaken() {
        Cli.Result byAddress = replay("--address", "seed -7, pixel (3, 4), sample 3");
        assertEquals(0, byAddress.code(), byAddress.err());
        assertEquals(replay("--seed", "-7", "--pixel", "3,4", "--sample", "3").out(), byAddress.out());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                " | --pixel X,Y or --address is missing",
                "--pixel 3 | --pixel is '3' but must be of the form X,Y, such as 120,80",
                "--pixel a,b | --pixel is 'a,b' but must be of the form X,Y",
                "--pixel 24,0 | there is no pixel (24, 0) in an image of 24x20 pixels",
                "--pixel 0,-1 | there is no pixel (0, -1) in an image of 24x20 pixels",
                "--pixel 0,0 --sample 4 | there is no sample 4 of a pixel that has 4: they are numbered from 0",
                "--pixel 0,0 --sample -1 | there is no sample -1",
                "--pixel 0,0 --spp 0 | --spp is 0 but must be from 1",
                "--pixel 0,0 --address x | --address stands for --pixel, --sample and --seed",
                "--address pixel | --address: 'pixel' is no address of a sample, such as 'seed 0, pixel (3, 4), sample 5'",
                "--pixel 0,0 -P maxDpth=1 | 'bidirectional' has no parameter 'maxDpth'; did you mean 'maxDepth'?",
                "--pixel 0,0 --renderer path | renderer 'path' cannot replay samples; 'bidirectional' can"
            })
    void wrongRequests(String options, String message) {
        List<Object> args = new ArrayList<>();
        if (options != null) {
            args.addAll(List.of((Object[]) options.split(" ")));
        }
        Cli.Result result = args.contains("path")
                ? Cli.run("replay", scene, "--pixel", "0,0", "--renderer", "path")
                : replay(args.toArray());
        assertEquals(2, result.code(), result.err());
        assertTrue(result.messages().get(0).contains(message), result.err());
        assertEquals("", result.out());
    }

    @ParameterizedTest
    @ValueSource(strings = {"sobol", "grid", "adaptive"})
    void everyMethodOfAntialiasing(String method) throws IOException {
        JsonNode record = json("--pixel", "5,6", "--antialiasing", method, "-P", "causticMap=false");
        double x = record.get("filmPosition").get(0).asDouble();
        double y = record.get("filmPosition").get(1).asDouble();
        assertTrue(x >= 5 && x < 6 && y >= 6 && y < 7 && WIDTH > x && HEIGHT > y, x + " " + y);
        assertEquals(method, record.get("antialiasing").asText());
    }
}
