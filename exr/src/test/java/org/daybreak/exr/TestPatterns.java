package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.ObjIntConsumer;

/** The sample patterns of {@code make_fixtures.py} and access to the files that it made. */
final class TestPatterns {
    static final List<String> COMPRESSIONS = List.of("none", "rle", "zips", "zip", "piz", "pxr24");

    private static final int RAMP_WIDTH = 640;

    private TestPatterns() {}

    /** Bits of a sample as they stand in the file; for HALF in the lower 16 bits. */
    static int bits(String pattern, PixelType type, int x, int y, int k) {
        if (pattern.equals("smooth")) {
            int step = (x * 3 + y * 5 + k * 7) % 257;
            float value = (step - 128) / 16f;
            return switch (type) {
                case UINT -> step;
                case FLOAT -> Float.floatToRawIntBits(value);
                case HALF -> Half.fromFloat(value) & 0xffff;
            };
        }
        if (pattern.equals("ramp")) {
            int count = x + y * RAMP_WIDTH + k;
            return type == PixelType.HALF ? count & 0xffff : count;
        }
        int bits = x * 0x9E3779B1 + y * 0x85EBCA77 + k * 0xC2B2AE3D + 0x27D4EB2F;
        bits = (bits ^ (bits >>> 15)) * 0x2C1B3C6D;
        bits = (bits ^ (bits >>> 12)) * 0x297A2D39;
        bits ^= bits >>> 15;
        if (pattern.equals("noise24")) {
            bits &= ~0xff;
        }
        return type == PixelType.HALF ? bits >>> 16 : bits;
    }

    static float[] floats(String pattern, PixelType type, int width, int height, int k) {
        float[] plane = new float[width * height];
        for (int i = 0; i < plane.length; i++) {
            int bits = bits(pattern, type, i % width, i / width, k);
            plane[i] = type == PixelType.HALF ? Half.toFloat((short) bits) : Float.intBitsToFloat(bits);
        }
        return plane;
    }

    static int[] uints(String pattern, int width, int height, int k) {
        int[] plane = new int[width * height];
        for (int i = 0; i < plane.length; i++) {
            plane[i] = bits(pattern, PixelType.UINT, i % width, i / width, k);
        }
        return plane;
    }

    /** An image with channels B, G, R of a pattern. */
    static ExrImage.Builder rgb(String pattern, PixelType type, int width, int height) {
        ExrImage.Builder builder = ExrImage.builder(width, height);
        String[] names = {"B", "G", "R"};
        for (int k = 0; k < names.length; k++) {
            if (type == PixelType.UINT) {
                builder.uintChannel(names[k], uints(pattern, width, height, k));
            } else {
                builder.channel(names[k], type, floats(pattern, type, width, height, k));
            }
        }
        return builder;
    }

    /** Compares all samples of the full level bit by bit; k counts the channels in file order. */
    static void assertPattern(String pattern, ExrImage image) {
        assertPattern(pattern, image.header(), image.level(0, 0), 0);
    }

    /** Compares all samples of all levels, numbered as in tiled_images.cpp. */
    static void assertLevels(String pattern, ExrImage image, int part) {
        eachLevel(
                image,
                (x, y) -> assertPattern(pattern, image.header(), image.level(x, y), 10 * x + 100 * y + 1000 * part));
    }

    /** Fills all levels, numbered as in tiled_images.cpp. */
    static void fillLevels(String pattern, ExrImage image, int part) {
        eachLevel(image, (x, y) -> {
            int k = 10 * x + 100 * y + 1000 * part;
            ExrLevel level = image.level(x, y);
            for (ExrChannel channel : image.header().channels()) {
                if (channel.type() == PixelType.UINT) {
                    int[] plane = uints(pattern, level.width(), level.height(), k++);
                    System.arraycopy(plane, 0, level.uintSamples(channel.name()), 0, plane.length);
                } else {
                    float[] plane = floats(pattern, channel.type(), level.width(), level.height(), k++);
                    System.arraycopy(plane, 0, level.samples(channel.name()), 0, plane.length);
                }
            }
        });
    }

    private static void eachLevel(ExrImage image, ObjIntConsumer<Integer> action) {
        TileDescription tiles = image.header().tiles();
        boolean rip = tiles != null && tiles.mode() == TileDescription.LevelMode.RIPMAP;
        for (int y = 0; y < image.yLevels(); y++) {
            for (int x = rip ? 0 : y; x < (rip ? image.xLevels() : y + 1); x++) {
                action.accept(x, y);
            }
        }
    }

    private static void assertPattern(String pattern, ExrHeader header, ExrLevel level, int firstK) {
        int k = firstK;
        for (ExrChannel channel : header.channels()) {
            for (int i = 0; i < level.width() * level.height(); i++) {
                int expected = bits(pattern, channel.type(), i % level.width(), i / level.width(), k);
                if (expected != sampleBits(level, channel, i)) {
                    assertEquals(expected, sampleBits(level, channel, i), channel.name() + " sample " + i);
                }
            }
            k++;
        }
    }

    private static int sampleBits(ExrLevel image, ExrChannel channel, int i) {
        return switch (channel.type()) {
            case UINT -> image.uintSamples(channel.name())[i];
            case FLOAT -> Float.floatToRawIntBits(image.samples(channel.name())[i]);
            case HALF -> Half.fromFloat(image.samples(channel.name())[i]) & 0xffff;
        };
    }

    static byte[] fixture(String name) {
        try (InputStream in = TestPatterns.class.getResourceAsStream(name)) {
            if (in == null) {
                throw new AssertionError("no fixture " + name);
            }
            return in.readAllBytes();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /**
     * Writes bytes to a file. An old file is deleted first: some file systems flush a file to the disk that is cut to
     * nothing and written again, which takes most of the time of a test with thousands of files.
     */
    static Path put(Path directory, String name, byte[] bytes) throws IOException {
        Path file = directory.resolve(name);
        Files.deleteIfExists(file);
        return Files.write(file, bytes);
    }

    /** Places at which ASCII text stands in bytes. */
    static int find(byte[] bytes, String text) {
        for (int i = 0; i + text.length() <= bytes.length; i++) {
            boolean same = true;
            for (int j = 0; same && j < text.length(); j++) {
                same = bytes[i + j] == (byte) text.charAt(j);
            }
            if (same) {
                return i;
            }
        }
        throw new AssertionError("'" + text + "' is not in the bytes");
    }

    /** The place of the value of an attribute. */
    static int valueOf(byte[] bytes, String name, String type) {
        String head = name + "\0" + type + "\0";
        return find(bytes, head) + head.length() + Integer.BYTES;
    }

    static void putInt(byte[] bytes, int place, int value) {
        for (int i = 0; i < Integer.BYTES; i++) {
            bytes[place + i] = (byte) (value >>> (8 * i));
        }
    }

    /** All fixtures of one part in scan lines. */
    static List<String> scanlineFixtures() {
        List<String> names =
                new ArrayList<>(List.of("one_pixel.exr", "negative_origin.exr", "decreasing.exr", "layers.exr"));
        for (String compression : COMPRESSIONS) {
            for (String type : List.of("half", "float", "uint")) {
                names.add(compression + "_" + type + "_smooth.exr");
                names.add(compression + "_" + type + "_"
                        + (compression.equals("pxr24") && type.equals("float") ? "noise24" : "noise") + ".exr");
            }
        }
        for (String type : List.of("half", "float", "uint")) {
            names.add("piz_" + type + "_ramp.exr");
        }
        return names;
    }

    /** All fixtures of one part in tiles that tiled_images.cpp made. */
    static List<String> tiledFixtures() {
        List<String> names = new ArrayList<>(List.of("tiled_zip_mip_noise.exr", "tiled_piz_rip_noise.exr"));
        for (String compression : COMPRESSIONS) {
            for (String levels : List.of("one_down", "one_up", "mip_down", "mip_up", "rip_down", "rip_up")) {
                names.add("tiled_" + compression + "_" + levels + ".exr");
            }
        }
        return names;
    }

    /** The pattern of a fixture. */
    static String pattern(String fixture) {
        for (String pattern : List.of("noise24", "noise", "ramp")) {
            if (fixture.contains(pattern)) {
                return pattern;
            }
        }
        return "smooth";
    }
}
