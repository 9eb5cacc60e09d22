package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** The sample patterns of {@code make_fixtures.py} and access to the files that it made. */
final class TestPatterns {
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
        int bits = x * 0x9E3779B1 + y * 0x85EBCA77 + k * 0xC2B2AE3D + 0x27D4EB2F;
        bits = (bits ^ (bits >>> 15)) * 0x2C1B3C6D;
        bits = (bits ^ (bits >>> 12)) * 0x297A2D39;
        bits ^= bits >>> 15;
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

    /** Compares all samples bit by bit; k counts the channels in file order. */
    static void assertPattern(String pattern, ExrImage image) {
        int k = 0;
        for (ExrChannel channel : image.header().channels()) {
            for (int i = 0; i < image.width() * image.height(); i++) {
                int expected = bits(pattern, channel.type(), i % image.width(), i / image.width(), k);
                assertEquals(expected, sampleBits(image, channel, i), channel.name() + " sample " + i);
            }
            k++;
        }
    }

    private static int sampleBits(ExrImage image, ExrChannel channel, int i) {
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

    static List<String> allFixtures() {
        List<String> names =
                new ArrayList<>(List.of("one_pixel.exr", "negative_origin.exr", "decreasing.exr", "layers.exr"));
        for (String compression : List.of("none", "zips", "zip")) {
            for (String type : List.of("half", "float", "uint")) {
                names.add(compression + "_" + type + "_smooth.exr");
                names.add(compression + "_" + type + "_noise.exr");
            }
        }
        return names;
    }
}
