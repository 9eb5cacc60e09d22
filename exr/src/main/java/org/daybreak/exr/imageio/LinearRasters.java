package org.daybreak.exr.imageio;

import java.awt.Transparency;
import java.awt.color.ColorSpace;
import java.awt.image.ColorModel;
import java.awt.image.ComponentColorModel;
import java.awt.image.DataBuffer;
import java.awt.image.DataBufferFloat;
import java.awt.image.PixelInterleavedSampleModel;
import java.awt.image.Raster;
import java.awt.image.RenderedImage;
import java.awt.image.WritableRaster;
import java.util.Arrays;
import javax.imageio.ImageTypeSpecifier;
import org.daybreak.exr.SrgbTransfer;
import org.jspecify.annotations.Nullable;

/** Turns pictures of floats into images of the JDK and back. */
final class LinearRasters {
    private LinearRasters() {}

    /** The type of images with 1 to 4 interleaved floats for each pixel. */
    static ImageTypeSpecifier type(int components) {
        boolean alpha = components % 2 == 0;
        int[] bands = new int[components];
        for (int i = 0; i < components; i++) {
            bands[i] = i;
        }
        return ImageTypeSpecifier.createInterleaved(
                ColorSpace.getInstance(components < 3 ? ColorSpace.CS_GRAY : ColorSpace.CS_LINEAR_RGB),
                bands,
                DataBuffer.TYPE_FLOAT,
                alpha,
                alpha);
    }

    /** The picture as a raster that shares its samples. */
    static WritableRaster raster(LinearPicture picture) {
        int components = picture.components();
        int[] bands = new int[components];
        Arrays.setAll(bands, i -> i);
        return Raster.createWritableRaster(
                new PixelInterleavedSampleModel(
                        DataBuffer.TYPE_FLOAT,
                        picture.width(),
                        picture.height(),
                        components,
                        components * picture.width(),
                        bands),
                new DataBufferFloat(picture.samples(), picture.samples().length),
                null);
    }

    /** Why an image cannot be written, or null if it can. */
    static @Nullable String problem(ColorModel colors, int bands) {
        int type = colors.getColorSpace().getType();
        if (bands < 1 || bands > 4) {
            return "an image of " + bands + " bands is not supported";
        }
        if (colors.getColorSpace().isCS_sRGB() || isLinearRgb(colors) || type == ColorSpace.TYPE_GRAY) {
            return null;
        }
        return "a colour space other than sRGB, linear RGB and grey is not supported";
    }

    private static boolean isFloat(ColorModel colors) {
        return colors instanceof ComponentColorModel
                && (colors.getTransferType() == DataBuffer.TYPE_FLOAT
                        || colors.getTransferType() == DataBuffer.TYPE_DOUBLE);
    }

    private static boolean isLinearRgb(ColorModel colors) {
        return colors.getColorSpace().equals(ColorSpace.getInstance(ColorSpace.CS_LINEAR_RGB));
    }

    /**
     * Takes an image apart. Floats of linear RGB and of grey are taken as they are; so are integers of linear RGB, over
     * their range. All else is decoded from sRGB, also integers of grey, which is what grey files hold whatever the JDK
     * calls them. Colours are multiplied by alpha unless they are already.
     */
    static LinearPicture picture(RenderedImage image) {
        ColorModel colors = image.getColorModel();
        Raster raster = image.getData();
        int width = raster.getWidth();
        int height = raster.getHeight();
        boolean linear = isLinearRgb(colors)
                || (isFloat(colors) && colors.getColorSpace().getType() == ColorSpace.TYPE_GRAY);
        boolean grey = colors.getColorSpace().getType() == ColorSpace.TYPE_GRAY;
        boolean alpha = colors.getTransparency() != Transparency.OPAQUE;
        int components = (grey ? 1 : 3) + (alpha ? 1 : 0);
        float[] samples = new float[Math.multiplyExact(Math.multiplyExact(width, height), components)];
        float[] pixel = new float[Math.max(4, raster.getNumBands())];
        Object element = null;
        int at = 0;
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                if (isFloat(colors)) {
                    raster.getPixel(raster.getMinX() + x, raster.getMinY() + y, pixel);
                } else {
                    element = raster.getDataElements(raster.getMinX() + x, raster.getMinY() + y, element);
                    colors.getNormalizedComponents(element, pixel, 0);
                }
                toLinear(pixel, components, alpha, linear, colors.isAlphaPremultiplied());
                System.arraycopy(pixel, 0, samples, at, components);
                at += components;
            }
        }
        return new LinearPicture(width, height, components, samples);
    }

    private static void toLinear(float[] pixel, int components, boolean alpha, boolean linear, boolean premultiplied) {
        int colorCount = alpha ? components - 1 : components;
        float coverage = alpha ? pixel[colorCount] : 1;
        for (int c = 0; c < colorCount; c++) {
            if (linear) {
                pixel[c] = premultiplied ? pixel[c] : pixel[c] * coverage;
                continue;
            }
            // The curve holds for the colour itself, not for its product with alpha.
            double own = premultiplied && coverage > 0 ? pixel[c] / coverage : pixel[c];
            pixel[c] = (float) (SrgbTransfer.decode(own) * coverage);
        }
    }
}
