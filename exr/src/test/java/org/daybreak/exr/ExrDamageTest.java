package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Files that cannot be read give one clear error, whatever is wrong with them. */
class ExrDamageTest {
    private static final String BASE = "zip_half_smooth.exr";

    @TempDir
    Path directory;

    private void assertReason(byte[] bytes, String reason) throws IOException {
        ExrFixturesTest.assertReason(TestPatterns.put(directory, "damaged.exr", bytes), reason);
    }

    private static byte[] base() {
        return TestPatterns.fixture(BASE);
    }

    private static int twoBytes(byte[] bytes, int place) {
        return (bytes[place] & 0xff) | (bytes[place + 1] & 0xff) << 8;
    }

    /** The place of the chunk offset table. Its smallest offset must point just behind it, or the place is wrong. */
    private static int offsetTable(byte[] bytes, int chunks) {
        int table = TestPatterns.find(bytes, "scanlineimage") + "scanlineimage".length() + 1;
        int smallest = Integer.MAX_VALUE;
        for (int i = 0; i < chunks; i++) {
            smallest = Math.min(smallest, twoBytes(bytes, table + 8 * i));
        }
        assertEquals(table + 8 * chunks, smallest);
        return table;
    }

    @Test
    void emptyFile() throws IOException {
        assertReason(new byte[0], "the file is empty");
    }

    @Test
    void garbage() throws IOException {
        byte[] bytes = new byte[500];
        new SplittableRandom(2).nextBytes(bytes);
        assertReason(bytes, "is not an OpenEXR file (wrong magic number)");
        assertReason("# Radiance".getBytes(StandardCharsets.US_ASCII), "is not an OpenEXR file");
    }

    @Test
    void filesThatCannotBeOpened() throws IOException {
        ExrFixturesTest.assertReason(directory, "is a directory");
        ExrFixturesTest.assertReason(directory.resolve("none.exr"), "no such file");
        Path device = Path.of("/dev/zero");
        if (Files.exists(device)) {
            ExrFixturesTest.assertReason(device, "is not a regular file");
        }
    }

    @Test
    void unreadableFile() throws IOException {
        Path file = TestPatterns.put(directory, "secret.exr", base());
        assumeTrue(file.toFile().setReadable(false) && !Files.isReadable(file), "skipped: this user reads every file");
        ExrFixturesTest.assertReason(file, "permission to read is denied");
    }

    @Test
    void everyTruncationIsRefused() throws IOException {
        for (String name : new String[] {BASE, "none_half_smooth.exr", "zips_uint_smooth.exr", "decreasing.exr"}) {
            byte[] bytes = TestPatterns.fixture(name);
            // Every length within header and table, then a sample: the remainder is alike.
            for (int length = 0; length < bytes.length; length += length < 900 ? 1 : 61) {
                Path file = TestPatterns.put(directory, "cut.exr", Arrays.copyOf(bytes, length));
                ImageFileException e = assertThrows(ImageFileException.class, () -> ExrReader.read(file));
                String reason = e.reason();
                assertTrue(
                        reason.contains("truncated") || reason.contains("empty") || reason.contains("claims"), reason);
            }
        }
    }

    @Test
    void hugeDataWindowsTakeNoMemory() throws IOException {
        int[][] windows = {
            {0, 0, Integer.MAX_VALUE, Integer.MAX_VALUE},
            {Integer.MIN_VALUE, Integer.MIN_VALUE, Integer.MAX_VALUE, Integer.MAX_VALUE},
            {0, 0, Integer.MAX_VALUE, 0},
            {0, 0, 0, Integer.MAX_VALUE},
            {0, 0, 1 << 30, 1},
            {0, 0, 40000, 40000},
            {0, 0, 16, 1 << 24},
        };
        for (String name : new String[] {BASE, "none_half_smooth.exr"}) {
            for (int[] window : windows) {
                byte[] bytes = TestPatterns.fixture(name);
                int place = TestPatterns.valueOf(bytes, "dataWindow", "box2i");
                for (int i = 0; i < 4; i++) {
                    TestPatterns.putInt(bytes, place + 4 * i, window[i]);
                }
                ImageFileException e = assertThrows(
                        ImageFileException.class, () -> ExrReader.read(TestPatterns.put(directory, "huge.exr", bytes)));
                assertTrue(e.reason().contains("large") || e.reason().contains("cannot hold"), e.reason());
            }
        }
    }

    @Test
    void emptyWindows() throws IOException {
        for (String name : new String[] {"dataWindow", "displayWindow"}) {
            byte[] bytes = base();
            TestPatterns.putInt(bytes, TestPatterns.valueOf(bytes, name, "box2i") + 8, -1);
            assertReason(bytes, "window is empty");
        }
    }

    @Test
    void damagedHeaders() throws IOException {
        byte[] version = base();
        version[4] = 3;
        assertReason(version, "OpenEXR version 3 is not supported");

        byte[] flags = base();
        flags[6] = 1;
        assertReason(flags, "unknown flags 0x10000");

        byte[] size = base();
        TestPatterns.putInt(size, TestPatterns.valueOf(size, "dataWindow", "box2i") - 4, -1);
        assertReason(size, "attribute 'dataWindow' claims 4294967295 bytes");

        byte[] large = base();
        TestPatterns.putInt(large, TestPatterns.valueOf(large, "dataWindow", "box2i") - 4, Integer.MAX_VALUE);
        assertReason(large, "attribute 'dataWindow' claims 2147483647 bytes");

        byte[] missing = base();
        missing[TestPatterns.find(missing, "lineOrder\0")] = 'L';
        assertReason(missing, "the header has no attribute 'lineOrder'");

        byte[] wrongType = base();
        wrongType[TestPatterns.find(wrongType, "box2i\0")] = 'B';
        assertReason(wrongType, "attribute 'dataWindow' of type 'Box2i' is not a valid box2i");

        byte[] order = base();
        order[TestPatterns.valueOf(order, "lineOrder", "lineOrder")] = 2;
        assertReason(order, "line order RANDOM_Y is not valid for a scanline image");

        byte[] compression = base();
        compression[TestPatterns.valueOf(compression, "compression", "compression")] = 77;
        assertReason(compression, "compression with the unknown code 77 is not supported");
    }

    @Test
    void damagedChannelLists() throws IOException {
        int list = TestPatterns.valueOf(base(), "channels", "chlist");
        byte[] subsampled = base();
        TestPatterns.putInt(subsampled, list + 10, 2);
        assertReason(subsampled, "subsampled channels are not supported (channel 'B' is sampled every 2 x 1 pixels)");

        byte[] type = base();
        TestPatterns.putInt(type, list + 2, 3);
        assertReason(type, "channel 'B' has the unknown pixel type 3");

        byte[] twice = base();
        twice[list + 18] = 'B';
        assertReason(twice, "channel 'B' appears twice");

        byte[] early = base();
        early[list] = 0;
        assertReason(early, "the channel list does not end where it should");

        byte[] name = base();
        name[list] = (byte) 0xff;
        assertReason(name, "a channel name is not UTF-8");
    }

    @Test
    void anOffsetTableOfZerosIsRecovered() throws IOException {
        for (String name : new String[] {BASE, "decreasing.exr"}) {
            byte[] bytes = TestPatterns.fixture(name);
            int table = offsetTable(bytes, 3);
            Arrays.fill(bytes, table, table + 24, (byte) 0);
            TestPatterns.assertPattern("smooth", ExrReader.read(TestPatterns.put(directory, "zeros.exr", bytes)));
        }
    }

    @Test
    void anUnfinishedFileNamesTheFirstMissingRow() throws IOException {
        byte[] bytes = base();
        int table = offsetTable(bytes, 3);
        int third = twoBytes(bytes, table + 16);
        Arrays.fill(bytes, table, table + 24, (byte) 0);
        assertReason(Arrays.copyOf(bytes, third + 20), "the file is incomplete: the chunk of row 32 is missing");
    }

    @Test
    void wrongOffsets() throws IOException {
        byte[] beyond = base();
        TestPatterns.putInt(beyond, offsetTable(beyond, 3), beyond.length);
        assertReason(beyond, "the chunk of row 0 should start at byte " + beyond.length);

        byte[] negative = base();
        TestPatterns.putInt(negative, offsetTable(negative, 3) + 12, -1);
        assertReason(negative, "the chunk of row 16 should start at byte");

        byte[] inside = base();
        int table = offsetTable(inside, 3);
        TestPatterns.putInt(inside, table, 4);
        assertReason(inside, "the chunk of row 0 should start at byte 4");

        byte[] swapped = base();
        System.arraycopy(base(), table, swapped, table + 8, 8);
        assertReason(swapped, "the chunk of row 16 says that it is the chunk of row 0");
    }

    @Test
    void damagedChunks() throws IOException {
        int chunk = offsetTable(base(), 3) + 24;

        byte[] size = base();
        TestPatterns.putInt(size, chunk + 4, Integer.MIN_VALUE);
        assertReason(size, "the chunk of row 0 claims 2147483648 bytes instead of at most 1632");

        byte[] data = base();
        data[chunk + 8] ^= 0x55;
        assertReason(data, "the file is damaged in the chunk of row 0");

        byte[] checksum = base();
        int packed = twoBytes(checksum, chunk + 4);
        checksum[chunk + 8 + packed - 1] ^= 1;
        assertReason(checksum, "the file is damaged in the chunk of row 0");

        byte[] small = TestPatterns.fixture("none_half_smooth.exr");
        TestPatterns.putInt(small, offsetTable(small, 35) + 35 * 8 + 4, 101);
        assertReason(small, "a chunk holds 101 bytes instead of 102");
    }

    private static byte[] tiled() {
        return TestPatterns.fixture("tiled_none_mip_down.exr");
    }

    @Test
    void damagedTileDescriptions() throws IOException {
        int place = TestPatterns.valueOf(tiled(), "tiles", "tiledesc");
        byte[] size = tiled();
        TestPatterns.putInt(size, place, 0);
        assertReason(size, "tiles of 0 x 5 pixels with level mode 1 are not valid");

        byte[] mode = tiled();
        mode[place + 8] = 3;
        assertReason(mode, "with level mode 3 are not valid");

        byte[] rounding = tiled();
        rounding[place + 8] = 0x21;
        assertReason(rounding, "with level mode 33 are not valid");

        byte[] missing = tiled();
        missing[place - 20] = 'T';
        assertReason(missing, "the header has no attribute 'tiles'");

        byte[] tiny = tiled();
        TestPatterns.putInt(tiny, place, 1);
        TestPatterns.putInt(tiny, place + 4, 1);
        assertReason(tiny, "cannot hold its chunks");

        byte[] flag = tiled();
        flag[5] &= ~2;
        assertReason(flag, "attribute 'type' contradicts the version field");
    }

    @Test
    void damagedParts() throws IOException {
        byte[] parts = TestPatterns.fixture("parts_none.exr");
        byte[] twice = parts.clone();
        System.arraycopy("left\0".getBytes(StandardCharsets.US_ASCII), 0, twice, TestPatterns.find(twice, "right"), 5);
        TestPatterns.putInt(twice, TestPatterns.find(twice, "left\0\0") - 4, 4);
        ImageFileException e = assertThrows(ImageFileException.class, () -> ExrReader.readParts("twice", twice, 1));
        assertTrue(e.reason().contains("damaged"), e.reason());

        byte[] count = parts.clone();
        TestPatterns.putInt(count, TestPatterns.valueOf(count, "chunkCount", "int"), 20);
        assertReason(count, "part 0 claims 20 chunks instead of 21");

        byte[] both = parts.clone();
        both[5] |= 2;
        assertReason(both, "the flags for tiles and for several parts exclude each other");
    }
}
