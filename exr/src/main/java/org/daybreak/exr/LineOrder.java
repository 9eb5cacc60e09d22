package org.daybreak.exr;

import org.jspecify.annotations.Nullable;

/** The order in which the chunks of rows or the tiles are stored in the file. Rows of an {@link ExrImage} always run downwards. */
public enum LineOrder {
    /** Top chunk first. */
    INCREASING_Y(0),
    /** Bottom chunk first. */
    DECREASING_Y(1),
    /** Any order; tiled images only. */
    RANDOM_Y(2);

    private final int code;

    LineOrder(int code) {
        this.code = code;
    }

    /** The number that stands for this order in a header. */
    int code() {
        return code;
    }

    /** The order with the given code, or null if the format has none. */
    static @Nullable LineOrder ofCode(int code) {
        for (LineOrder order : values()) {
            if (order.code == code) {
                return order;
            }
        }
        return null;
    }
}
