package org.daybreak.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.daybreak.core.render.NearestName;
import org.daybreak.exr.Box2i;
import org.daybreak.exr.Chromaticities;
import org.daybreak.exr.ExrAttribute;
import org.daybreak.exr.ExrChannel;
import org.daybreak.exr.ExrHeader;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.daybreak.exr.HdrImage;
import org.daybreak.exr.ImageFileException;
import org.daybreak.exr.Pfm;
import org.daybreak.exr.PfmImage;
import org.daybreak.exr.PixelType;
import org.daybreak.exr.RadianceHdr;
import org.daybreak.exr.SrgbTransfer;
import org.daybreak.exr.V2f;
import org.daybreak.scenes.image.ImageLoader;
import org.daybreak.scenes.image.LoadedImage;
import org.daybreak.scenes.image.StandardImageLoader;

/**
 * An image read from a file. Values are linear: those of formats for display are decoded by the sRGB curve.
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
    private static final List<String> ENDINGS = List.of("exr", "pfm", "hdr", "png", "jpg", "jpeg", "bmp", "gif");

    /** True if a file is an image by its ending. */
    static boolean isImage(Path file) {
        return ENDINGS.contains(ImageLoader.ending(file));
    }

    /** Reads an image file; {@link ExitCode#INPUT} if that cannot be done. */
    static ImageData read(Path file) {
        String ending = ImageLoader.ending(file);
        if (!isImage(file)) {
            throw new CommandException(
                    ExitCode.INPUT, file + ": is no image of a known format" + NearestName.hint(ending, ENDINGS));
        }
        if (!Files.exists(file)) {
            throw new CommandException(ExitCode.INPUT, file + ": there is no such file");
        }
        try {
            return switch (ending) {
                case "exr" -> exr(ExrReader.read(file));
                case "pfm" -> pfm(Pfm.read(file));
                case "hdr" -> hdr(RadianceHdr.read(file));
                default -> display(ending, new StandardImageLoader().load(file));
            };
        } catch (ImageFileException e) {
            throw new CommandException(ExitCode.INPUT, String.valueOf(e.getMessage()), e);
        } catch (IOException e) {
            throw new CommandException(ExitCode.INPUT, file + ": " + e.getMessage(), e);
        }
    }

    private static ImageData exr(ExrImage image) {
        ExrHeader header = image.header();
        Map<String, String> types = new LinkedHashMap<>();
        Map<String, float[]> channels = new LinkedHashMap<>();
        for (ExrChannel channel : header.channels()) {
            types.put(channel.name(), channel.type().name().toLowerCase(Locale.ROOT));
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
        return interleaved(
                image.width(),
                image.height(),
                "PFM",
                "float",
                image.components(),
                image.samples(),
                Map.of("scale", Float.toString(image.scale())));
    }

    private static ImageData hdr(HdrImage image) {
        Map<String, String> attributes = new LinkedHashMap<>();
        attributes.put("colorSpace", image.colorSpace().toString());
        attributes.put("exposure", Double.toString(image.exposure()));
        float[] radiance = new float[image.samples().length];
        for (int i = 0; i < radiance.length; i++) {
            double factor = image.exposure() * image.colorCorrection().get(i % 3);
            radiance[i] = (float) (image.samples()[i] / factor);
        }
        return interleaved(image.width(), image.height(), "Radiance HDR", "rgbe", 3, radiance, attributes);
    }

    private static ImageData display(String ending, LoadedImage image) {
        int channels = image.channels();
        float[] linear;
        String type;
        if (image instanceof LoadedImage.Bytes bytes) {
            type = "8-bit sRGB";
            linear = new float[bytes.samples().length];
            for (int i = 0; i < linear.length; i++) {
                linear[i] = linear(Byte.toUnsignedInt(bytes.samples()[i]) / 255.0, i % channels, channels);
            }
        } else if (image instanceof LoadedImage.Floats floats) {
            type = floats.encoded() ? "16-bit sRGB" : "float";
            linear = floats.samples().clone();
            for (int i = 0; i < linear.length && floats.encoded(); i++) {
                linear[i] = linear(linear[i], i % channels, channels);
            }
        } else {
            throw new IllegalArgumentException("unknown kind of image");
        }
        return interleaved(
                image.width(), image.height(), ending.toUpperCase(Locale.ROOT), type, channels, linear, Map.of());
    }

    /** Decodes a colour; alpha, the second or fourth channel, is linear already. */
    private static float linear(double encoded, int channel, int channels) {
        boolean alpha = channels % 2 == 0 && channel == channels - 1;
        return (float) (alpha ? encoded : SrgbTransfer.decode(encoded));
    }

    private static ImageData interleaved(
            int width,
            int height,
            String format,
            String type,
            int components,
            float[] samples,
            Map<String, String> attributes) {
        List<String> names = switch (components) {
            case 1 -> List.of("Y");
            case 2 -> List.of("Y", "A");
            case 3 -> List.of("R", "G", "B");
            default -> List.of("R", "G", "B", "A");
        };
        Map<String, String> types = new LinkedHashMap<>();
        Map<String, float[]> channels = new LinkedHashMap<>();
        int pixels = width * height;
        for (int c = 0; c < components; c++) {
            float[] plane = new float[pixels];
            for (int i = 0; i < pixels; i++) {
                plane[i] = samples[i * components + c];
            }
            types.put(names.get(c), type);
            channels.put(names.get(c), plane);
        }
        return new ImageData(width, height, format, types, channels, attributes);
    }
}
