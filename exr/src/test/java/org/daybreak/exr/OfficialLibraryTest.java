package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/**
 * The official library reads what we write, sample for sample: its Python wheel (check_written.py) all but reduced levels,
 * its C++ library (tiled_images.cpp) those too.
 */
class OfficialLibraryTest {
    private static final int[][] SIZES = {{1, 1}, {17, 35}, {64, 16}, {5, 100}};
    private static final List<Compression> COMPRESSIONS =
            List.of(Compression.NONE, Compression.RLE, Compression.ZIPS, Compression.ZIP);

    @TempDir
    Path directory;

    @Test
    @Timeout(120)
    void theOfficialWheelReadsOurFilesExactly() throws IOException, InterruptedException {
        assumeTrue(
                run(List.of("python3", "-c", "import numpy, OpenEXR; OpenEXR.File"))
                        .succeeded(),
                "skipped: python3 with the wheels OpenEXR and numpy is not installed on this machine");
        int files = writeScanLines() + writeTiles() + writeParts() + writeLayers();
        Result check = run(List.of("python3", "-B", "src/test/python/check_written.py", directory.toString()));
        assertEquals(files + " files agree", check.output().strip());
    }

    @Test
    @Timeout(120)
    void theOfficialLibraryReadsOurFilesExactly() throws IOException, InterruptedException {
        Result flags = run(List.of("pkg-config", "--cflags", "--libs", "OpenEXR"));
        assumeTrue(
                flags.succeeded() && run(List.of("g++", "--version")).succeeded(),
                "skipped: g++, pkg-config and the OpenEXR library for C++ are not installed on this machine");
        Path program = directory.resolve("tiled_images");
        List<String> compile = new ArrayList<>(
                List.of("g++", "-std=c++17", "-o", program.toString(), "src/test/cpp/tiled_images.cpp"));
        compile.addAll(List.of(flags.output().strip().split("\\s+")));
        Result compiled = run(compile);
        assertTrue(compiled.succeeded(), compiled.output());
        int files = writeScanLines() + writeTiles() + writeParts() + writeLayers();
        Result check = run(List.of(program.toString(), "check", directory.toString()));
        assertEquals(files + " files agree", check.output().strip());
    }

    private int writeScanLines() throws IOException {
        int files = 0;
        for (Compression compression : COMPRESSIONS) {
            for (PixelType type : PixelType.values()) {
                for (String pattern : List.of("smooth", "noise")) {
                    for (int[] size : SIZES) {
                        String name = fileName(compression, type.toString(), pattern, size[0] + "x" + size[1]);
                        ExrImage image = TestPatterns.rgb(pattern, type, size[0], size[1])
                                .dataWindowOrigin(-3, 5)
                                .displayWindow(Box2i.ofSize(100, 50))
                                .build();
                        write(name, List.of(image), compression);
                        files++;
                    }
                }
            }
        }
        return files;
    }

    private int writeTiles() throws IOException {
        int files = 0;
        for (Compression compression : COMPRESSIONS) {
            for (TileDescription.LevelMode mode : TileDescription.LevelMode.values()) {
                for (TileDescription.LevelRounding rounding : TileDescription.LevelRounding.values()) {
                    for (String pattern : List.of("smooth", "noise")) {
                        ExrImage image = mixed(13, 11)
                                .tiles(new TileDescription(8, 5, mode, rounding))
                                .build();
                        TestPatterns.fillLevels(pattern, image, 0);
                        String name = fileName(compression, "tiles", pattern, mode + "-" + rounding);
                        write(name, List.of(image), compression);
                        files++;
                    }
                }
            }
        }
        return files;
    }

    private int writeParts() throws IOException {
        for (Compression compression : COMPRESSIONS) {
            List<ExrImage> parts = List.of(
                    mixed(9, 21).name("left").build(),
                    mixed(10, 20).name("right").tiles(TileDescription.mipmap(4)).build(),
                    mixed(300, 200).name("depth").build());
            for (int part = 0; part < parts.size(); part++) {
                TestPatterns.fillLevels("smooth", parts.get(part), part);
            }
            write(fileName(compression, "parts", "smooth", "3"), parts, compression);
        }
        return COMPRESSIONS.size();
    }

    /** An image of the channels of tiled_images.cpp, all 0. */
    private static ExrImage.Builder mixed(int width, int height) {
        return ExrImage.builder(width, height)
                .channel("B", PixelType.FLOAT, new float[width * height])
                .channel("G", PixelType.HALF, new float[width * height])
                .uintChannel("id", new int[width * height])
                .dataWindowOrigin(-3, 5)
                .displayWindow(Box2i.ofSize(100, 50));
    }

    private static String fileName(Compression compression, String kind, String pattern, String rest) {
        return String.join("_", compression.name(), kind, pattern, rest).toLowerCase(Locale.ROOT) + ".exr";
    }

    private void write(String name, List<ExrImage> parts, Compression compression) throws IOException {
        ExrWriter.writeParts(
                directory.resolve(name), parts, ExrWriteOptions.defaults().withCompression(compression));
    }

    private int writeLayers() throws IOException {
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
        return 1;
    }

    /** What a program has printed, and whether it could be started and ended well. */
    private record Result(boolean succeeded, String output) {}

    private static Result run(List<String> command) throws InterruptedException {
        try {
            Process process =
                    new ProcessBuilder(command).redirectErrorStream(true).start();
            String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            return new Result(process.waitFor() == 0, output);
        } catch (IOException e) {
            // There is no such program.
            return new Result(false, String.valueOf(e.getMessage()));
        }
    }
}
