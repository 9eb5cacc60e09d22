package org.daybreak.exr.imageio;

import java.io.EOFException;
import java.io.IOException;
import java.util.Locale;
import javax.imageio.ImageReader;
import javax.imageio.spi.ImageReaderSpi;
import javax.imageio.stream.ImageInputStream;
import org.jspecify.annotations.Nullable;

/** Offers the reader of one format. */
abstract sealed class LinearReaderSpi extends ImageReaderSpi permits ExrReaderSpi, HdrReaderSpi, PfmReaderSpi {
    private final LinearFormat format;

    LinearReaderSpi(LinearFormat format, String writer) {
        super(
                "Daybreak",
                "1.0",
                format.names(),
                format.suffixes(),
                format.mimeTypes(),
                LinearImageReader.class.getName(),
                new Class<?>[] {ImageInputStream.class},
                new String[] {writer},
                false,
                null,
                null,
                null,
                null,
                false,
                null,
                null,
                null,
                null);
        this.format = format;
    }

    @Override
    public boolean canDecodeInput(@Nullable Object source) throws IOException {
        if (!(source instanceof ImageInputStream stream)) {
            return false;
        }
        byte[] head = new byte[LinearFormat.HEAD_BYTES];
        stream.mark();
        try {
            stream.readFully(head);
            return format.starts(head);
        } catch (EOFException e) {
            return false;
        } finally {
            stream.reset();
        }
    }

    @Override
    public ImageReader createReaderInstance(@Nullable Object extension) {
        return new LinearImageReader(this, format);
    }

    @Override
    public String getDescription(@Nullable Locale locale) {
        return format + " images of linear floats";
    }
}
