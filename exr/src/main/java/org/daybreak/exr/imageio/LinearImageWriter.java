package org.daybreak.exr.imageio;

import java.awt.Rectangle;
import java.awt.image.RenderedImage;
import java.io.IOException;
import java.util.List;
import javax.imageio.IIOImage;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.spi.ImageWriterSpi;
import javax.imageio.stream.ImageOutputStream;
import org.jspecify.annotations.Nullable;

/** Writes a file of linear floats as ImageIO wants it. */
final class LinearImageWriter extends ImageWriter {
    private static final String DEFAULT_COMPRESSION = "ZIP";

    private final LinearFormat format;

    LinearImageWriter(ImageWriterSpi provider, LinearFormat format) {
        super(provider);
        this.format = format;
    }

    /** Lets callers choose among the compressions of the format. */
    private static final class Param extends ImageWriteParam {
        Param(LinearFormat format) {
            List<String> names = format.compressions();
            if (!names.isEmpty()) {
                canWriteCompressed = true;
                compressionTypes = names.toArray(String[]::new);
                compressionType = DEFAULT_COMPRESSION;
            }
        }
    }

    @Override
    public ImageWriteParam getDefaultWriteParam() {
        return new Param(format);
    }

    @Override
    public @Nullable IIOMetadata getDefaultStreamMetadata(@Nullable ImageWriteParam param) {
        return null;
    }

    @Override
    public @Nullable IIOMetadata getDefaultImageMetadata(ImageTypeSpecifier type, @Nullable ImageWriteParam param) {
        return null;
    }

    @Override
    public @Nullable IIOMetadata convertStreamMetadata(IIOMetadata data, @Nullable ImageWriteParam param) {
        return null;
    }

    @Override
    public @Nullable IIOMetadata convertImageMetadata(
            IIOMetadata data, ImageTypeSpecifier type, @Nullable ImageWriteParam param) {
        return null;
    }

    @Override
    public void write(@Nullable IIOMetadata streamMetadata, IIOImage image, @Nullable ImageWriteParam param)
            throws IOException {
        if (!(getOutput() instanceof ImageOutputStream output)) {
            throw new IllegalStateException("no output has been set");
        }
        if (image.hasRaster()) {
            throw new UnsupportedOperationException("rasters without colours cannot be written");
        }
        RenderedImage rendered = image.getRenderedImage();
        if (rendered.getColorModel() == null) {
            throw new IOException("an image without colour model cannot be written");
        }
        String problem = LinearRasters.problem(
                rendered.getColorModel(), rendered.getSampleModel().getNumBands());
        if (problem != null) {
            throw new IOException(problem);
        }
        LinearPicture picture = select(LinearRasters.picture(rendered), param);
        if (!format.holds(picture.components())) {
            throw new IOException("the format " + format + " has no alpha channel");
        }
        processImageStarted(0);
        byte[] bytes = format.encode(picture, compression(param));
        output.write(bytes);
        output.flush();
        processImageComplete();
    }

    private static String compression(@Nullable ImageWriteParam param) {
        if (param == null || !param.canWriteCompressed()) {
            return DEFAULT_COMPRESSION;
        }
        return switch (param.getCompressionMode()) {
            case ImageWriteParam.MODE_DISABLED -> "NONE";
            case ImageWriteParam.MODE_EXPLICIT -> {
                String type = param.getCompressionType();
                yield type == null ? DEFAULT_COMPRESSION : type;
            }
            default -> DEFAULT_COMPRESSION;
        };
    }

    /** Cuts out and thins as the parameters ask for. */
    private static LinearPicture select(LinearPicture picture, @Nullable ImageWriteParam param) {
        if (param == null) {
            return picture;
        }
        Rectangle all = new Rectangle(picture.width(), picture.height());
        Rectangle region = param.getSourceRegion() == null ? all : all.intersection(param.getSourceRegion());
        int left = region.x + param.getSubsamplingXOffset();
        int top = region.y + param.getSubsamplingYOffset();
        int xStep = param.getSourceXSubsampling();
        int yStep = param.getSourceYSubsampling();
        int width = Math.floorDiv(region.x + region.width - left + xStep - 1, xStep);
        int height = Math.floorDiv(region.y + region.height - top + yStep - 1, yStep);
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("the source region holds no pixel");
        }
        if (width == picture.width() && height == picture.height()) {
            return picture;
        }
        int components = picture.components();
        float[] samples = new float[width * height * components];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int from = ((top + y * yStep) * picture.width() + left + x * xStep) * components;
                System.arraycopy(picture.samples(), from, samples, (y * width + x) * components, components);
            }
        }
        return new LinearPicture(width, height, components, samples);
    }
}
