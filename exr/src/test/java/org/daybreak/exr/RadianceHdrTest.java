package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class RadianceHdrTest {
    private static final String RGBE = "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n";

    @TempDir
    Path directory;

    private static byte[] file(String head, int... bytes) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.writeBytes(head.getBytes(StandardCharsets.ISO_8859_1));
        for (int value : bytes) {
            out.write(value);
        }
        return out.toByteArray();
    }

    private static HdrImage read(String head, int... bytes) throws IOException {
        return RadianceHdr.read("test.hdr", file(head, bytes));
    }

    private static void assertReason(String reason, String head, int... bytes) {
        ImageFileException e = assertThrows(ImageFileException.class, () -> read(head, bytes));
        assertTrue(e.reason().contains(reason), e.reason());
        assertEquals("test.hdr: " + e.reason(), e.getMessage());
    }

    @Test
    void aPixelIsMantissaTimesPowerOfTwo() throws IOException {
        HdrImage image = read(RGBE + "-Y 1 +X 4\n", 128, 64, 1, 129, 9, 9, 9, 0, 255, 0, 128, 255, 1, 2, 3, 1);
        float[] expected = {
            1, 0.5f, 1 / 128f, 0, 0, 0, 255 * 0x1p119f, 0, 128 * 0x1p119f, 0x1p-135f, 0x1p-134f, 3 * 0x1p-135f
        };
        assertArrayEquals(expected, image.samples());
        assertEquals(HdrImage.ColorSpace.RGB, image.colorSpace());
        assertEquals(1, image.exposure());
    }

    @Test
    void exposureAndCorrectionAreReportedNotApplied() throws IOException {
        HdrImage image = read(
                "#?RADIANCE\nEXPOSURE=2\n# comment\nEXPOSURE= 0.25\nCOLORCORR= 1 2 3\nVIEW= -vtv\n"
                        + "COLORCORR=2 1 1\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 1\n",
                128,
                128,
                128,
                129);
        assertArrayEquals(new float[] {1, 1, 1}, image.samples());
        assertEquals(0.5, image.exposure());
        assertEquals(List.of(2.0, 2.0, 3.0), image.colorCorrection());
        assertEquals(List.of("# comment", "VIEW= -vtv"), image.header());
        assertEquals(HdrImage.ColorSpace.XYZ, image.colorSpace());
        HdrImage again = RadianceHdr.read("again", RadianceHdr.toBytes("again", image));
        assertEquals(image.exposure(), again.exposure());
        assertEquals(image.colorCorrection(), again.colorCorrection());
        assertEquals(image.header(), again.header());
        assertEquals(image.colorSpace(), again.colorSpace());
    }

    /** Pixels a to f, that is 128 to 133 in red, in the order of the scan lines; expected from the top left. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "-Y 2 +X 3=abcdef", "-Y 2 -X 3=cbafed", "+Y 2 +X 3=defabc", "+Y 2 -X 3=fedcba",
                "+X 3 -Y 2=acebdf", "-X 3 -Y 2=ecafdb", "+X 3 +Y 2=bdface", "-X 3 +Y 2=fdbeca"
            })
    void allOrdersOfPixels(String orderAndResult) throws IOException {
        String[] parts = orderAndResult.split("=", -1);
        int[] bytes = new int[24];
        for (int i = 0; i < 6; i++) {
            bytes[4 * i] = 128 + i;
            bytes[4 * i + 3] = 136;
        }
        HdrImage image = read(RGBE + parts[0] + "\n", bytes);
        assertEquals(3, image.width());
        assertEquals(2, image.height());
        StringBuilder found = new StringBuilder();
        for (int i = 0; i < 6; i++) {
            found.append((char) ('a' + image.samples()[3 * i] - 128));
        }
        assertEquals(parts[1], found.toString());
    }

    @Test
    void oldRunsRepeatThePixelBefore() throws IOException {
        int[] bytes = {128, 0, 0, 136, 1, 1, 1, 2, 0, 129, 0, 136, 1, 1, 1, 3, 1, 1, 1, 1};
        float[] samples = read(RGBE + "-Y 1 +X 263\n", bytes).samples();
        for (int i = 0; i < 263; i++) {
            assertEquals(i < 3 ? 128 : 0, samples[3 * i]);
            assertEquals(i < 3 ? 0 : 129, samples[3 * i + 1]);
        }
    }

    @Test
    void newRunsAreOfComponents() throws IOException {
        int[] bytes = {
            2, 2, 0, 9, 128 + 9, 7, 4, 1, 2, 3, 4, 128 + 5, 5, 9, 0, 1, 2, 3, 4, 5, 6, 7, 8, 128 + 4, 136, 128 + 5, 137
        };
        float[] samples = read(RGBE + "-Y 1 +X 9\n", bytes).samples();
        float[] green = {1, 2, 3, 4, 5, 5, 5, 5, 5};
        for (int i = 0; i < 9; i++) {
            int unit = i < 4 ? 1 : 2;
            assertArrayEquals(
                    new float[] {7 * unit, green[i] * unit, i * unit}, Arrays.copyOfRange(samples, 3 * i, 3 * i + 3));
        }
    }

    @Test
    void lineEndsOfOtherSystemsAndMissingFormat() throws IOException {
        assertEquals(
                1,
                read("#?RGBE\r\nGAMMA=1\r\n\r\n-Y 1 +X 1\r\n", 128, 0, 0, 129).samples()[0]);
    }

    @Test
    void whatWasReadIsWrittenBackExactly() throws IOException {
        SplittableRandom random = new SplittableRandom(5);
        // Both lengths without runs, and those with; all exponents.
        for (int width : new int[] {1, 7, 8, 300, 0x7fff, 0x8000}) {
            int height = width > 1000 ? 2 : 11;
            float[] samples = new float[3 * width * height];
            for (int i = 0; i < samples.length; i += 3) {
                boolean repeat = i > 0 && random.nextInt(3) > 0;
                int exponent = random.nextInt(1, 256);
                for (int c = 0; c < 3; c++) {
                    int mantissa = c == i % 3 ? random.nextInt(128, 256) : random.nextInt(256);
                    samples[i + c] = repeat ? samples[i + c - 3] : Math.scalb((float) mantissa, exponent - 136);
                }
            }
            Path file = directory.resolve("image.hdr");
            RadianceHdr.write(file, new HdrImage(width, height, samples));
            HdrImage read = RadianceHdr.read(file);
            assertEquals(width, read.width());
            assertEquals(height, read.height());
            assertArrayEquals(samples, read.samples());
        }
    }

    @Test
    void otherValuesAreRoundedToTheNearest() throws IOException {
        float[][] pairs = {
            {1 + 0x1p-8f, 1},
            {1 + 0x1.8p-7f, 1 + 0x1p-6f},
            {2 - 0x1p-24f, 2},
            {-1, 0},
            {Float.NaN, 0},
            {Float.POSITIVE_INFINITY, 255 * 0x1p119f},
            {Float.MAX_VALUE, 255 * 0x1p119f},
            {Float.MIN_VALUE, 0},
            {0x1p-136f, 0},
            {0x1.8p-135f, 0x1p-134f},
            {-0f, 0},
        };
        for (float[] pair : pairs) {
            HdrImage image = new HdrImage(1, 1, new float[] {pair[0], 0, 0});
            float found = RadianceHdr.read("x", RadianceHdr.toBytes("x", image)).samples()[0];
            assertEquals(Float.floatToRawIntBits(pair[1]), Float.floatToRawIntBits(found), "of " + pair[0]);
        }
    }

    @Test
    void flatPixelsThatLookLikeRuns() throws IOException {
        float tiny = 0x1p-135f;
        HdrImage image = new HdrImage(2, 1, new float[] {1, 1, 1, tiny, tiny, tiny});
        assertArrayEquals(
                new float[] {1, 1, 1, 0, 0, 0},
                RadianceHdr.read("x", RadianceHdr.toBytes("x", image)).samples());
    }

    @Test
    void damage() {
        assertReason("the file is empty", "");
        assertReason("is not a Radiance HDR file", "P6\n");
        assertReason("ends within the header", "#?RADIANCE\nEXPOSURE=1\n");
        assertReason("'EXPOSURE=no' does not give 1 factors", "#?RADIANCE\nEXPOSURE=no\n\n");
        assertReason("'EXPOSURE=-1' does not give 1 factors", "#?RADIANCE\nEXPOSURE=-1\n\n");
        assertReason("'COLORCORR=1 2' does not give 3 factors", "#?RADIANCE\nCOLORCORR=1 2\n\n");
        assertReason("the format '16-bit' is not supported", "#?RADIANCE\nFORMAT=16-bit\n\n");
        assertReason("'-Y 3 +Y 3' is not a resolution", RGBE + "-Y 3 +Y 3\n");
        assertReason("'Y 3 X 3' is not a resolution", RGBE + "Y 3 X 3\n");
        assertReason("has 0 x 3 pixels", RGBE + "-Y 3 +X 0\n");
        assertReason("too large", RGBE + "-Y 100000 +X 100000\n");
        assertReason("too large", RGBE + "-Y 1 +X 9999999999\n");
        assertReason("ends within a scan line", RGBE + "-Y 20000 +X 20000\n", 2, 2, 78, 32, 128 + 127);
        assertReason("a scan line has 9 pixels instead of 8", RGBE + "-Y 1 +X 8\n", 2, 2, 0, 9);
        assertReason("does not fit its scan line", RGBE + "-Y 1 +X 8\n", 2, 2, 0, 8, 128 + 9);
        assertReason("does not fit its scan line", RGBE + "-Y 1 +X 8\n", 2, 2, 0, 8, 0);
        assertReason("does not fit its scan line", RGBE + "-Y 1 +X 3\n", 1, 1, 1, 2);
        assertReason("does not fit its scan line", RGBE + "-Y 1 +X 3\n", 9, 9, 9, 9, 1, 1, 1, 3);
        int[] zeros = new int[40];
        for (int i = 0; i < 40; i++) {
            zeros[i] = i % 4 < 3 || i == 3 ? 1 : 0;
        }
        zeros[0] = 9;
        assertReason("does not fit its scan line", RGBE + "-Y 1 +X 3\n", zeros);
    }

    @Test
    void wrongUseIsRefused() {
        assertTrue(message(() -> new HdrImage(0, 1, new float[0])).contains("at least one pixel"));
        assertTrue(message(() -> new HdrImage(2, 1, new float[3])).contains("3 samples for 2 x 1 x 3"));
        for (String line : List.of("", "a\nb", "EXPOSURE=1", "COLORCORR=1 1 1", "FORMAT=x", "#?x", "\u0100")) {
            assertTrue(message(() -> withHeader(line)).contains("not valid as a further header line"), line);
        }
        assertTrue(message(() ->
                        new HdrImage(1, 1, new float[3], HdrImage.ColorSpace.RGB, 0, List.of(1.0, 1.0, 1.0), List.of()))
                .contains("exposure"));
    }

    private static HdrImage withHeader(String line) {
        return new HdrImage(1, 1, new float[3], HdrImage.ColorSpace.RGB, 1, List.of(1.0, 1.0, 1.0), List.of(line));
    }

    private static String message(Executable action) {
        return String.valueOf(
                assertThrows(IllegalArgumentException.class, action).getMessage());
    }
}
