package org.daybreak.exr;

/** The order in which the chunks of rows are stored in the file. Rows of an {@link ExrImage} always run downwards. */
public enum LineOrder {
    /** Top chunk first. */
    INCREASING_Y,
    /** Bottom chunk first. */
    DECREASING_Y
}
