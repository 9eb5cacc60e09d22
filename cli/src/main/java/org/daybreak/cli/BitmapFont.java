package org.daybreak.cli;

import java.util.Locale;

/**
 * Draws small texts into images, with letters of 5 by 7 dots. It needs no fonts of the system, which servers often lack, so
 * that the same text has the same pixels everywhere. Capitals become small letters; characters it does not know become spaces.
 */
final class BitmapFont {
    private static final int ROWS = 7;
    private static final int COLUMNS = 5;
    /** Dots from one letter to the next. */
    private static final int ADVANCE = COLUMNS + 1;

    private static final String CHARACTERS = " ()+,-.0123456789:=abcdefghijklmnopqrstuvwxyz";

    /** Seven rows of each character, from the top; the highest of five bits is the leftmost dot. */
    private static final String GLYPHS = "00000000000000 02040808080402 08040202020408 0004041f040400 "
            + "000000000c0408 0000001f000000 00000000000c0c 0e11131519110e "
            + "040c040404040e 0e11010204081f 0e11010601110e 02060a121f0202 "
            + "1f101e0101110e 0608101e11110e 1f010204080808 0e11110e11110e "
            + "0e11110f01020c 000c0c000c0c00 00001f001f0000 00000e010f110f "
            + "10101e1111111e 00000f1010100f 01010f1111110f 00000e111f100e "
            + "0609081e080808 00000f110f010e 10101619111111 04000c0404040e "
            + "0200060202120c 10101214181412 0c04040404040e 00001a15151111 "
            + "00001619111111 00000e1111110e 00001e111e1010 00000f110f0101 "
            + "00001619101010 00000f100e011e 08081e08080906 0000111111130d "
            + "00001111110a04 0000111115150a 0000110a040a11 000011110f010e "
            + "00001f0204081f";

    private static final int GLYPH_LENGTH = 2 * ROWS + 1;

    private BitmapFont() {}

    /** Width of a text in pixels, without a gap behind it. */
    static int width(String text, int dot) {
        return text.isEmpty() ? 0 : (text.length() * ADVANCE - 1) * dot;
    }

    /** Height of a text in pixels. */
    static int height(int dot) {
        return ROWS * dot;
    }

    /**
     * Draws a text in white.
     *
     * @param rgb linear components of an image, row by row from the top
     * @param imageWidth its columns
     * @param x left edge of the text, within the image with all of the text
     * @param y upper edge
     * @param dot size of a dot in pixels
     */
    static void draw(String text, float[] rgb, int imageWidth, int x, int y, int dot) {
        String small = text.toLowerCase(Locale.ROOT);
        for (int i = 0; i < small.length(); i++) {
            int glyph = CHARACTERS.indexOf(small.charAt(i));
            for (int row = 0; row < ROWS && glyph >= 0; row++) {
                int at = glyph * GLYPH_LENGTH + 2 * row;
                int bits = Integer.parseInt(GLYPHS, at, at + 2, 16);
                for (int column = 0; column < COLUMNS; column++) {
                    if (((bits >> (COLUMNS - 1 - column)) & 1) != 0) {
                        fill(rgb, imageWidth, x + (i * ADVANCE + column) * dot, y + row * dot, dot);
                    }
                }
            }
        }
    }

    private static void fill(float[] rgb, int imageWidth, int x, int y, int dot) {
        for (int py = y; py < y + dot; py++) {
            java.util.Arrays.fill(rgb, 3 * (py * imageWidth + x), 3 * (py * imageWidth + x + dot), 1);
        }
    }
}
