package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Files made by the official library (make_fixtures.py) are read sample for sample. */
class ExrFixturesTest {
    @TempDir
    Path directory;

    private ExrImage read(String name) throws IOException {
        return ExrReader.read(TestPatterns.put(directory, name, TestPatterns.fixture(name)));
    }

    private List<ExrImage> readParts(String name) throws IOException {
        return ExrReader.readParts(name, TestPatterns.fixture(name), 2);
    }

    static List<String> scanlineFixtures() {
        return TestPatterns.scanlineFixtures();
    }

    static List<String> tiledFixtures() {
        return TestPatterns.tiledFixtures();
    }

    static List<String> compressions() {
        return TestPatterns.COMPRESSIONS;
    }

    @ParameterizedTest
    @MethodSource("scanlineFixtures")
    void everyScanlineImageIsReadExactly(String name) throws IOException {
        ExrImage image = read(name);
        TestPatterns.assertPattern(TestPatterns.pattern(name), image);
        String[] words = name.split("_", -1);
        if (TestPatterns.COMPRESSIONS.contains(words[0])) {
            ExrHeader header = image.header();
            assertEquals(words[0].toUpperCase(Locale.ROOT), header.compression().name());
            assertEquals(
                    words[1].toUpperCase(Locale.ROOT),
                    header.channels().get(0).type().name());
            assertEquals(header.dataWindow(), header.displayWindow());
            assertEquals(Map.of(), header.attributes());
        }
    }

    @ParameterizedTest
    @MethodSource("tiledFixtures")
    void everyLevelOfTiledImagesIsReadExactly(String name) throws IOException {
        ExrImage image = readParts(name).get(0);
        TestPatterns.assertLevels(TestPatterns.pattern(name), image, 0);
        TileDescription tiles = image.header().tiles();
        assertNotNull(tiles);
        assertEquals(8, tiles.width());
        assertEquals(5, tiles.height());
        boolean up = tiles.rounding() == TileDescription.LevelRounding.UP;
        // 13 x 11 pixels: halved, 6, 3 and 1 or 7, 4, 2 and 1 columns.
        int[] expected = switch (tiles.mode()) {
            case ONE_LEVEL -> new int[] {1, 1};
            case MIPMAP, RIPMAP -> up ? new int[] {5, 5} : new int[] {4, 4};
        };
        assertArrayEquals(expected, new int[] {image.xLevels(), image.yLevels()});
        assertEquals(new Box2i(-3, 5, 9, 15), image.header().dataWindow());
    }

    @ParameterizedTest
    @MethodSource("compressions")
    void partsAreReadExactly(String compression) throws IOException {
        List<ExrImage> parts = readParts("parts_" + compression + ".exr");
        assertEquals(
                List.of("left", "right", "depth"),
                parts.stream().map(part -> part.header().name()).toList());
        for (int part = 0; part < parts.size(); part++) {
            TestPatterns.assertLevels("smooth", parts.get(part), part);
            assertEquals(9 + part, parts.get(part).width());
        }
        TileDescription tiles = parts.get(1).header().tiles();
        assertEquals(
                new TileDescription(4, 6, TileDescription.LevelMode.MIPMAP, TileDescription.LevelRounding.UP), tiles);
        assertNull(parts.get(0).header().tiles());
    }

    @Test
    void tilesAndPartsOfTheWheel() throws IOException {
        ExrImage tiled = read("tiled_smooth.exr");
        assertEquals(
                new TileDescription(16, 8, TileDescription.LevelMode.ONE_LEVEL, TileDescription.LevelRounding.DOWN),
                tiled.header().tiles());
        TestPatterns.assertPattern("smooth", tiled);
        Path file = TestPatterns.put(directory, "parts.exr", TestPatterns.fixture("parts_smooth.exr"));
        List<ExrImage> parts = ExrReader.readParts(file);
        List<ExrHeader> headers = ExrReader.readHeaders(file);
        for (int i = 0; i < 2; i++) {
            TestPatterns.assertPattern("smooth", parts.get(i));
            assertEquals(headers.get(i), parts.get(i).header());
            assertEquals(List.of("left", "right").get(i), headers.get(i).name());
        }
        assertEquals(Compression.PIZ, headers.get(1).compression());
        // The image of a file with several parts is its first one.
        assertEquals(headers.get(0), ExrReader.read(file).header());
        assertEquals(headers.get(0), ExrReader.readHeader(file));
    }

    @Test
    void levelsThatAreNotThere() throws IOException {
        ExrImage mip = read("tiled_zip_mip_down.exr");
        for (int[] level : new int[][] {{0, 1}, {4, 4}, {-1, -1}}) {
            assertThrows(IllegalArgumentException.class, () -> mip.level(level[0], level[1]));
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
        List<String> names = new ArrayList<>(TestPatterns.scanlineFixtures());
        names.addAll(TestPatterns.tiledFixtures());
        TestPatterns.COMPRESSIONS.forEach(compression -> names.add("parts_" + compression + ".exr"));
        names.add("parts_smooth.exr");
        for (String name : names) {
            List<ExrImage> first = readParts(name);
            for (Compression compression : Compression.values()) {
                if (!compression.isWritable()) {
                    continue;
                }
                byte[] bytes = ExrWriter.toBytes(
                        name, first, ExrWriteOptions.defaults().withCompression(compression));
                List<ExrImage> second = ExrReader.readParts(name, bytes, 1);
                assertEquals(first.size(), second.size());
                for (int part = 0; part < first.size(); part++) {
                    ExrHeader a = first.get(part).header();
                    assertHeader(a, compression, second.get(part).header());
                    if (name.startsWith("tiled_") || name.startsWith("parts_")) {
                        int number = name.equals("parts_smooth.exr") ? 0 : part;
                        TestPatterns.assertLevels(TestPatterns.pattern(name), second.get(part), number);
                    } else {
                        TestPatterns.assertPattern(TestPatterns.pattern(name), second.get(part));
                    }
                }
            }
        }
    }

    private static void assertHeader(ExrHeader a, Compression compression, ExrHeader b) {
        assertEquals(compression, b.compression());
        assertEquals(LineOrder.INCREASING_Y, b.lineOrder());
        assertEquals(a.dataWindow(), b.dataWindow());
        assertEquals(a.displayWindow(), b.displayWindow());
        assertEquals(a.pixelAspectRatio(), b.pixelAspectRatio());
        assertEquals(a.screenWindowCenter(), b.screenWindowCenter());
        assertEquals(a.screenWindowWidth(), b.screenWindowWidth());
        assertEquals(a.channels(), b.channels());
        assertEquals(a.tiles(), b.tiles());
        assertEquals(
                List.copyOf(a.attributes().entrySet()),
                List.copyOf(b.attributes().entrySet()));
    }

    @ParameterizedTest
    @ValueSource(strings = {"B44", "B44A", "DWAA", "DWAB", "HTJ2K256", "HTJ2K32", "ZSTD"})
    void compressionsThatAreNotSupportedAreRefusedByName(String compression) throws IOException {
        String name = "refused_" + compression.toLowerCase(Locale.ROOT) + ".exr";
        Path file = TestPatterns.put(directory, name, TestPatterns.fixture(name));
        assertEquals(compression, ExrReader.readHeader(file).compression().name());
        assertReason(file, "compression " + compression + " is not supported");
    }

    @Test
    void deepImagesAreRefusedByName() throws IOException {
        assertReason(
                TestPatterns.put(directory, "deep.exr", TestPatterns.fixture("refused_deep.exr")),
                "deep images are not supported");
    }

    static void assertReason(Path file, String reason) {
        ImageFileException e = assertThrows(ImageFileException.class, () -> ExrReader.read(file));
        assertTrue(e.reason().contains(reason), e.reason());
        assertEquals(file + ": " + e.reason(), e.getMessage());
    }
}
