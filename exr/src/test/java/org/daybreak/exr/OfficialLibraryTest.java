package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** The official library reads what we write, sample for sample (check_written.py). */
class OfficialLibraryTest {
    private static final int[][] SIZES = {{1, 1}, {17, 35}, {64, 16}, {5, 100}};

    @TempDir
    Path directory;

    @Test
    @Timeout(120)
    void theOfficialLibraryReadsOurFilesExactly() throws IOException, InterruptedException {
        assumeTrue(
                pythonHasOpenExr(),
                "skipped: python3 with the wheels OpenEXR and numpy is not installed on this machine");
        int files = 0;
        for (Compression compression : List.of(Compression.NONE, Compression.ZIPS, Compression.ZIP)) {
            for (PixelType type : PixelType.values()) {
                for (String pattern : List.of("smooth", "noise")) {
                    for (int[] size : SIZES) {
                        String name = String.join("_", compression.name(), type.name(), pattern)
                                        .toLowerCase(Locale.ROOT)
                                + "_" + size[0] + "x" + size[1] + ".exr";
                        ExrImage image = TestPatterns.rgb(pattern, type, size[0], size[1])
                                .dataWindowOrigin(-3, 5)
                                .displayWindow(Box2i.ofSize(100, 50))
                                .build();
                        ExrWriter.write(
                                directory.resolve(name),
                                image,
                                ExrWriteOptions.defaults().withCompression(compression));
                        files++;
                    }
                }
            }
        }
        writeLayers();
        files++;
        Process python = new ProcessBuilder("python3", "-B", "src/test/python/check_written.py", directory.toString())
                .redirectErrorStream(true)
                .start();
        String output = new String(python.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
        assertEquals(0, python.waitFor(), output);
        assertEquals(files + " files agree", output.strip());
    }

    private void writeLayers() throws IOException {
        ByteBuffer matrix = ByteBuffer.allocate(36).order(ByteOrder.LITTLE_ENDIAN);
        for (int i = 0; i < 9; i++) {
            matrix.putFloat(i);
        }
        String longName = "a channel whose name is longer than 31 bytes.Y";
        // k counts the channels in sorted order: R, Z, the long name, albedo.R, id.
        ExrImage image = ExrImage.builder(9, 21)
                .uintChannel("id", TestPatterns.uints("smooth", 9, 21, 4))
                .channel("albedo.R", PixelType.HALF, TestPatterns.floats("smooth", PixelType.HALF, 9, 21, 3))
                .channel(longName, PixelType.FLOAT, TestPatterns.floats("smooth", PixelType.FLOAT, 9, 21, 2))
                .channel("Z", PixelType.FLOAT, TestPatterns.floats("smooth", PixelType.FLOAT, 9, 21, 1))
                .channel("R", PixelType.HALF, TestPatterns.floats("smooth", PixelType.HALF, 9, 21, 0))
                .attribute("renderer", "path \u2013 \u00fc")
                .attribute("samples", 64)
                .attribute("time", 1.5)
                .attribute("crop", new ExrAttribute.Box2iValue(new Box2i(1, 2, 3, 4)))
                .attribute("chromaticities", new ExrAttribute.ChromaticitiesValue(Chromaticities.REC_709))
                .attribute("aMatrix", new ExrAttribute.Opaque("m33f", matrix.array()))
                .build();
        ExrWriter.write(directory.resolve("layers.exr"), image);
    }

    private static boolean pythonHasOpenExr() throws InterruptedException {
        try {
            Process python = new ProcessBuilder("python3", "-c", "import numpy, OpenEXR; OpenEXR.File")
                    .redirectErrorStream(true)
                    .start();
            python.getInputStream().readAllBytes();
            return python.waitFor() == 0;
        } catch (IOException e) {
            // No python3 at all.
            return false;
        }
    }
}
