package org.daybreak.exr;

/**
 * A pair of integers, OpenEXR's {@code v2i}.
 *
 * @param x first component
 * @param y second component
 */
public record V2i(int x, int y) {}
