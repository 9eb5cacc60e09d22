package org.daybreak.cli.flip;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.Test;

class FlipTest {
    private static final int WIDTH = 96;
    private static final int HEIGHT = 64;

    /** The images of {@code flip_reference.py}. */
    private static float[] picture(double shift, double noise, double scale) {
        float[] rgb = new float[3 * WIDTH * HEIGHT];
        for (int y = 0; y < HEIGHT; y++) {
            for (int column = 0; column < WIDTH; column++) {
                double x = column + shift;
                double hashed = Math.sin(12.9898 * x + 78.233 * y) * 43758.5453;
                double random = hashed - Math.floor(hashed);
                for (int c = 0; c < 3; c++) {
                    double smooth = 0.5 + 0.4 * Math.sin(0.13 * (c + 1) * x + 0.05 * y) * Math.cos(0.11 * y - 0.3 * c);
                    double edge = (x - 48) * (x - 48) + (y - 32) * (y - 32) < 400 ? 0.3 : 0;
                    rgb[3 * (y * WIDTH + column) + c] =
                            (float) (Math.max(0, smooth + edge + noise * (random - 0.5)) * scale);
                }
            }
        }
        return rgb;
    }

    private static float[] error(String name) {
        Flip flip = new Flip(WIDTH, HEIGHT, Flip.DEFAULT_PIXELS_PER_DEGREE);
        return switch (name) {
            case "shift" -> flip.displayError(picture(1, 0, 1), picture(0, 0, 1));
            case "noise" -> flip.displayError(picture(0, 0.3, 1), picture(0, 0, 1));
            case "dark" -> flip.displayError(picture(0, 0.1, 0.05), picture(0, 0, 0.05));
            case "hdr" -> flip.highDynamicRangeError(picture(0, 0.3, 20), picture(0, 0, 20));
            case "hdrShift" -> flip.highDynamicRangeError(picture(2, 0.05, 0.01), picture(0, 0, 0.01));
            default -> throw new IllegalArgumentException(name);
        };
    }

    private static List<String> reference() throws IOException {
        try (InputStream in = FlipTest.class.getResourceAsStream("reference.csv")) {
            assertNotNull(in);
            return new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().toList();
        }
    }

    @Test
    void agreesWithTheOfficialImplementation() throws IOException {
        Map<String, float[]> errors = new HashMap<>();
        int values = 0;
        for (String line : reference().subList(1, reference().size())) {
            String[] fields = line.split(",", -1);
            float[] error = errors.computeIfAbsent(fields[0], FlipTest::error);
            double actual = 0;
            if (fields[1].equals("mean")) {
                for (float e : error) {
                    actual += e / error.length;
                }
            } else {
                actual = error[Integer.parseInt(fields[2]) * WIDTH + Integer.parseInt(fields[1])];
            }
            assertEquals(Double.parseDouble(fields[3]), actual, 5e-4, line);
            values++;
        }
        assertEquals(5 * 13, values);
    }

    /** The committed values are those of the package that is installed here. */
    @Test
    void referenceIsThatOfThePackage() throws IOException, InterruptedException {
        Path script = Path.of(System.getProperty("daybreak.root"), "cli", "src", "test", "python", "flip_reference.py");
        Process process;
        try {
            process = new ProcessBuilder("python3", script.toString())
                    .redirectError(ProcessBuilder.Redirect.DISCARD)
                    .start();
        } catch (IOException e) {
            Assumptions.abort("there is no python3");
            return;
        }
        List<String> lines = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8)
                .lines()
                .toList();
        Assumptions.assumeTrue(process.waitFor() == 0, "python3 has no flip-evaluator");
        List<String> committed = reference();
        assertEquals(committed.size(), lines.size());
        for (int i = 1; i < lines.size(); i++) {
            int comma = lines.get(i).lastIndexOf(',');
            assertEquals(committed.get(i).substring(0, comma), lines.get(i).substring(0, comma));
            assertEquals(
                    Double.parseDouble(committed.get(i).substring(comma + 1)),
                    Double.parseDouble(lines.get(i).substring(comma + 1)),
                    2e-6);
        }
    }

    @Test
    void equalImagesHaveNoError() {
        Flip flip = new Flip(WIDTH, HEIGHT, Flip.DEFAULT_PIXELS_PER_DEGREE);
        for (float e : flip.highDynamicRangeError(picture(0, 0.2, 1), picture(0, 0.2, 1))) {
            assertEquals(0, e);
        }
        for (float e : flip.highDynamicRangeError(new float[3 * WIDTH * HEIGHT], new float[3 * WIDTH * HEIGHT])) {
            assertEquals(0, e);
        }
    }

    @Test
    void blackAndWhiteDifferMost() {
        float[] white = new float[3 * WIDTH * HEIGHT];
        java.util.Arrays.fill(white, 1);
        float[] error =
                new Flip(WIDTH, HEIGHT, Flip.DEFAULT_PIXELS_PER_DEGREE).displayError(white, new float[white.length]);
        for (float e : error) {
            assertTrue(e > 0.9 && e <= 1, () -> Float.toString(e));
        }
    }
}
