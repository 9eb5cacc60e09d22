package org.daybreak.exr;

/**
 * A rectangle of pixels, OpenEXR's {@code box2i}; both corners belong to it. As an attribute it may be empty
 * ({@code xMax < xMin}); windows of an image may not.
 *
 * @param xMin left column
 * @param yMin top row
 * @param xMax right column, inclusive
 * @param yMax bottom row, inclusive
 */
public record Box2i(int xMin, int yMin, int xMax, int yMax) {
    /**
     * Creates the rectangle of the given size whose top left pixel is (0, 0).
     *
     * @param width columns, at least 1
     * @param height rows, at least 1
     * @return the rectangle
     * @throws IllegalArgumentException if a size is below 1
     */
    public static Box2i ofSize(int width, int height) {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("an image needs at least one pixel, not " + width + " x " + height);
        }
        return new Box2i(0, 0, width - 1, height - 1);
    }

    /**
     * Returns the number of columns; a long, as the corners may be as far apart as 2<sup>32</sup>.
     *
     * @return xMax − xMin + 1
     */
    public long width() {
        return (long) xMax - xMin + 1;
    }

    /**
     * Returns the number of rows.
     *
     * @return yMax − yMin + 1
     */
    public long height() {
        return (long) yMax - yMin + 1;
    }

    /**
     * Tells whether the rectangle holds no pixel.
     *
     * @return true if a maximum is below its minimum
     */
    public boolean isEmpty() {
        return xMax < xMin || yMax < yMin;
    }
}
