package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PngWriterTest {
    @TempDir
    Path directory;

    @Test
    void every8BitValueIsHitByItsOwnLightAndNoOther() throws IOException {
        float[] rgb = new float[256 * 3 * 3];
        for (int i = 0; i < 256; i++) {
            // The light that is displayed as i, and the ends of the interval that rounds to it.
            double[] encoded = {i / 255.0, (i - 0.499) / 255, (i + 0.499) / 255};
            for (int row = 0; row < 3; row++) {
                for (int c = 0; c < 3; c++) {
                    rgb[(row * 256 + i) * 3 + c] = (float) SrgbTransfer.decode(encoded[row]);
                }
            }
        }
        Path file = directory.resolve("ramp.png");
        PngWriter.write(file, 256, 3, rgb);
        BufferedImage image = ImageIO.read(file.toFile());
        for (int row = 0; row < 3; row++) {
            for (int i = 0; i < 256; i++) {
                assertEquals(i * 0x010101, image.getRGB(i, row) & 0xffffff, "row " + row + " value " + i);
            }
        }
    }

    @Test
    void componentsAndRowsKeepTheirPlaces() throws IOException {
        Path file = directory.resolve("places.png");
        PngWriter.write(file, 1, 2, new float[] {1, 0, 0, 0, 1, 0.5f});
        BufferedImage image = ImageIO.read(file.toFile());
        assertEquals(0xff0000, image.getRGB(0, 0) & 0xffffff);
        // 255 (1.055 * 0.5^(1/2.4) - 0.055) = 187.5160
        assertEquals(0x00ffbc, image.getRGB(0, 1) & 0xffffff);
    }

    @Test
    void valuesBeyondTheRangeAreClamped() throws IOException {
        Path file = directory.resolve("clamped.png");
        PngWriter.write(
                file, 2, 1, new float[] {Float.NaN, -1, Float.NEGATIVE_INFINITY, Float.POSITIVE_INFINITY, 1e30f, 1.001f
                });
        BufferedImage image = ImageIO.read(file.toFile());
        assertEquals(0x000000, image.getRGB(0, 0) & 0xffffff);
        assertEquals(0xffffff, image.getRGB(1, 0) & 0xffffff);
    }

    @Test
    void exposureScalesLightBeforeTheCurve() throws IOException {
        Path file = directory.resolve("exposed.png");
        PngWriter.write(file, 1, 1, new float[] {0.25f, 0.5f, 0.0001f}, 2);
        // 255 * 12.92 * 0.0002 = 0.66
        assertEquals(0xbcff01, ImageIO.read(file.toFile()).getRGB(0, 0) & 0xffffff);
    }

    @Test
    void theFileSaysThatItIsSrgb() throws IOException {
        Path file = directory.resolve("tagged.png");
        PngWriter.write(file, 1, 1, new float[3]);
        assertTrue(new String(Files.readAllBytes(file), StandardCharsets.ISO_8859_1).contains("sRGB"));
    }

    @Test
    void theCurveMeetsItsDefinition() {
        assertEquals(0.0, SrgbTransfer.encode(-0.0));
        assertEquals(12.92 * 0.002, SrgbTransfer.encode(0.002));
        // IEC 61966-2-1: the middle grey of 18 % is 0.4613561.
        assertEquals(0.4613561, SrgbTransfer.encode(0.18), 1e-7);
        for (int i = 0; i <= 1000; i++) {
            double encoded = i / 1000.0;
            // The two branches of the standard do not meet exactly; they differ by less than 1e-7 at the joint.
            assertEquals(encoded, SrgbTransfer.encode(SrgbTransfer.decode(encoded)), 1e-7);
        }
    }

    @Test
    void wrongUseIsRefused() {
        Path file = directory.resolve("never.png");
        assertThrows(IllegalArgumentException.class, () -> PngWriter.write(file, 0, 1, new float[0]));
        assertThrows(IllegalArgumentException.class, () -> PngWriter.write(file, 2, 1, new float[3]));
        assertThrows(IllegalArgumentException.class, () -> PngWriter.write(file, 1, 1, new float[3], 0));
        assertThrows(IllegalArgumentException.class, () -> PngWriter.write(file, 1, 1, new float[3], Double.NaN));
        assertTrue(Files.notExists(file));
    }
}
