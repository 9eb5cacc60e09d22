package org.daybreak.exr.imageio;

import java.awt.Rectangle;
import java.awt.image.BufferedImage;
import java.awt.image.WritableRaster;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.util.Iterator;
import java.util.List;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.spi.ImageReaderSpi;
import javax.imageio.stream.ImageInputStream;
import org.jspecify.annotations.Nullable;

/** Reads a file of linear floats as ImageIO wants it. The stream is read to its end at the first question. */
final class LinearImageReader extends ImageReader {
    private static final int MAX_BYTES = Integer.MAX_VALUE - 8;

    private final LinearFormat format;
    private @Nullable List<PictureSource> sources;

    LinearImageReader(ImageReaderSpi provider, LinearFormat format) {
        super(provider);
        this.format = format;
    }

    @Override
    public void setInput(@Nullable Object stream, boolean seekForwardOnly, boolean ignoreMetadata) {
        super.setInput(stream, seekForwardOnly, ignoreMetadata);
        sources = null;
    }

    @Override
    public void reset() {
        super.reset();
        sources = null;
    }

    private PictureSource source(int index) throws IOException {
        List<PictureSource> opened = sources;
        if (opened == null) {
            if (!(getInput() instanceof ImageInputStream stream)) {
                throw new IllegalStateException("no input has been set");
            }
            opened = format.open(readAll(stream));
            sources = opened;
        }
        if (index < 0 || index >= opened.size()) {
            throw new IndexOutOfBoundsException("no image " + index + ", the file has " + opened.size());
        }
        return opened.get(index);
    }

    private static byte[] readAll(ImageInputStream stream) throws IOException {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        byte[] buffer = new byte[1 << 16];
        for (int count = stream.read(buffer); count >= 0; count = stream.read(buffer)) {
            if (count > MAX_BYTES - bytes.size()) {
                throw new IOException("the stream is too long for an array");
            }
            bytes.write(buffer, 0, count);
        }
        return bytes.toByteArray();
    }

    @Override
    public int getNumImages(boolean allowSearch) throws IOException {
        source(0);
        return sources == null ? 0 : sources.size();
    }

    @Override
    public int getWidth(int imageIndex) throws IOException {
        return source(imageIndex).width();
    }

    @Override
    public int getHeight(int imageIndex) throws IOException {
        return source(imageIndex).height();
    }

    @Override
    public Iterator<ImageTypeSpecifier> getImageTypes(int imageIndex) throws IOException {
        return List.of(LinearRasters.type(source(imageIndex).components())).iterator();
    }

    @Override
    public @Nullable IIOMetadata getStreamMetadata() {
        return null;
    }

    @Override
    public @Nullable IIOMetadata getImageMetadata(int imageIndex) {
        return null;
    }

    @Override
    public BufferedImage read(int imageIndex, @Nullable ImageReadParam param) throws IOException {
        PictureSource source = source(imageIndex);
        clearAbortRequest();
        processImageStarted(imageIndex);
        BufferedImage image = getDestination(param, getImageTypes(imageIndex), source.width(), source.height());
        checkReadParamBandSettings(
                param, source.components(), image.getSampleModel().getNumBands());
        Rectangle from = new Rectangle();
        Rectangle to = new Rectangle();
        computeRegions(param, source.width(), source.height(), image, from, to);
        copy(LinearRasters.raster(source.read()), from, image.getRaster(), to, param);
        processImageComplete();
        return image;
    }

    private static void copy(
            WritableRaster picture,
            Rectangle from,
            WritableRaster image,
            Rectangle to,
            @Nullable ImageReadParam param) {
        int xStep = param == null ? 1 : param.getSourceXSubsampling();
        int yStep = param == null ? 1 : param.getSourceYSubsampling();
        int[] fromBands = param == null ? null : param.getSourceBands();
        int[] toBands = param == null ? null : param.getDestinationBands();
        int bands = fromBands != null ? fromBands.length : picture.getNumBands();
        float[] pixel = new float[picture.getNumBands()];
        for (int y = 0; y < to.height; y++) {
            for (int x = 0; x < to.width; x++) {
                picture.getPixel(from.x + x * xStep, from.y + y * yStep, pixel);
                for (int band = 0; band < bands; band++) {
                    float sample = pixel[fromBands == null ? band : fromBands[band]];
                    image.setSample(to.x + x, to.y + y, toBands == null ? band : toBands[band], sample);
                }
            }
        }
    }
}
