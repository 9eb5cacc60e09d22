package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

class PfmTest {
    @TempDir
    Path directory;

    private static byte[] file(String head, ByteOrder order, float... samples) {
        ByteBuffer body = ByteBuffer.allocate(4 * samples.length).order(order);
        for (float sample : samples) {
            body.putFloat(sample);
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(head.getBytes(StandardCharsets.US_ASCII));
        out.writeBytes(body.array());
        return out.toByteArray();
    }

    private PfmImage read(byte[] bytes) throws IOException {
        return Pfm.read(TestPatterns.put(directory, "image.pfm", bytes));
    }

    private void assertReason(byte[] bytes, String reason) {
        ImageFileException e = assertThrows(ImageFileException.class, () -> read(bytes));
        assertTrue(e.reason().contains(reason), e.reason());
    }

    @Test
    void rowsRunFromTheBottomInTheFile() throws IOException {
        PfmImage image = read(file("Pf\n2 3\n-1.0\n", ByteOrder.LITTLE_ENDIAN, 5, 6, 3, 4, 1, 2));
        assertEquals(2, image.width());
        assertEquals(3, image.height());
        assertEquals(1, image.components());
        assertEquals(1f, image.scale());
        assertArrayEquals(new float[] {1, 2, 3, 4, 5, 6}, image.samples());
    }

    @Test
    void aPositiveScaleMeansBigEndian() throws IOException {
        PfmImage image = read(file("PF 1\t2\r\n2.5 ", ByteOrder.BIG_ENDIAN, 4, 5, 6, 1, 2, 3));
        assertEquals(3, image.components());
        assertEquals(2.5f, image.scale());
        assertArrayEquals(new float[] {1, 2, 3, 4, 5, 6}, image.samples());
    }

    @Test
    void theFileIsWrittenToTheByte() throws IOException {
        Path target = directory.resolve("out.pfm");
        Pfm.write(target, new PfmImage(1, 2, 3, new float[] {1, 2, 3, 4, 5, 6}));
        assertArrayEquals(
                file("PF\n1 2\n-1.0\n", ByteOrder.LITTLE_ENDIAN, 4, 5, 6, 1, 2, 3), Files.readAllBytes(target));
    }

    @Test
    void everyBitComesBackInBothByteOrders() throws IOException {
        for (int components : new int[] {1, 3}) {
            float[] samples = new float[7 * 5 * components];
            for (int i = 0; i < samples.length; i++) {
                samples[i] = Float.intBitsToFloat(TestPatterns.bits("noise", PixelType.FLOAT, i, 0, 0));
            }
            for (ByteOrder order : List.of(ByteOrder.BIG_ENDIAN, ByteOrder.LITTLE_ENDIAN)) {
                Path target = directory.resolve("noise.pfm");
                Pfm.write(target, new PfmImage(7, 5, components, samples, 0.5f), order);
                PfmImage image = Pfm.read(target);
                assertEquals(0.5f, image.scale());
                for (int i = 0; i < samples.length; i++) {
                    assertEquals(Float.floatToRawIntBits(samples[i]), Float.floatToRawIntBits(image.samples()[i]));
                }
            }
        }
    }

    @Test
    void damagedFilesAreRefused() {
        assertReason(new byte[0], "the file is empty");
        assertReason("P6\n1 1\n255\n".getBytes(StandardCharsets.US_ASCII), "is not a PFM file");
        assertReason("PF\n1 ".getBytes(StandardCharsets.US_ASCII), "truncated");
        assertReason(file("Pf\n2 2\n-1\n", ByteOrder.LITTLE_ENDIAN, 1, 2, 3), "truncated or damaged");
        assertReason(file("Pf\n1 2\n-1\n", ByteOrder.LITTLE_ENDIAN, 1, 2, 3), "truncated or damaged");
        assertReason(file("Pf\n2147483647 2147483647\n-1\n", ByteOrder.LITTLE_ENDIAN, 1), "truncated or damaged");
        assertReason(file("Pf\n0 1\n-1\n", ByteOrder.LITTLE_ENDIAN, 1), "'0' is not a width");
        assertReason(file("Pf\n1 -1\n-1\n", ByteOrder.LITTLE_ENDIAN, 1), "'-1' is not a height");
        assertReason(file("Pf\n1 99999999999\n-1\n", ByteOrder.LITTLE_ENDIAN, 1), "is not a height");
        assertReason(file("Pf\n1 1\n0\n", ByteOrder.LITTLE_ENDIAN, 1), "'0' is not a scale");
        assertReason(file("Pf\n1 1\nNaN\n", ByteOrder.LITTLE_ENDIAN, 1), "'NaN' is not a scale");
        assertReason(file("Pf\n1 1\nx\n", ByteOrder.LITTLE_ENDIAN, 1), "'x' is not a scale");
    }

    @Test
    void wrongSizesAreRefused() {
        assertThrows(IllegalArgumentException.class, () -> new PfmImage(0, 1, 1, new float[0]));
        assertThrows(IllegalArgumentException.class, () -> new PfmImage(1, 1, 2, new float[2]));
        assertThrows(IllegalArgumentException.class, () -> new PfmImage(2, 2, 3, new float[4]));
        assertThrows(IllegalArgumentException.class, () -> new PfmImage(1, 1, 1, new float[1], 0));
    }

    /** Seeded flips and cuts: read or refused by the declared exception, nothing else. */
    @Test
    @Timeout(60)
    void mutatedFilesAreReadOrRefused() throws IOException {
        SplittableRandom random = new SplittableRandom(7);
        byte[] original = file("PF\n2 3\n-1.0\n", ByteOrder.LITTLE_ENDIAN, new float[18]);
        int refused = 0;
        for (int i = 0; i < 2000; i++) {
            byte[] bytes = original.clone();
            bytes[random.nextInt(24)] = (byte) (random.nextBoolean() ? '0' + random.nextInt(10) : random.nextInt());
            if (random.nextInt(8) == 0) {
                bytes = Arrays.copyOf(bytes, random.nextInt(bytes.length));
            }
            try {
                read(bytes);
            } catch (ImageFileException e) {
                refused++;
            }
        }
        assertTrue(refused > 500 && refused < 1900, refused + " refused");
    }
}
