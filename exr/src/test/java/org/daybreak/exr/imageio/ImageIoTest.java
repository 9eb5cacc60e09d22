package org.daybreak.exr.imageio;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.Rectangle;
import java.awt.color.ColorSpace;
import java.awt.image.BufferedImage;
import java.awt.image.DataBuffer;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.File;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import javax.imageio.IIOImage;
import javax.imageio.ImageIO;
import javax.imageio.ImageReadParam;
import javax.imageio.ImageReader;
import javax.imageio.ImageWriteParam;
import javax.imageio.ImageWriter;
import javax.imageio.stream.ImageInputStream;
import javax.imageio.stream.ImageOutputStream;
import org.daybreak.exr.Compression;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.daybreak.exr.ExrWriteOptions;
import org.daybreak.exr.ExrWriter;
import org.daybreak.exr.HdrImage;
import org.daybreak.exr.ImageFileException;
import org.daybreak.exr.Pfm;
import org.daybreak.exr.PfmImage;
import org.daybreak.exr.PixelType;
import org.daybreak.exr.RadianceHdr;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ImageIoTest {
    private static final float[] RGBA = {
        0.5f, 1e6f, -2, 1, Float.NaN, 0, 7, 0.25f, 1, 2, 3, 0, Float.POSITIVE_INFINITY, 1, 1, 1, 5, 6, 7, 8, 9, 1, 2, 3
    };

    @TempDir
    Path directory;

    private File file(String name) {
        return directory.resolve(name).toFile();
    }

    private static float[] samples(BufferedImage image) {
        return image.getRaster().getPixels(0, 0, image.getWidth(), image.getHeight(), (float[]) null);
    }

    @Test
    void openExrComesBackBitByBit() throws IOException {
        ExrImage image = ExrImage.builder(3, 2)
                .interleavedLayer("", PixelType.FLOAT, RGBA, "R", "G", "B", "A")
                .uintChannel("id", new int[6])
                .build();
        ExrWriter.write(directory.resolve("a.exr"), image);
        BufferedImage read = ImageIO.read(file("a.exr"));
        assertEquals(DataBuffer.TYPE_FLOAT, read.getRaster().getTransferType());
        assertTrue(read.isAlphaPremultiplied());
        assertEquals(
                ColorSpace.getInstance(ColorSpace.CS_LINEAR_RGB),
                read.getColorModel().getColorSpace());
        assertArrayEquals(RGBA, samples(read));
        assertTrue(ImageIO.write(read, "exr", file("b.exr")));
        assertArrayEquals(RGBA, ExrReader.read(directory.resolve("b.exr")).interleaved("", "R", "G", "B", "A"));
    }

    @Test
    void partsAreImagesAndSingleChannelsGrey() throws IOException {
        ExrImage depth = ExrImage.builder(2, 1)
                .channel("Z", PixelType.FLOAT, new float[] {3, 4})
                .name("depth")
                .build();
        ExrImage ids = ExrImage.builder(2, 1)
                .displayWindow(depth.header().displayWindow())
                .uintChannel("id", new int[] {7, -1})
                .name("ids")
                .build();
        byte[] bytes = ExrWriter.toBytes("x", List.of(depth, ids), ExrWriteOptions.defaults());
        ImageReader reader = ImageIO.getImageReadersBySuffix("exr").next();
        reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(bytes)));
        assertEquals(2, reader.getNumImages(true));
        assertArrayEquals(new float[] {3, 4}, samples(reader.read(0)));
        assertArrayEquals(new float[] {7, 0x1p32f}, samples(reader.read(1)));
        assertThrows(IndexOutOfBoundsException.class, () -> reader.read(2));
    }

    @Test
    void hdrAndPfm() throws IOException {
        float[] rgb = {1, 2, 3, 0.5f, 0.25f, 128};
        RadianceHdr.write(directory.resolve("a.hdr"), new HdrImage(2, 1, rgb));
        BufferedImage hdr = ImageIO.read(file("a.hdr"));
        float[] onGrid = RadianceHdr.read(directory.resolve("a.hdr")).samples();
        assertArrayEquals(onGrid, samples(hdr));
        assertTrue(ImageIO.write(hdr, "hdr", file("b.hdr")));
        assertArrayEquals(onGrid, RadianceHdr.read(directory.resolve("b.hdr")).samples());
        Pfm.write(directory.resolve("a.pfm"), new PfmImage(2, 1, 3, rgb));
        BufferedImage pfm = ImageIO.read(file("a.pfm"));
        assertArrayEquals(rgb, samples(pfm));
        assertTrue(ImageIO.write(pfm, "PFM", file("b.pfm")));
        assertArrayEquals(rgb, Pfm.read(directory.resolve("b.pfm")).samples());
        BufferedImage alpha = new BufferedImage(2, 2, BufferedImage.TYPE_INT_ARGB);
        assertFalse(ImageIO.write(alpha, "hdr", file("c.hdr")));
    }

    @Test
    void displayImagesAreDecodedToLinearLight() throws IOException {
        BufferedImage image = new BufferedImage(2, 1, BufferedImage.TYPE_INT_RGB);
        image.setRGB(0, 0, 0xff8000);
        image.setRGB(1, 0, 0x010203);
        assertTrue(ImageIO.write(image, "exr", file("a.exr")));
        float[] samples = ExrReader.read(directory.resolve("a.exr")).interleaved("", "R", "G", "B");
        // (128/255 + 0.055)/1.055 to the power of 2.4, and 1/255/12.92.
        assertArrayEquals(new float[] {1, 0.21586f, 0}, Arrays.copyOf(samples, 3), 1e-5f);
        assertEquals(1 / 255.0 / 12.92, samples[3], 1e-9);
        BufferedImage grey = new BufferedImage(1, 1, BufferedImage.TYPE_BYTE_GRAY);
        grey.getRaster().setSample(0, 0, 0, 128);
        assertTrue(ImageIO.write(grey, "exr", file("b.exr")));
        assertEquals(0.21586f, ExrReader.read(directory.resolve("b.exr")).samples("Y")[0], 1e-5f);
        BufferedImage half = new BufferedImage(1, 1, BufferedImage.TYPE_INT_ARGB);
        half.setRGB(0, 0, 0x80ffffff);
        assertTrue(ImageIO.write(half, "exr", file("c.exr")));
        float[] rgba = ExrReader.read(directory.resolve("c.exr")).interleaved("", "R", "G", "B", "A");
        assertEquals(128 / 255f, rgba[3], 1e-6f);
        assertEquals(128 / 255f, rgba[0], 1e-6f);
    }

    @Test
    void regionsThinningAndCompressionsAreHonoured() throws IOException {
        float[] samples = new float[100];
        for (int i = 0; i < 100; i++) {
            samples[i] = i;
        }
        ExrImage image =
                ExrImage.builder(10, 10).channel("Y", PixelType.FLOAT, samples).build();
        byte[] bytes = ExrWriter.toBytes("x", List.of(image), ExrWriteOptions.defaults());
        ImageReader reader = ImageIO.getImageReadersByFormatName("OPENEXR").next();
        reader.setInput(ImageIO.createImageInputStream(new ByteArrayInputStream(bytes)));
        ImageReadParam param = reader.getDefaultReadParam();
        param.setSourceRegion(new Rectangle(2, 3, 5, 4));
        param.setSourceSubsampling(2, 3, 1, 0);
        float[] expected = {33, 35, 63, 65};
        assertArrayEquals(expected, samples(reader.read(0, param)));

        ImageWriter writer = ImageIO.getImageWritersByFormatName("exr").next();
        ImageWriteParam write = writer.getDefaultWriteParam();
        write.setSourceRegion(new Rectangle(2, 3, 5, 4));
        write.setSourceSubsampling(2, 3, 1, 0);
        write.setCompressionMode(ImageWriteParam.MODE_EXPLICIT);
        assertArrayEquals(new String[] {"NONE", "RLE", "ZIPS", "ZIP"}, write.getCompressionTypes());
        write.setCompressionType("ZIPS");
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        try (ImageOutputStream stream = ImageIO.createImageOutputStream(out)) {
            writer.setOutput(stream);
            writer.write(null, new IIOImage(reader.read(0), null, null), write);
        }
        ExrImage written = ExrReader.readParts("x", out.toByteArray(), 1).get(0);
        assertEquals(Compression.ZIPS, written.header().compression());
        assertArrayEquals(expected, written.samples("Y"));
    }

    @Test
    void damageIsOneErrorAndOtherFilesAreLeftToOthers() throws IOException {
        byte[] bytes = {0x76, 0x2f, 0x31, 1, 2, 0, 0, 0, 'x'};
        try (ImageInputStream stream = ImageIO.createImageInputStream(new ByteArrayInputStream(bytes))) {
            ImageReader reader = ImageIO.getImageReaders(stream).next();
            reader.setInput(stream);
            ImageFileException e = assertThrows(ImageFileException.class, () -> reader.read(0));
            assertTrue(e.getMessage().startsWith("the image stream: "), e.getMessage());
        }
        ByteArrayOutputStream png = new ByteArrayOutputStream();
        ImageIO.write(new BufferedImage(1, 1, BufferedImage.TYPE_INT_RGB), "png", png);
        assertEquals(
                1, ImageIO.read(new ByteArrayInputStream(png.toByteArray())).getWidth());
    }
}
