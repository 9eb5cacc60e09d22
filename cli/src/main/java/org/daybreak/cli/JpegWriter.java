package org.daybreak.cli;

import java.awt.image.BufferedImage;
import java.awt.image.DataBufferByte;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Iterator;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.MemoryCacheImageOutputStream;
import org.daybreak.exr.AtomicFiles;
import org.daybreak.exr.ImageFileException;
import org.daybreak.exr.SrgbTransfer;

/** Writes linear RGB as JPEG for display: 8-bit sRGB, clamped, as the PNG writer does. */
final class JpegWriter {
    private static final float QUALITY = 0.95f;

    private JpegWriter() {}

    /**
     * Writes an image.
     *
     * @param linearRgb interleaved, rows from the top
     * @throws ImageFileException if that fails
     */
    static void write(Path file, int width, int height, float[] linearRgb) throws ImageFileException {
        BufferedImage picture = new BufferedImage(width, height, BufferedImage.TYPE_3BYTE_BGR);
        byte[] bgr = ((DataBufferByte) picture.getRaster().getDataBuffer()).getData();
        for (int i = 0; i < linearRgb.length; i += 3) {
            for (int c = 0; c < 3; c++) {
                bgr[i + 2 - c] = (byte) SrgbTransfer.encode8Bit(linearRgb[i + c]);
            }
        }
        byte[] bytes;
        try {
            bytes = encode(picture);
        } catch (IOException e) {
            throw new ImageFileException(file, "cannot be written: " + e.getMessage(), e);
        }
        AtomicFiles.write(file, bytes);
    }

    /** Goes through memory, as ImageIO's own streams put a cache file into the system's temporary directory. */
    private static byte[] encode(BufferedImage picture) throws IOException {
        Iterator<ImageWriter> writers = ImageIO.getImageWritersByFormatName("jpeg");
        if (!writers.hasNext()) {
            throw new IOException("this Java runtime has no JPEG writer");
        }
        ImageWriter writer = writers.next();
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (MemoryCacheImageOutputStream stream = new MemoryCacheImageOutputStream(bytes)) {
            ImageWriteParam parameters = writer.getDefaultWriteParam();
            parameters.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
            parameters.setCompressionQuality(QUALITY);
            writer.setOutput(stream);
            writer.write(null, new IIOImage(picture, null, null), parameters);
        } finally {
            writer.dispose();
        }
        return bytes.toByteArray();
    }
}
