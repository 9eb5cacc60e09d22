package org.daybreak.cli;

import java.nio.file.Path;
import org.daybreak.exr.ImageFileException;
import org.daybreak.exr.PngWriter;

/** Shows numbers from 0 to 1 as colours from black over purple and orange to pale yellow. */
final class FalseColor {
    /** The map "magma" of Smith and van der Walt (2015, CC0) at equal steps, sRGB. */
    private static final int[] COLORS = {
        0x000004, 0x0A0822, 0x1D1147, 0x36106B, 0x51127C, 0x6A1C81, 0x832681, 0x9C2E7F, 0xB73779, 0xD0416F, 0xE75263,
        0xF56B5C, 0xFC8961, 0xFEA772, 0xFEC488, 0xFDE2A3, 0xFCFDBF
    };

    private FalseColor() {}

    /**
     * Writes a PNG file.
     *
     * @param values row by row; clamped to [0, 1]
     * @throws ImageFileException if that fails
     */
    static void write(Path file, int width, int height, float[] values) throws ImageFileException {
        float[] rgb = new float[3 * values.length];
        for (int p = 0; p < values.length; p++) {
            double position = Math.max(0, Math.min(1, values[p])) * (COLORS.length - 1);
            int i = Math.min((int) position, COLORS.length - 2);
            double f = position - i;
            for (int c = 0; c < 3; c++) {
                int shift = 16 - 8 * c;
                double encoded = (1 - f) * (COLORS[i] >> shift & 0xFF) + f * (COLORS[i + 1] >> shift & 0xFF);
                rgb[3 * p + c] = (float) linear(encoded / 255);
            }
        }
        PngWriter.write(file, width, height, rgb);
    }

    /** The inverse of the sRGB curve, which the PNG writer applies. */
    private static double linear(double encoded) {
        return encoded <= 0.04045 ? encoded / 12.92 : Math.pow((encoded + 0.055) / 1.055, 2.4);
    }
}
