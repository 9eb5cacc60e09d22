package org.daybreak.exr;

/**
 * A rectangle in floats, OpenEXR's {@code box2f}.
 *
 * @param xMin left edge
 * @param yMin top edge
 * @param xMax right edge
 * @param yMax bottom edge
 */
public record Box2f(float xMin, float yMin, float xMax, float yMax) {}
