package org.daybreak.exr;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageTypeSpecifier;
import javax.imageio.ImageWriter;
import javax.imageio.metadata.IIOMetadata;
import javax.imageio.metadata.IIOMetadataNode;
import javax.imageio.stream.MemoryCacheImageOutputStream;

/**
 * Writes linear RGB as an 8-bit sRGB PNG for display. Each component is multiplied by the exposure scale, clamped to [0,
 * 1], passed through the sRGB curve ({@link SrgbTransfer}) and rounded to the nearest of 0 to 255; there is no tone
 * mapping and no dithering. NaN becomes 0. The file says that it is sRGB. Needs no display.
 */
public final class PngWriter {
    private static final String METADATA_FORMAT = "javax_imageio_png_1.0";

    private PngWriter() {}

    /**
     * Writes an image with exposure scale 1.
     *
     * @param file file to create or replace, see {@link AtomicFiles}
     * @param width columns, at least 1
     * @param height rows, at least 1
     * @param linearRgb linear components with the primaries of Rec. 709, index {@code (y * width + x) * 3 + c}, rows
     *     from top to bottom
     * @throws ImageFileException if the file cannot be written
     * @throws IllegalArgumentException if a size is below 1 or the array has another length
     */
    public static void write(Path file, int width, int height, float[] linearRgb) throws ImageFileException {
        write(file, width, height, linearRgb, 1);
    }

    /**
     * Writes an image.
     *
     * @param file file to create or replace, see {@link AtomicFiles}
     * @param width columns, at least 1
     * @param height rows, at least 1
     * @param linearRgb linear components with the primaries of Rec. 709, index {@code (y * width + x) * 3 + c}, rows
     *     from top to bottom
     * @param exposureScale factor on each component before the curve; 2 is one stop brighter
     * @throws ImageFileException if the file cannot be written
     * @throws IllegalArgumentException if a size is below 1, the array has another length, or the scale is not positive
     *     and finite
     */
    public static void write(Path file, int width, int height, float[] linearRgb, double exposureScale)
            throws ImageFileException {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("an image needs at least one pixel, not " + width + " x " + height);
        }
        if (linearRgb.length % 3 != 0 || linearRgb.length / 3 != (long) width * height) {
            throw new IllegalArgumentException(linearRgb.length + " samples for " + width + " x " + height + " x 3");
        }
        if (!(exposureScale > 0 && exposureScale <= Double.MAX_VALUE)) {
            throw new IllegalArgumentException("the exposure scale must be positive and finite, not " + exposureScale);
        }
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_3BYTE_BGR);
        byte[] bgr = ((DataBufferByte) picture.getRaster().getDataBuffer()).getData();
        for (int i = 0; i < linearRgb.length; i += 3) {
            for (int c = 0; c < 3; c++) {
                bgr[i + 2 - c] = (byte) SrgbTransfer.encode8Bit(linearRgb[i + c] * exposureScale);
            }
        }
        try {
            AtomicFiles.write(file, encode(picture));
        } catch (ImageFileException e) {
            throw e;
        } catch (IOException e) {
            throw new ImageFileException(file, "cannot be written: " + e.getMessage(), e);
        }
    }

    /** Goes through memory, as ImageIO's own streams put a cache file into the system's temporary directory. */
    private static byte[] encode(BufferedImage picture) throws IOException {
        Iterator<ImageWriter> writers = ImageIO.getImageWritersByFormatName("png");
        if (!writers.hasNext()) {
            throw new IOException("this Java runtime has no PNG writer");
        }
        ImageWriter writer = writers.next();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(bytes)) {
            writer.setOutput(stream);
            writer.write(new IIOImage(picture, null, srgbMetadata(writer, picture)));
        } finally {
            writer.dispose();
        }
        return bytes.toByteArray();
    }

    private static IIOMetadata srgbMetadata(ImageWriter writer, BufferedImage picture) throws IOException {
        IIOMetadata metadata =
                writer.getDefaultImageMetadata(ImageTypeSpecifier.createFromRenderedImage(picture), null);
        IIOMetadataNode root = new IIOMetadataNode(METADATA_FORMAT);
        IIOMetadataNode srgb = new IIOMetadataNode("sRGB");
        srgb.setAttribute("renderingIntent", "Perceptual");
        root.appendChild(srgb);
        metadata.mergeTree(METADATA_FORMAT, root);
        return metadata;
    }
}
