package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

/** Reduced levels that we make, and rules on parts. */
class ExrLevelsTest {
    @TempDir
    Path directory;

    @Test
    void aLevelIsTheMeanOfTheAreaAndLabelsArePicked() {
        float[] samples = {1, 3, 5, 7, 9, 11};
        ExrImage image = ExrImage.builder(3, 2)
                .channel("Y", PixelType.FLOAT, samples)
                .uintChannel("id", new int[] {1, 2, 3, 4, 5, 6})
                .tiles(TileDescription.mipmap(2))
                .build();
        assertEquals(2, image.xLevels());
        assertArrayEquals(new float[] {6}, image.level(1, 1).samples("Y"));
        assertArrayEquals(new int[] {5}, image.level(1, 1).uintSamples("id"));
        ExrImage up = image.toBuilder()
                .tiles(new TileDescription(2, 2, TileDescription.LevelMode.RIPMAP, TileDescription.LevelRounding.UP))
                .build();
        assertEquals(3, up.xLevels());
        assertEquals(2, up.yLevels());
        // Columns 0 to 1.5 and 1.5 to 3.
        assertArrayEquals(
                new float[] {(1 + 3 / 2f) / 1.5f, (3 / 2f + 5) / 1.5f, (7 + 9 / 2f) / 1.5f, (9 / 2f + 11) / 1.5f},
                up.level(1, 0).samples("Y"),
                1e-6f);
        assertArrayEquals(new float[] {4, 6, 8}, up.level(0, 1).samples("Y"));
        assertArrayEquals(new float[] {6}, up.level(2, 1).samples("Y"), 1e-6f);
    }

    /** The mean of the whole image is the last level. */
    @Test
    void theLastLevelIsTheMean() {
        float[] samples = TestPatterns.floats("smooth", PixelType.FLOAT, 37, 21, 0);
        double mean = 0;
        for (float sample : samples) {
            mean += sample / samples.length;
        }
        for (TileDescription.LevelRounding rounding : TileDescription.LevelRounding.values()) {
            ExrImage image = ExrImage.builder(37, 21)
                    .channel("Y", PixelType.FLOAT, samples)
                    .tiles(new TileDescription(16, 16, TileDescription.LevelMode.MIPMAP, rounding))
                    .build();
            int last = image.xLevels() - 1;
            assertEquals(mean, image.level(last, last).samples("Y")[0], 1e-5);
        }
    }

    @Test
    void tilesComeBackWithTheirLevels() throws IOException {
        ExrImage image = TestPatterns.rgb("smooth", PixelType.FLOAT, 700, 300)
                .tiles(TileDescription.mipmap(64))
                .attribute("owner", "me")
                .build();
        Path file = directory.resolve("mip.exr");
        ExrWriter.write(file, image);
        ExrImage read = ExrReader.read(file, 3);
        assertEquals(image.header(), read.header());
        for (int level = 0; level < image.xLevels(); level++) {
            for (String channel : List.of("R", "G", "B")) {
                assertArrayEquals(
                        image.level(level, level).samples(channel),
                        read.level(level, level).samples(channel));
            }
        }
        ExrImage lines = read.toBuilder().tiles(null).build();
        assertEquals(1, lines.xLevels());
        assertEquals(image.header().attributes(), lines.header().attributes());
    }

    @Test
    void partsNeedNamesAndOneDisplayWindow() {
        ExrImage.Builder part = TestPatterns.rgb("smooth", PixelType.HALF, 4, 3);
        ExrImage unnamed = part.build();
        ExrImage left = part.name("left").build();
        ExrImage other = part.name("right").displayWindow(Box2i.ofSize(9, 9)).build();
        assertEquals("each part needs a name of its own, not ''", message(left, unnamed));
        assertEquals("each part needs a name of its own, not 'left'", message(left, left));
        assertEquals(
                "part 'right' has another display window or pixel aspect ratio than the first part",
                message(left, other));
        ExrImage colours = unnamed.toBuilder()
                .name("third")
                .attribute("chromaticities", new ExrAttribute.ChromaticitiesValue(Chromaticities.REC_709))
                .build();
        assertEquals("part 'third' differs from the first part in 'chromaticities'", message(left, colours));
        assertEquals("a file needs at least one part", message());
    }

    private static String message(ExrImage... parts) {
        Executable write = () -> ExrWriter.toBytes("x", List.of(parts), ExrWriteOptions.defaults());
        return String.valueOf(
                assertThrows(IllegalArgumentException.class, write).getMessage());
    }

    @Test
    void tilesNeedASize() {
        assertTrue(String.valueOf(assertThrows(IllegalArgumentException.class, () -> TileDescription.oneLevel(0))
                        .getMessage())
                .contains("at least one pixel"));
    }
}
