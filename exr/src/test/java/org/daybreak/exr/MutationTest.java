package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Flips bytes of small files, cuts them and splices them, by seeded choice. Each file must be read or refused by the
 * declared exception: no other exception, no error of the virtual machine, no endless loop.
 */
class MutationTest {
    @FunctionalInterface
    private interface Reader {
        void read(byte[] bytes) throws IOException;
    }

    private static final Reader EXR = bytes -> ExrReader.readParts("mutated", bytes, 1);
    private static final Reader HDR = bytes -> RadianceHdr.read("mutated", bytes);
    private static final Reader PFM = bytes -> Pfm.read("mutated", bytes);

    private static List<byte[]> exrFiles() {
        List<String> names = new ArrayList<>(TestPatterns.scanlineFixtures());
        names.addAll(TestPatterns.tiledFixtures());
        TestPatterns.COMPRESSIONS.forEach(compression -> names.add("parts_" + compression + ".exr"));
        return names.stream().map(TestPatterns::fixture).toList();
    }

    private static List<byte[]> hdrFiles() throws IOException {
        List<byte[]> files = new ArrayList<>();
        for (int width : new int[] {5, 40}) {
            float[] samples = TestPatterns.floats("smooth", PixelType.FLOAT, 3 * width, 7, 0);
            files.add(RadianceHdr.toBytes("x", new HdrImage(width, 7, samples)));
        }
        byte[] old =
                "#?RGBE\nEXPOSURE=2\nCOLORCORR=1 2 3\nFORMAT=32-bit_rle_rgbe\n\n+X 2 -Y 300\n...........\1\1\1\53\1\1\1\1"
                        .getBytes(StandardCharsets.ISO_8859_1);
        files.add(old);
        return files;
    }

    private static List<byte[]> pfmFiles() throws IOException {
        float[] samples = TestPatterns.floats("smooth", PixelType.FLOAT, 15, 4, 0);
        return List.of(
                Pfm.toBytes("x", new PfmImage(5, 4, 3, samples)), Pfm.toBytes("x", new PfmImage(15, 4, 1, samples)));
    }

    @Test
    @Timeout(50)
    void mutatedFilesAreReadOrRefused() throws IOException {
        run(20001, 20_000, exrFiles(), EXR);
        run(20002, 10_000, hdrFiles(), HDR);
        run(20003, 10_000, pfmFiles(), PFM);
    }

    @Test
    @Tag("reference")
    @Timeout(1800)
    void aMillionMutatedFilesAreReadOrRefused() throws IOException {
        run(30001, 1_000_000, exrFiles(), EXR);
        run(30002, 500_000, hdrFiles(), HDR);
        run(30003, 500_000, pfmFiles(), PFM);
    }

    private static void run(long seed, int count, List<byte[]> files, Reader reader) {
        SplittableRandom random = new SplittableRandom(seed);
        int refused = 0;
        for (int i = 0; i < count; i++) {
            byte[] bytes = mutate(files.get(random.nextInt(files.size())).clone(), files, random);
            try {
                reader.read(bytes);
            } catch (ImageFileException e) {
                refused++;
                assertTrue(e.getMessage().startsWith("mutated: "), e.getMessage());
            } catch (IOException | RuntimeException e) {
                throw new AssertionError("file " + i + " of seed " + seed, e);
            }
        }
        // Both outcomes must occur in numbers, or the mutations test nothing.
        assertTrue(refused > count / 10 && refused < count * 19 / 20, refused + " of " + count + " refused");
    }

    private static byte[] mutate(byte[] bytes, List<byte[]> files, SplittableRandom random) {
        // Mostly the header and table, where a flip changes sizes and counts.
        int range = random.nextInt(3) == 0 ? bytes.length : Math.min(bytes.length, 700);
        int flips = random.nextInt(4);
        for (int flip = 0; flip < flips; flip++) {
            int place = random.nextInt(range);
            bytes[place] = switch (random.nextInt(6)) {
                case 0 -> (byte) 0;
                case 1 -> (byte) 0xff;
                case 2 -> (byte) 0x7f;
                case 3 -> (byte) (bytes[place] + 1 - 2 * random.nextInt(2));
                case 4 -> (byte) (bytes[place] ^ 1 << random.nextInt(8));
                default -> (byte) random.nextInt();
            };
        }
        switch (random.nextInt(12)) {
            case 0 -> {
                return Arrays.copyOf(bytes, random.nextInt(bytes.length));
            }
            case 1 -> {
                byte[] other = files.get(random.nextInt(files.size()));
                int from = random.nextInt(Math.min(bytes.length, other.length));
                System.arraycopy(other, from, bytes, from, Math.min(bytes.length, other.length) - from);
            }
            case 2 -> {
                int count = random.nextInt(Math.min(bytes.length, 64));
                System.arraycopy(
                        bytes,
                        random.nextInt(bytes.length - count),
                        bytes,
                        random.nextInt(bytes.length - count),
                        count);
            }
            default -> {
                // Flips alone.
            }
        }
        return bytes;
    }
}
