package org.daybreak.exr.imageio;

import java.io.IOException;

/** One image of a file, whose pixels may not have been read yet. */
interface PictureSource {
    /** Columns. */
    int width();

    /** Rows. */
    int height();

    /** Floats for each pixel, see {@link LinearPicture}. */
    int components();

    /** Reads the pixels. */
    LinearPicture read() throws IOException;

    /** An image that has been read. */
    static PictureSource of(LinearPicture picture) {
        return new PictureSource() {
            @Override
            public int width() {
                return picture.width();
            }

            @Override
            public int height() {
                return picture.height();
            }

            @Override
            public int components() {
                return picture.components();
            }

            @Override
            public LinearPicture read() {
                return picture;
            }
        };
    }
}
