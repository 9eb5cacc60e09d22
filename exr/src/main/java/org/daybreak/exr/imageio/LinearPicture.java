package org.daybreak.exr.imageio;

/**
 * A picture of linear floats.
 *
 * @param width columns
 * @param height rows
 * @param components 1 grey, 2 grey and alpha, 3 RGB, 4 RGB and alpha; colours are premultiplied by alpha
 * @param samples index {@code (y * width + x) * components + c}, rows from top to bottom
 */
record LinearPicture(int width, int height, int components, float[] samples) {}
