package org.daybreak.scenes.image;

import java.awt.image.BufferedImage;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.Raster;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import java.util.Set;
import java.util.TreeSet;
import javax.imageio.ImageIO;
import javax.imageio.ImageReader;
import javax.imageio.stream.ImageInputStream;

/**
 * Reads what the JDK can — PNG (8 and 16 bits), JPEG, BMP, GIF — and the linear formats OpenEXR, Radiance HDR and PFM where
 * a plug-in of ImageIO for them is on the class path, such as the one of Daybreak's module {@code exr}. Stored values are
 * kept; colour profiles are ignored, and so is the exposure that an HDR file may name.
 */
public final class StandardImageLoader implements ImageLoader {
    /** Larger images are refused before memory is asked for. */
    private static final long MOST_SAMPLES = 1L << 30;

    private static final Set<String> ENDINGS = Set.of("png", "jpg", "jpeg", "bmp", "gif");
    private static final Set<String> LINEAR_ENDINGS = Set.of("exr", "hdr", "pfm");

    /** Creates a loader; it has no state. */
    public StandardImageLoader() {}

    @Override
    public Set<String> endings() {
        Set<String> endings = new TreeSet<>(ENDINGS);
        for (String ending : LINEAR_ENDINGS) {
            if (ImageIO.getImageReadersBySuffix(ending).hasNext()) {
                endings.add(ending);
            }
        }
        return Set.copyOf(endings);
    }

    @Override
    public LoadedImage load(Path file) throws IOException {
        return load(file.toFile());
    }

    @Override
    public LoadedImage load(byte[] content, String ending) throws IOException {
        return load(new ByteArrayInputStream(content));
    }

    /** Reads from what ImageIO can read from. */
    private static LoadedImage load(Object source) throws IOException {
        try (ImageInputStream stream = ImageIO.createImageInputStream(source)) {
            if (stream == null) {
                throw new IOException("the file cannot be opened");
            }
            Iterator<ImageReader> readers = ImageIO.getImageReaders(stream);
            if (!readers.hasNext()) {
                throw new IOException("the content is no image of a known format");
            }
            ImageReader reader = readers.next();
            try {
                reader.setInput(stream, true, true);
                long pixels = (long) reader.getWidth(0) * reader.getHeight(0);
                if (pixels > MOST_SAMPLES / 4) {
                    throw new IOException("the image has " + pixels + " pixels, too many to read");
                }
                return convert(reader.read(0));
            } finally {
                reader.dispose();
            }
        } catch (RuntimeException e) {
            // The JDK's readers answer some damaged files with index and argument exceptions.
            throw new IOException("the image is damaged: " + e.getMessage(), e);
        }
    }

    private static LoadedImage convert(BufferedImage image) {
        int width = image.getWidth();
        int height = image.getHeight();
        Raster raster = image.getRaster();
        int channels = raster.getNumBands();
        int type = raster.getTransferType();
        // Raster samples are the stored values. getRGB would take grey images for linear and brighten them.
        if (image.getColorModel() instanceof ComponentColorModel && channels <= 4) {
            if (type == DataBuffer.TYPE_BYTE) {
                return new LoadedImage.Bytes(width, height, channels, bytes(raster, width, height, channels));
            }
            if (type == DataBuffer.TYPE_USHORT) {
                return new LoadedImage.Floats(width, height, channels, shorts(raster, width, height, channels), true);
            }
            if (type == DataBuffer.TYPE_FLOAT) {
                float[] samples = raster.getPixels(raster.getMinX(), raster.getMinY(), width, height, (float[]) null);
                return new LoadedImage.Floats(width, height, channels, samples, false);
            }
        }
        int count = image.getColorModel().hasAlpha() ? 4 : 3;
        return new LoadedImage.Bytes(width, height, count, packed(image, width, height, count));
    }

    private static byte[] bytes(Raster raster, int width, int height, int channels) {
        byte[] samples = new byte[width * height * channels];
        int[] row = new int[width * channels];
        int i = 0;
        for (int y = 0; y < height; y++) {
            raster.getPixels(raster.getMinX(), raster.getMinY() + y, width, 1, row);
            for (int value : row) {
                samples[i++] = (byte) value;
            }
        }
        return samples;
    }

    private static float[] shorts(Raster raster, int width, int height, int channels) {
        float[] samples = new float[width * height * channels];
        int[] row = new int[width * channels];
        int i = 0;
        for (int y = 0; y < height; y++) {
            raster.getPixels(raster.getMinX(), raster.getMinY() + y, width, 1, row);
            for (int value : row) {
                samples[i++] = value / 65535f;
            }
        }
        return samples;
    }

    private static byte[] packed(BufferedImage image, int width, int height, int channels) {
        byte[] samples = new byte[width * height * channels];
        int[] row = new int[width];
        int i = 0;
        for (int y = 0; y < height; y++) {
            image.getRGB(0, y, width, 1, row, 0, width);
            for (int argb : row) {
                samples[i++] = (byte) (argb >> 16);
                samples[i++] = (byte) (argb >> 8);
                samples[i++] = (byte) argb;
                if (channels == 4) {
                    samples[i++] = (byte) (argb >> 24);
                }
            }
        }
        return samples;
    }
}
