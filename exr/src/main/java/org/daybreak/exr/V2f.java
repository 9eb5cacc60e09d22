package org.daybreak.exr;

/**
 * A pair of floats, OpenEXR's {@code v2f}.
 *
 * @param x first component
 * @param y second component
 */
public record V2f(float x, float y) {}
