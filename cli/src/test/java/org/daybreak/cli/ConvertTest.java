package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import org.daybreak.exr.ExrAttribute;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.daybreak.exr.ExrWriter;
import org.daybreak.exr.PixelType;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class ConvertTest {
    private static final int WIDTH = 40;
    private static final int HEIGHT = 24;

    @TempDir
    private Path folder;

    private Path exr;

    @BeforeEach
    void writeImage() throws IOException {
        exr = folder.resolve("a.exr");
        ExrWriter.write(
                exr,
                ExrImage.builder(WIDTH, HEIGHT)
                        .dataWindowOrigin(3, 5)
                        .channel("R", PixelType.FLOAT, plane(0.9))
                        .channel("G", PixelType.FLOAT, plane(0.5))
                        .channel("B", PixelType.FLOAT, plane(0.1))
                        .channel("albedo.R", PixelType.HALF, plane(0.25))
                        .channel("albedo.G", PixelType.HALF, plane(0.25))
                        .channel("albedo.B", PixelType.HALF, plane(0.25))
                        .channel("depth.Z", PixelType.FLOAT, plane(7))
                        .attribute("seed", "42")
                        .build());
    }

    private static float[] plane(double scale) {
        float[] values = new float[WIDTH * HEIGHT];
        for (int i = 0; i < values.length; i++) {
            values[i] = (float) (scale * (0.2 + 0.8 * (i % WIDTH) / WIDTH));
        }
        return values;
    }

    private Path convert(String name, Object... options) {
        Path out = folder.resolve(name);
        Object[] args = new Object[options.length + 3];
        args[0] = "convert";
        System.arraycopy(options, 0, args, 1, options.length);
        args[options.length + 1] = exr;
        args[options.length + 2] = out;
        Cli.Result result = Cli.run(args);
        assertEquals(0, result.code(), result.err());
        return out;
    }

    private static void assertClose(float[] expected, float[] actual, double relative, double absolute) {
        assertEquals(expected.length, actual.length);
        for (int i = 0; i < expected.length; i++) {
            assertEquals(expected[i], actual[i], relative * expected[i] + absolute);
        }
    }

    /** There and back; the tolerance is what the format cannot hold: 8 bits of a mantissa, 8 bits of sRGB, or JPEG. */
    @ParameterizedTest
    @CsvSource({"pfm, 0, 0", "hdr, 0.006, 0.004", "png, 0.02, 0.002", "jpg, 0.1, 0.03", "jpeg, 0.1, 0.03"})
    void everyFormatThereAndBack(String ending, double relative, double absolute) throws IOException {
        Path file = convert("b." + ending);
        Path back = folder.resolve("back.exr");
        assertEquals(0, Cli.run("convert", file, back).code());
        ExrImage image = ExrReader.read(back);
        assertClose(plane(0.9), image.samples("R"), relative, absolute);
        assertClose(plane(0.5), image.samples("G"), relative, absolute);
        assertClose(plane(0.1), image.samples("B"), relative, absolute);
        assertEquals(0, Cli.run("info", file).code());
        assertEquals(0, Cli.run("diff", file, exr).code());
    }

    @Test
    void openExrKeepsAllOfIt() throws IOException {
        ExrImage image = ExrReader.read(convert("b.exr", "--exposure", "1"));
        assertEquals(
                new ExrAttribute.StringValue("42"), image.header().attributes().get("seed"));
        assertEquals(3, image.header().dataWindow().xMin());
        assertEquals(5, image.header().dataWindow().yMin());
        assertArrayEquals(plane(7), image.samples("depth.Z"));
        float[] twice = plane(0.5);
        for (int i = 0; i < twice.length; i++) {
            twice[i] *= 2;
        }
        assertArrayEquals(twice, image.samples("G"));
        assertEquals(ExrReader.read(exr).header().channels(), image.header().channels());
    }

    @Test
    void layersAndExposure() throws IOException {
        ExrImage albedo = ExrReader.read(convert("b.exr", "--layer", "albedo"));
        assertClose(plane(0.25), albedo.samples("R"), 1e-3, 0);
        ImageData depth = ImageData.read(convert("z.pfm", "--layer", "depth", "--exposure", "-1"));
        assertClose(plane(3.5), Arrays.copyOf(depth.channels().get("Y"), WIDTH * HEIGHT), 0, 0);
    }

    @Test
    void wrongRequests() throws IOException {
        assertFails(2, "no colour in the layer 'albdo'", "--layer", "albdo", exr, folder.resolve("b.png"));
        assertFails(2, "must be from -100 to 100", "--exposure", "NaN", exr, folder.resolve("b.png"));
        assertFails(2, "has the unknown ending 'tif'", exr, folder.resolve("b.tif"));
        assertFails(2, "cannot be converted to the format daybreak", exr, folder.resolve("b.daybreak"));
        assertFails(3, "there is no such file", folder.resolve("none.exr"), folder.resolve("b.png"));
        Path bad = Files.writeString(folder.resolve("bad.png"), "no image");
        assertFails(3, "bad.png: ", bad, folder.resolve("b.png"));
        assertFails(4, "cannot be written", exr, folder.resolve("no").resolve("b.png"));
    }

    private static void assertFails(int code, String message, Object... args) {
        Object[] all = new Object[args.length + 1];
        all[0] = "convert";
        System.arraycopy(args, 0, all, 1, args.length);
        Cli.Result result = Cli.run(all);
        assertEquals(code, result.code(), result.err());
        assertEquals(1, result.messages().size(), result.err());
        assertTrue(result.err().contains(message), result.err());
    }

    @Test
    void flipAndFalseColour() throws IOException {
        Path brighter = convert("b.exr", "--exposure", "0.5");
        Path map = folder.resolve("map.png");
        Cli.Result same = Cli.run("diff", exr, exr, "--flip", "ldr");
        assertTrue(same.out().contains("flip             0.000000"), same.out());
        Cli.Result diff = Cli.run("diff", brighter, exr, "--false-color", map, "--json");
        assertEquals(0, diff.code(), diff.err());
        double flip = new com.fasterxml.jackson.databind.ObjectMapper()
                .readTree(diff.out())
                .get("flip")
                .asDouble();
        assertTrue(flip > 0.05 && flip < 1, "flip " + flip);
        assertEquals(WIDTH, ImageData.read(map).width());
        assertEquals(2, Cli.run("diff", exr, exr, "--flip", "hrd").code());
        assertEquals(
                2,
                Cli.run("diff", exr, exr, "--flip", "none", "--false-color", map)
                        .code());
        assertEquals(
                2,
                Cli.run("diff", exr, exr, "--false-color", folder.resolve("m.exr"))
                        .code());
        Path grey = folder.resolve("grey.exr");
        ExrWriter.write(
                grey,
                ExrImage.builder(WIDTH, HEIGHT)
                        .channel("R", PixelType.FLOAT, plane(1))
                        .build());
        assertEquals(5, Cli.run("diff", grey, exr, "--flip", "ldr").code());
    }
}
