package org.daybreak.exr.imageio;

import java.util.Locale;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.spi.ImageWriterSpi;
import javax.imageio.stream.ImageOutputStream;
import org.jspecify.annotations.Nullable;

/** Offers the writer of one format. */
abstract sealed class LinearWriterSpi extends ImageWriterSpi permits ExrWriterSpi, HdrWriterSpi, PfmWriterSpi {
    private final LinearFormat format;

    LinearWriterSpi(LinearFormat format, String reader) {
        super(
                "Daybreak",
                "1.0",
                format.names(),
                format.suffixes(),
                format.mimeTypes(),
                LinearImageWriter.class.getName(),
                new Class<?>[] {ImageOutputStream.class},
                new String[] {reader},
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
    public boolean canEncodeImage(ImageTypeSpecifier type) {
        return LinearRasters.problem(type.getColorModel(), type.getNumBands()) == null
                && (format.holds(2) || !type.getColorModel().hasAlpha());
    }

    @Override
    public ImageWriter createWriterInstance(@Nullable Object extension) {
        return new LinearImageWriter(this, format);
    }

    @Override
    public String getDescription(@Nullable Locale locale) {
        return format + " images of linear floats";
    }
}
