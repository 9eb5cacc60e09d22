package org.daybreak.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.daybreak.core.render.NearestName;
import org.daybreak.exr.Box2i;
import org.daybreak.exr.Chromaticities;
import org.daybreak.exr.ExrAttribute;
import org.daybreak.exr.ExrChannel;
import org.daybreak.exr.ExrHeader;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.daybreak.exr.Pfm;
import org.daybreak.exr.PfmImage;
import org.daybreak.exr.PixelType;
import org.daybreak.exr.V2f;
import org.daybreak.scenes.image.ImageLoader;

/**
 * An image of linear values read from a file.
 *
 * @param width columns
 * @param height rows
 * @param format what the file is, in words
 * @param types kind of number of each channel, in words
 * @param channels samples of each channel, rows from the top
 * @param attributes what the file says about the image, in words
 */
record ImageData(
        int width,
        int height,
        String format,
        Map<String, String> types,
        Map<String, float[]> channels,
        Map<String, String> attributes) {
    private static final List<String> ENDINGS = List.of("exr", "pfm");

    /** True if a file is an image by its ending. */
    static boolean isImage(Path file) {
        return ENDINGS.contains(ImageLoader.ending(file));
    }

    /** Reads an EXR or PFM file; {@link ExitCode#INPUT} if that cannot be done. */
    static ImageData read(Path file) {
        String ending = ImageLoader.ending(file);
        if (!isImage(file)) {
            throw new CommandException(
                    ExitCode.INPUT, file + ": is no image with linear values" + NearestName.hint(ending, ENDINGS));
        }
        if (!Files.exists(file)) {
            throw new CommandException(ExitCode.INPUT, file + ": there is no such file");
        }
        try {
            return ending.equals("exr") ? exr(ExrReader.read(file)) : pfm(Pfm.read(file));
        } catch (IOException e) {
            throw new CommandException(ExitCode.INPUT, String.valueOf(e.getMessage()), e);
        }
    }

    private static ImageData exr(ExrImage image) {
        ExrHeader header = image.header();
        Map<String, String> types = new LinkedHashMap<>();
        Map<String, float[]> channels = new LinkedHashMap<>();
        for (ExrChannel channel : header.channels()) {
            types.put(channel.name(), channel.type().name().toLowerCase(java.util.Locale.ROOT));
            channels.put(
                    channel.name(),
                    channel.type() == PixelType.UINT
                            ? floats(image.uintSamples(channel.name()))
                            : image.samples(channel.name()));
        }
        Map<String, String> attributes = new LinkedHashMap<>();
        attributes.put("compression", header.compression().toString());
        attributes.put("dataWindow", text(header.dataWindow()));
        attributes.put("displayWindow", text(header.displayWindow()));
        header.attributes().forEach((name, value) -> attributes.put(name, text(value)));
        return new ImageData(image.width(), image.height(), "OpenEXR", types, channels, attributes);
    }

    private static float[] floats(int[] unsigned) {
        float[] values = new float[unsigned.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = Integer.toUnsignedLong(unsigned[i]);
        }
        return values;
    }

    private static String text(ExrAttribute value) {
        if (value instanceof ExrAttribute.StringValue string) {
            return string.value();
        } else if (value instanceof ExrAttribute.IntValue number) {
            return Integer.toString(number.value());
        } else if (value instanceof ExrAttribute.FloatValue number) {
            return Float.toString(number.value());
        } else if (value instanceof ExrAttribute.DoubleValue number) {
            return number.value() == Math.rint(number.value()) && Math.abs(number.value()) < 1e15
                    ? Long.toString((long) number.value())
                    : Double.toString(number.value());
        } else if (value instanceof ExrAttribute.ChromaticitiesValue primaries) {
            Chromaticities p = primaries.value();
            return "red " + text(p.red()) + ", green " + text(p.green()) + ", blue " + text(p.blue()) + ", white "
                    + text(p.white());
        }
        return value.toString();
    }

    private static String text(Box2i box) {
        return "(" + box.xMin() + ", " + box.yMin() + ") to (" + box.xMax() + ", " + box.yMax() + ")";
    }

    private static String text(V2f point) {
        return "(" + point.x() + ", " + point.y() + ")";
    }

    private static ImageData pfm(PfmImage image) {
        List<String> names = image.components() == 3 ? List.of("R", "G", "B") : List.of("Y");
        Map<String, String> types = new LinkedHashMap<>();
        Map<String, float[]> channels = new LinkedHashMap<>();
        int components = image.components();
        int pixels = image.width() * image.height();
        for (int c = 0; c < components; c++) {
            float[] samples = new float[pixels];
            for (int i = 0; i < pixels; i++) {
                samples[i] = image.samples()[i * components + c];
            }
            types.put(names.get(c), "float");
            channels.put(names.get(c), samples);
        }
        return new ImageData(
                image.width(), image.height(), "PFM", types, channels, Map.of("scale", Float.toString(image.scale())));
    }
}
