package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

class ExrRoundTripTest {
    private static final List<Compression> SUPPORTED =
            List.of(Compression.NONE, Compression.RLE, Compression.ZIPS, Compression.ZIP);

    @TempDir
    Path directory;

    @Test
    void everySampleComesBackForAllTypesCompressionsAndSizes() throws IOException {
        int[][] sizes = {{1, 1}, {1, 40}, {33, 1}, {16, 16}, {7, 17}, {129, 33}};
        Path file = directory.resolve("image.exr");
        for (int[] size : sizes) {
            for (PixelType type : PixelType.values()) {
                for (String pattern : List.of("smooth", "noise")) {
                    ExrImage image =
                            TestPatterns.rgb(pattern, type, size[0], size[1]).build();
                    for (Compression compression : SUPPORTED) {
                        ExrWriter.write(file, image, ExrWriteOptions.defaults().withCompression(compression));
                        ExrImage read = ExrReader.read(file);
                        assertEquals(size[0], read.width());
                        assertEquals(size[1], read.height());
                        TestPatterns.assertPattern(pattern, read);
                    }
                }
            }
        }
    }

    @Test
    void bytesAndSamplesDoNotDependOnTheNumberOfThreads() throws IOException {
        // Large enough to be packed by several threads.
        ExrImage image = TestPatterns.rgb("smooth", PixelType.FLOAT, 640, 401).build();
        Path one = directory.resolve("one.exr");
        for (Compression compression : SUPPORTED) {
            ExrWriteOptions options = ExrWriteOptions.defaults().withCompression(compression);
            ExrWriter.write(one, image, options.withThreads(1));
            for (int threads : new int[] {2, 3, 8}) {
                Path many = directory.resolve("many.exr");
                ExrWriter.write(many, image, options.withThreads(threads));
                assertEquals(-1, Files.mismatch(one, many));
                TestPatterns.assertPattern("smooth", ExrReader.read(many, threads));
            }
        }
    }

    @Test
    void aChunkThatDoesNotShrinkIsStoredRaw() throws IOException {
        ExrImage image = TestPatterns.rgb("noise", PixelType.FLOAT, 31, 16).build();
        Path zip = directory.resolve("zip.exr");
        Path none = directory.resolve("none.exr");
        // A single row of noise does not shrink.
        ExrWriter.write(zip, image, ExrWriteOptions.defaults().withCompression(Compression.ZIPS));
        ExrWriter.write(none, image, ExrWriteOptions.defaults().withCompression(Compression.NONE));
        assertEquals(Files.size(none), Files.size(zip));
        TestPatterns.assertPattern("noise", ExrReader.read(zip));
    }

    @Test
    void smoothRowsShrink() throws IOException {
        ExrImage image = TestPatterns.rgb("smooth", PixelType.FLOAT, 200, 100).build();
        Path file = directory.resolve("smooth.exr");
        ExrWriter.write(file, image);
        assertTrue(Files.size(file) < 200 * 100 * 12 / 4);
    }

    @Test
    void halvesAreRoundedWhenWritten() throws IOException {
        float[] samples = {1 + 0x1p-11f, 1 + 0x1.8p-10f, 70000, -1e-9f};
        Path file = directory.resolve("half.exr");
        ExrWriter.write(
                file,
                ExrImage.builder(2, 2).channel("Y", PixelType.HALF, samples).build());
        assertArrayEquals(
                new float[] {1, 1 + 0x1p-9f, Float.POSITIVE_INFINITY, -0f},
                ExrReader.read(file).samples("Y"));
    }

    @Test
    void layersAttributesAndWindowsComeBack() throws IOException {
        float[] rgb = new float[4 * 3 * 3];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = i;
        }
        Map<String, ExrAttribute> attributes = new LinkedHashMap<>();
        attributes.put("seed", new ExrAttribute.IntValue(-3));
        attributes.put("aMatrix", new ExrAttribute.Opaque("m33f", new byte[36]));
        attributes.put("badText", new ExrAttribute.Opaque("string", new byte[] {(byte) 0xff}));
        ExrImage image = ExrImage.builder(4, 3)
                .interleavedLayer("", PixelType.HALF, rgb, "R", "G", "B")
                .interleavedLayer("normal", PixelType.FLOAT, rgb, "X", "Y", "Z")
                .uintChannel("id", new int[12])
                .dataWindowOrigin(-2, 7)
                .displayWindow(new Box2i(-9, -9, 9, 9))
                .pixelAspectRatio(2)
                .screenWindow(new V2f(1, 2), 3)
                .attribute("renderer", "path \u2013 \u00fc")
                .attribute("exposure", 0.1f)
                .attribute("seconds", 0.1)
                .attribute("samples", 64)
                .attributes(attributes)
                .build();
        Path file = directory.resolve("layers.exr");
        ExrWriter.write(file, image);
        ExrImage read = ExrReader.read(file);
        assertEquals(image.header(), read.header());
        assertEquals(image.header(), ExrReader.readHeader(file));
        assertEquals(
                List.of("B", "G", "R", "id", "normal.X", "normal.Y", "normal.Z"),
                read.header().channelNames());
        assertEquals(List.of("", "normal"), read.header().layers());
        assertArrayEquals(rgb, read.interleaved("normal", "X", "Y", "Z"));
        assertArrayEquals(rgb, read.interleaved("", "R", "G", "B"));
    }

    @Test
    void arraysAreSharedNotCopied() {
        float[] plane = new float[6];
        ExrImage image =
                ExrImage.builder(3, 2).channel("Y", PixelType.FLOAT, plane).build();
        assertSame(plane, image.samples("Y"));
    }

    @Test
    void missingChannelsAreNamedTogetherWithTheOnesThereAre() {
        ExrImage image = ExrImage.builder(1, 1)
                .channel("Y", PixelType.FLOAT, new float[1])
                .uintChannel("id", new int[1])
                .build();
        assertEquals("no channel 'R'; the image has Y, id", message(() -> image.samples("R")));
        assertEquals("channel 'id' holds unsigned integers", message(() -> image.samples("id")));
        assertEquals("channel 'Y' holds floating-point numbers", message(() -> image.uintSamples("Y")));
    }

    @Test
    void wrongUseIsRefused() {
        ExrImage.Builder builder = ExrImage.builder(2, 2);
        assertEquals("there is no channel", message(builder::build));
        assertEquals(
                "channel 'Y' has 3 samples instead of 2 x 2",
                message(() -> builder.channel("Y", PixelType.HALF, new float[3])));
        assertEquals(
                "channel 'Y' of type UINT needs integers",
                message(() -> builder.channel("Y", PixelType.UINT, new float[4])));
        builder.channel("Y", PixelType.HALF, new float[4]);
        assertEquals("channel 'Y' appears twice", message(() -> builder.channel("Y", PixelType.HALF, new float[4])));
        assertEquals(
                "layer 'a' has 4 samples instead of 2 x 2 x 3",
                message(() -> builder.interleavedLayer("a", PixelType.HALF, new float[4], "R", "G", "B")));
        for (String name : List.of("", "a\0b", "\u00fc".repeat(128))) {
            assertTrue(message(() -> builder.attribute(name, 1)).contains("must have 1 to 255 bytes"));
            assertTrue(message(() -> builder.channel(name, PixelType.HALF, new float[4]))
                    .contains("must have 1 to 255 bytes"));
        }
        for (String name : List.of("channels", "version", "type", "dataWindow")) {
            assertEquals(
                    "attribute '" + name + "' is set by the file format itself",
                    message(() -> builder.attribute(name, "x")));
        }
        assertEquals("attribute 'name' must be a string", message(() -> builder.attribute("name", 1)));
        assertTrue(message(() -> ExrImage.builder(0, 5)).contains("at least one pixel"));
        assertTrue(message(() -> ExrImage.builder(1 << 20, 1 << 20)).contains("do not fit one array"));
        assertEquals(
                "compression PIZ can be read, but not written",
                message(() -> ExrWriteOptions.defaults().withCompression(Compression.PIZ)));
        assertTrue(message(() -> ExrWriteOptions.defaults().withThreads(0)).contains("at least 1"));
        assertTrue(message(() -> new ExrWriteOptions(Compression.ZIP, 10, 1)).contains("1 to 9"));
    }

    private static String message(Executable action) {
        return String.valueOf(
                assertThrows(IllegalArgumentException.class, action).getMessage());
    }

    @Test
    void aLongerNameThanOthersNeedsTheFlag() throws IOException {
        Path file = directory.resolve("long.exr");
        String name = "a".repeat(255);
        ExrImage image = ExrImage.builder(1, 1)
                .channel(name, PixelType.FLOAT, new float[] {2})
                .build();
        ExrWriter.write(file, image);
        assertEquals(0x402, Files.readAllBytes(file)[4] | Files.readAllBytes(file)[5] << 8);
        assertArrayEquals(new float[] {2}, ExrReader.read(file).samples(name));
    }

    @Test
    void anInterruptedThreadStillReadsAndWrites() throws IOException {
        ExrImage image = TestPatterns.rgb("smooth", PixelType.FLOAT, 640, 401).build();
        Path file = directory.resolve("interrupted.exr");
        Thread.currentThread().interrupt();
        ExrWriter.write(file, image, ExrWriteOptions.defaults().withThreads(2));
        ExrImage read = ExrReader.read(file, 2);
        assertTrue(Thread.interrupted(), "the flag must stay set");
        TestPatterns.assertPattern("smooth", read);
    }
}
