package org.daybreak.core.material;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.core.color.ColorSpaces;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;

class TextureTest {
    private static final double[] IDENTITY = {1, 0, 0, 0, 1, 0};

    private final SurfacePoint point = new SurfacePoint();
    private final Spectrum out = new Spectrum();

    /** 4×3 pixels, grey; pixel (x, y) has the value 0.1 y + 0.01 (x + 1). */
    private static TextureImage ramp() {
        float[] data = new float[12];
        for (int i = 0; i < 12; i++) {
            int y = i / 4;
            data[i] = 0.1f * y + 0.01f * (i % 4 + 1);
        }
        return TextureImage.fromFloats(4, 3, 1, data);
    }

    private double at(Texture texture, double u, double v) {
        point.u = u;
        point.v = v;
        texture.evaluate(point, out);
        assertEquals(texture.evaluateScalar(point), Spectrum.luminance(out.r, out.g, out.b), 1e-7);
        return out.g;
    }

    @Test
    void rowZeroLiesAtVZeroAndPixelCentresAtHalves() {
        for (BitmapTexture.Filter filter : BitmapTexture.Filter.values()) {
            Texture texture = new BitmapTexture(ramp(), filter, BitmapTexture.Wrap.CLAMP, IDENTITY);
            for (int y = 0; y < 3; y++) {
                for (int x = 0; x < 4; x++) {
                    double expected = 0.1 * y + 0.01 * (x + 1);
                    assertEquals(expected, at(texture, (x + 0.5) / 4, (y + 0.5) / 3), 1e-7);
                }
            }
        }
    }

    @Test
    void bilinearIsLinearBetweenCentres() {
        Texture texture = new BitmapTexture(ramp(), BitmapTexture.Filter.BILINEAR, BitmapTexture.Wrap.CLAMP, IDENTITY);
        // A linear image is reproduced: value = 0.1 y + 0.01 (x + 1) at pixel coordinates (x, y).
        for (double u = 0.125; u <= 0.875; u += 0.05) {
            for (double v = 1 / 6.0; v <= 5 / 6.0; v += 0.05) {
                assertEquals(0.1 * (3 * v - 0.5) + 0.01 * (4 * u + 0.5), at(texture, u, v), 1e-7);
            }
        }
    }

    @Test
    void wrapModes() {
        Texture repeat = new BitmapTexture(ramp(), BitmapTexture.Filter.NEAREST, BitmapTexture.Wrap.REPEAT, IDENTITY);
        Texture mirror = new BitmapTexture(ramp(), BitmapTexture.Filter.NEAREST, BitmapTexture.Wrap.MIRROR, IDENTITY);
        Texture clamp = new BitmapTexture(ramp(), BitmapTexture.Filter.NEAREST, BitmapTexture.Wrap.CLAMP, IDENTITY);
        assertEquals(0.04, at(repeat, -0.1, 0.1), 1e-7);
        assertEquals(0.01, at(mirror, -0.1, 0.1), 1e-7);
        assertEquals(0.01, at(clamp, -0.1, 0.1), 1e-7);
        assertEquals(0.02, at(repeat, 1.3, 0.1), 1e-7);
        assertEquals(0.03, at(mirror, 1.3, 0.1), 1e-7);
        assertEquals(0.04, at(clamp, 1.3, 0.1), 1e-7);
        assertEquals(0.22, at(repeat, -6.7, -7.2), 1e-7);
        assertEquals(0.22, at(mirror, -6.3, -7.1), 1e-7, "period -7…-6 is not mirrored in u, -8…-7 in v is");
        assertEquals(0.24, at(clamp, 77, 99), 1e-7);
    }

    @ParameterizedTest
    @EnumSource
    void extremeCoordinatesStayInTheImage(BitmapTexture.Wrap wrap) {
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        double[] extremes = {
            0, -0.0, 1, -1, -1e-20, 1 - 0x1p-53, 2, -2, 1e15, -1e15, 1e300, -1e300, Double.POSITIVE_INFINITY, Double.NaN
        };
        for (int size : new int[] {1, 2, 5}) {
            float[] data = new float[size * size * 3];
            for (int i = 0; i < data.length; i++) {
                data[i] = (float) (0.25 + 0.5 * random.nextDouble());
            }
            TextureImage image = TextureImage.fromFloats(size, size, 3, data);
            for (BitmapTexture.Filter filter : BitmapTexture.Filter.values()) {
                Texture texture = new BitmapTexture(image, filter, wrap, IDENTITY);
                for (double u : extremes) {
                    for (double v : extremes) {
                        double value = at(texture, u, v);
                        assertTrue(value >= 0.25 && value <= 0.75, u + ", " + v + ": " + value);
                    }
                    for (int i = 0; i < 100; i++) {
                        double value = at(texture, u, 20 * random.nextDouble() - 10);
                        assertTrue(value >= 0.25 && value <= texture.maximum(), u + ": " + value);
                    }
                }
            }
        }
    }

    @Test
    void transformIsAppliedToTheCoordinates() {
        double[] m = {0.5, 0.25, 0.1, -0.3, 2, 0.2};
        Texture plain = new BitmapTexture(ramp(), BitmapTexture.Filter.BILINEAR, BitmapTexture.Wrap.REPEAT, IDENTITY);
        Texture moved = new BitmapTexture(ramp(), BitmapTexture.Filter.BILINEAR, BitmapTexture.Wrap.REPEAT, m);
        m[0] = 99;
        double expected = at(plain, 0.5 * 0.7 + 0.25 * 0.4 + 0.1, -0.3 * 0.7 + 2 * 0.4 + 0.2);
        assertEquals(expected, at(moved, 0.7, 0.4), 1e-12);
    }

    @Test
    void bytesAreDecodedAndAlphaIsDropped() {
        byte[] rgba = {0, (byte) 128, (byte) 255, 7, 10, 20, 30, 99};
        TextureImage srgb = TextureImage.fromSrgbBytes(2, 1, 4, rgba);
        TextureImage raw = TextureImage.fromRawBytes(2, 1, 4, rgba);
        assertEquals(3, srgb.channels());
        assertEquals(0, srgb.value(0, 0, 0));
        assertEquals(ColorSpaces.srgbToLinear(128 / 255.0), srgb.value(0, 0, 1), 1e-7);
        assertEquals(1, srgb.value(0, 0, 2));
        assertEquals(30 / 255.0, raw.value(1, 0, 2), 1e-7);
        TextureImage greyAlpha = TextureImage.fromRawBytes(1, 2, 2, new byte[] {51, 0, 102, 1});
        assertEquals(1, greyAlpha.channels());
        assertEquals(0.4, greyAlpha.value(0, 1, 0), 1e-7);
        Texture texture = new BitmapTexture(srgb, BitmapTexture.Filter.NEAREST, BitmapTexture.Wrap.REPEAT, IDENTITY);
        texture.mean(out);
        assertEquals(0.5 * (srgb.value(0, 0, 2) + srgb.value(1, 0, 2)), out.b, 1e-7);
        assertEquals(1, texture.maximum());
        assertFalse(texture.isConstant());
    }

    @Test
    void imagesAreCheckedAndCopied() {
        byte[] data = {1, 2, 3};
        TextureImage image = TextureImage.fromRawBytes(1, 1, 3, data);
        data[0] = 100;
        assertEquals(1 / 255.0, image.value(0, 0, 0), 1e-9);
        assertMessage("2x2", () -> TextureImage.fromRawBytes(2, 2, 3, new byte[11]));
        assertMessage("0x4", () -> TextureImage.fromRawBytes(0, 4, 3, new byte[0]));
        assertMessage("channels", () -> TextureImage.fromRawBytes(1, 1, 5, new byte[5]));
        assertMessage("65536x65536", () -> TextureImage.fromRawBytes(65536, 65536, 1, new byte[0]));
        assertMessage("pixel (1, 0)", () -> TextureImage.fromFloats(2, 1, 1, new float[] {0, Float.NaN}));
        assertMessage("pixel (0, 1)", () -> TextureImage.fromFloats(1, 2, 1, new float[] {0, -1}));
    }

    @Test
    void checkerboardParityHoldsForNegativeCoordinates() {
        Texture board = new CheckerboardTexture(ConstantTexture.grey(0.1), ConstantTexture.grey(0.9), IDENTITY);
        for (int i = -6; i < 6; i++) {
            for (int j = -6; j < 6; j++) {
                double expected = Math.floorMod(i + j, 2) == 0 ? 0.1 : 0.9;
                assertEquals(expected, at(board, 0.5 * i + 0.2, 0.5 * j + 0.3), 1e-12, i + ", " + j);
            }
        }
        board.mean(out);
        assertEquals(0.5, out.g, 1e-15);
        assertEquals(0.9, board.maximum());
        assertTrue(Double.isFinite(at(board, Double.NaN, Double.NEGATIVE_INFINITY)));
    }

    @Test
    void checkerboardOfTexturesAndTransform() {
        Texture inner = new CheckerboardTexture(
                ConstantTexture.grey(0.2), ConstantTexture.grey(0.4), new double[] {0.5, 0, 0, 0, 0.5, 0});
        Texture board = new CheckerboardTexture(inner, ConstantTexture.grey(0.8), new double[] {2, 0, 0, 0, 2, 0});
        assertEquals(0.2, at(board, 0.1, 0.1), 1e-12);
        assertEquals(0.8, at(board, 0.3, 0.1), 1e-12);
        assertEquals(0.4, at(board, 1.1, 0.1), 1e-12, "the inner texture sees the coordinates of the surface");
    }

    @Test
    void constantsAreExact() {
        assertEquals(0.3, ConstantTexture.grey(0.3).evaluateScalar(point));
        assertEquals(1, ConstantTexture.grey(1).evaluateScalar(point));
        assertTrue(ConstantTexture.grey(1).isConstant());
        assertEquals(0.9, new ConstantTexture(0.1, 0.9, 0.2).maximum());
        assertEquals(
                Spectrum.luminance(0.1, 0.9, 0.2), new ConstantTexture(0.1, 0.9, 0.2).evaluateScalar(point), 1e-15);
    }

    @ParameterizedTest
    @ValueSource(doubles = {-0.1, Double.NaN, Double.POSITIVE_INFINITY})
    void constantsAreChecked(double value) {
        assertMessage("finite and not negative", () -> ConstantTexture.grey(value));
    }

    @Test
    void transformsAreChecked() {
        Texture grey = ConstantTexture.grey(0.5);
        assertMessage("6 numbers", () -> new CheckerboardTexture(grey, grey, new double[9]));
        assertMessage("finite", () -> new CheckerboardTexture(grey, grey, new double[] {1, 0, Double.NaN, 0, 1, 0}));
    }

    private static void assertMessage(String part, Runnable action) {
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class, action::run);
        assertTrue(e.getMessage().contains(part), e.getMessage());
    }
}
