package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Files made by the official library (make_fixtures.py) are read sample for sample. */
class ExrFixturesTest {
    @TempDir
    Path directory;

    private ExrImage read(String name) throws IOException {
        return ExrReader.read(TestPatterns.put(directory, name, TestPatterns.fixture(name)));
    }

    @ParameterizedTest
    @CsvSource({"none", "zips", "zip"})
    void everyTypeIsReadExactly(String compression) throws IOException {
        for (PixelType type : PixelType.values()) {
            for (String pattern : List.of("smooth", "noise")) {
                String typeName = type.name().toLowerCase(Locale.ROOT);
                ExrImage image = read(compression + "_" + typeName + "_" + pattern + ".exr");
                ExrHeader header = image.header();
                assertEquals(
                        compression.toUpperCase(Locale.ROOT),
                        header.compression().name());
                assertEquals(new Box2i(0, 0, 16, 34), header.dataWindow());
                assertEquals(header.dataWindow(), header.displayWindow());
                assertEquals(List.of("B", "G", "R"), header.channelNames());
                assertEquals(type, header.channels().get(0).type());
                assertEquals(Map.of(), header.attributes());
                TestPatterns.assertPattern(pattern, image);
            }
        }
    }

    @Test
    void onePixel() throws IOException {
        ExrImage image = read("one_pixel.exr");
        assertEquals(1, image.width());
        assertEquals(1, image.height());
        assertArrayEquals(new float[] {-8}, image.samples("Y"));
    }

    @Test
    void windowsWithNegativeOrigin() throws IOException {
        ExrImage image = read("negative_origin.exr");
        assertEquals(new Box2i(-5, -7, 11, 12), image.header().dataWindow());
        assertEquals(new Box2i(0, 0, 9, 11), image.header().displayWindow());
        assertEquals(1.5f, image.header().pixelAspectRatio());
        assertEquals(new V2f(0.25f, -0.5f), image.header().screenWindowCenter());
        assertEquals(2f, image.header().screenWindowWidth());
        TestPatterns.assertPattern("smooth", image);
    }

    @Test
    void chunksInDecreasingOrder() throws IOException {
        ExrImage image = read("decreasing.exr");
        assertEquals(LineOrder.DECREASING_Y, image.header().lineOrder());
        assertEquals(new Box2i(3, -2, 15, 34), image.header().dataWindow());
        TestPatterns.assertPattern("smooth", image);
    }

    @Test
    void layersAndAttributes() throws IOException {
        ExrImage image = read("layers.exr");
        TestPatterns.assertPattern("smooth", image);
        ExrHeader header = image.header();
        assertEquals(
                List.of("", "a channel whose name is longer than 31 bytes", "albedo", "light.key"), header.layers());
        assertEquals(PixelType.UINT, channel(header, "id").type());
        assertEquals("light.key", channel(header, "light.key.R").layer());
        assertEquals("R", channel(header, "light.key.R").component());
        float[] albedo = image.interleaved("albedo", "R", "G", "B");
        assertEquals(image.samples("albedo.G")[40], albedo[40 * 3 + 1]);

        Map<String, ExrAttribute> attributes = header.attributes();
        assertEquals(new ExrAttribute.IntValue(-7), attributes.get("anInt"));
        assertEquals(new ExrAttribute.FloatValue(0.5f), attributes.get("aFloat"));
        assertEquals(new ExrAttribute.StringValue("Daybreak \u2013 \u00fcber"), attributes.get("aString"));
        assertEquals(new ExrAttribute.V2iValue(new V2i(3, -4)), attributes.get("aV2i"));
        assertEquals(new ExrAttribute.V2fValue(new V2f(0.25f, -4)), attributes.get("aV2f"));
        assertEquals(new ExrAttribute.Box2iValue(new Box2i(1, 2, 3, 5)), attributes.get("aBox2i"));
        assertEquals(new ExrAttribute.Box2fValue(new Box2f(0.5f, 1, 2, 3)), attributes.get("aBox2f"));
        assertEquals(new ExrAttribute.ChromaticitiesValue(Chromaticities.REC_709), attributes.get("chromaticities"));
        ExrAttribute.Opaque matrix = assertInstanceOf(ExrAttribute.Opaque.class, attributes.get("aMatrix"));
        assertEquals("m33f", matrix.typeName());
        assertEquals(36, matrix.bytes().length);
    }

    private static ExrChannel channel(ExrHeader header, String name) {
        ExrChannel channel = header.channel(name);
        if (channel == null) {
            throw new AssertionError("no channel " + name);
        }
        return channel;
    }

    @Test
    void readingAndWritingKeepsEverything() throws IOException {
        for (String name : TestPatterns.allFixtures()) {
            ExrImage first = read(name);
            for (Compression compression : List.of(Compression.NONE, Compression.ZIPS, Compression.ZIP)) {
                Path copy = directory.resolve("copy.exr");
                ExrWriter.write(copy, first, ExrWriteOptions.defaults().withCompression(compression));
                ExrImage second = ExrReader.read(copy);
                ExrHeader a = first.header();
                ExrHeader b = second.header();
                assertEquals(compression, b.compression());
                assertEquals(LineOrder.INCREASING_Y, b.lineOrder());
                assertEquals(a.dataWindow(), b.dataWindow());
                assertEquals(a.displayWindow(), b.displayWindow());
                assertEquals(a.pixelAspectRatio(), b.pixelAspectRatio());
                assertEquals(a.screenWindowCenter(), b.screenWindowCenter());
                assertEquals(a.screenWindowWidth(), b.screenWindowWidth());
                assertEquals(a.channels(), b.channels());
                assertEquals(
                        List.copyOf(a.attributes().entrySet()),
                        List.copyOf(b.attributes().entrySet()));
                TestPatterns.assertPattern(name.contains("noise") ? "noise" : "smooth", second);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"RLE", "PIZ", "PXR24", "B44", "B44A", "DWAA", "DWAB", "HTJ2K256", "HTJ2K32", "ZSTD"})
    void compressionsThatAreNotSupportedAreRefusedByName(String compression) throws IOException {
        String name = "refused_" + compression.toLowerCase(Locale.ROOT) + ".exr";
        Path file = TestPatterns.put(directory, name, TestPatterns.fixture(name));
        assertEquals(compression, ExrReader.readHeader(file).compression().name());
        assertReason(file, "compression " + compression + " is not supported");
    }

    @ParameterizedTest
    @CsvSource({
        "refused_tiled.exr,tiled images are not supported",
        "refused_multipart.exr,multi-part files are not supported",
        "refused_deep.exr,deep images are not supported"
    })
    void kindsThatAreNotSupportedAreRefusedByName(String name, String reason) throws IOException {
        assertReason(TestPatterns.put(directory, name, TestPatterns.fixture(name)), reason);
    }

    static void assertReason(Path file, String reason) {
        ImageFileException e = assertThrows(ImageFileException.class, () -> ExrReader.read(file));
        assertTrue(e.reason().contains(reason), e.reason());
        assertEquals(file + ": " + e.reason(), e.getMessage());
    }
}
