package org.daybreak.cli;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.render.NearestName;
import org.daybreak.exr.Box2i;
import org.daybreak.exr.Chromaticities;
import org.daybreak.exr.ExrAttribute;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrWriter;
import org.daybreak.exr.HdrImage;
import org.daybreak.exr.ImageFileException;
import org.daybreak.exr.Pfm;
import org.daybreak.exr.PfmImage;
import org.daybreak.exr.PixelType;
import org.daybreak.exr.PngWriter;
import org.daybreak.exr.RadianceHdr;
import org.jspecify.annotations.Nullable;

/**
 * An image file to be written.
 *
 * @param path where
 * @param format how
 */
record OutputFile(Path path, Format format) {
    /** Below the largest value of Radiance HDR. */
    private static final float LARGEST_HDR = 0x1p126f;

    /** Formats of images that are written, known by the ending of the file name. */
    enum Format {
        /** OpenEXR. */
        EXR("OpenEXR: linear 32-bit floats, layers and attributes; compression ZIP"),
        /** Portable float map. */
        PFM("Portable float map: linear 32-bit floats, colour only"),
        /** PNG. */
        PNG("8-bit sRGB for display, clamped; colour only"),
        /** Radiance HDR. */
        HDR("Radiance HDR: linear, shared exponents of 8 bits, no negative values; colour only"),
        /** JPEG. */
        JPG("8-bit sRGB for display, clamped, quality 0.95; colour only", "jpeg"),
        /** The film itself. */
        DAYBREAK("Partial film: all that the render has accumulated, for merge and --resume");

        private final String doc;
        /** Another ending that names the format, or null. */
        private final @Nullable String otherEnding;

        Format(String doc) {
            this(doc, null);
        }

        Format(String doc, @Nullable String otherEnding) {
            this.doc = doc;
            this.otherEnding = otherEnding;
        }

        /** The ending of file names. */
        String ending() {
            return name().toLowerCase(Locale.ROOT);
        }

        /** What is written. */
        String doc() {
            return doc;
        }
    }

    /** The output of a file name; {@link ExitCode#USAGE} if its ending is unknown. */
    static OutputFile of(Path path) {
        Path last = path.getFileName();
        String name = last == null ? "" : last.toString();
        String ending = name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
        List<String> endings = new ArrayList<>();
        for (Format format : Format.values()) {
            boolean known = format.ending().equals(ending) || ending.equals(format.otherEnding);
            if (known && name.indexOf('.') >= 0) {
                return new OutputFile(path, format);
            }
            endings.add(format.ending());
        }
        String what = name.indexOf('.') < 0 ? "has no ending" : "has the unknown ending '" + ending + "'";
        throw new CommandException(
                ExitCode.USAGE, "output file '" + path + "' " + what + NearestName.hint(ending, endings));
    }

    /**
     * Checks that files can be written before hours are spent on their content; {@link ExitCode#USAGE} if two are the same,
     * {@link ExitCode#OUTPUT} if one cannot be written.
     */
    static void checkWritable(List<Path> files) {
        Set<Path> seen = new HashSet<>();
        for (Path file : files) {
            Path place = file.toAbsolutePath().normalize();
            if (!seen.add(place)) {
                throw new CommandException(ExitCode.USAGE, "output file '" + file + "' is given twice");
            }
            String problem = problem(place);
            if (problem != null) {
                throw new CommandException(ExitCode.OUTPUT, file + ": cannot be written: " + problem);
            }
        }
    }

    private static @org.jspecify.annotations.Nullable String problem(Path place) {
        if (Files.isDirectory(place)) {
            return "is a directory";
        }
        if (Files.exists(place) && !Files.isRegularFile(place)) {
            return "is not a regular file";
        }
        Path folder = place.getParent();
        if (folder == null || !Files.isDirectory(folder)) {
            return "there is no directory " + folder;
        }
        if (!Files.isWritable(folder)) {
            return "the directory " + folder + " is not writable";
        }
        return null;
    }

    /**
     * Writes an image, in any format but {@link Format#DAYBREAK}: all of it under its name, or nothing.
     *
     * @param attributes texts and numbers on how the image was made; only OpenEXR keeps them
     * @throws ImageFileException if that fails
     */
    void write(FilmImage image, java.util.Map<String, ExrAttribute> attributes) throws ImageFileException {
        switch (format) {
            case EXR -> ExrWriter.write(path, exr(image.settings(), image.channels(), attributes));
            case DAYBREAK -> throw new IllegalArgumentException("a partial film is no image");
            default ->
                writeColor(
                        image.width(),
                        image.height(),
                        List.of(image.channel("R"), image.channel("G"), image.channel("B")));
        }
    }

    /**
     * Writes a colour image in a format that holds nothing else.
     *
     * @param planes linear red, green and blue, or grey; rows from the top
     * @throws ImageFileException if that fails
     */
    void writeColor(int width, int height, List<float[]> planes) throws ImageFileException {
        if (format == Format.PFM) {
            Pfm.write(path, new PfmImage(width, height, planes.size(), interleaved(planes)));
            return;
        }
        float[] rgb = interleaved(planes.size() == 1 ? Collections.nCopies(3, planes.get(0)) : planes);
        switch (format) {
            case PNG -> PngWriter.write(path, width, height, rgb);
            case JPG -> JpegWriter.write(path, width, height, rgb);
            case HDR -> RadianceHdr.write(path, new HdrImage(width, height, notNegative(rgb)));
            default -> throw new IllegalArgumentException(format + " holds more than colour");
        }
    }

    /** The format has neither negative values nor infinite ones. */
    private static float[] notNegative(float[] rgb) {
        float[] values = new float[rgb.length];
        for (int i = 0; i < rgb.length; i++) {
            values[i] = rgb[i] > 0 ? Math.min(rgb[i], LARGEST_HDR) : 0;
        }
        return values;
    }

    /**
     * An OpenEXR image of floats.
     *
     * @param film the film; its crop is the data window
     * @param channels values of the crop by the names of the channels, rows from the top
     */
    static ExrImage exr(
            FilmSettings film,
            java.util.Map<String, float[]> channels,
            java.util.Map<String, ExrAttribute> attributes) {
        ExrImage.Builder builder = ExrImage.builder(
                        film.crop().width(), film.crop().height())
                .dataWindowOrigin(film.crop().x(), film.crop().y())
                .displayWindow(Box2i.ofSize(film.width(), film.height()))
                .attribute("chromaticities", new ExrAttribute.ChromaticitiesValue(Chromaticities.REC_709))
                .attributes(attributes);
        channels.forEach((name, samples) -> builder.channel(name, PixelType.FLOAT, samples));
        return builder.build();
    }

    private static float[] interleaved(List<float[]> planes) {
        int components = planes.size();
        int pixels = planes.get(0).length;
        float[] samples = new float[components * pixels];
        for (int c = 0; c < components; c++) {
            float[] plane = planes.get(c);
            for (int i = 0; i < pixels; i++) {
                samples[components * i + c] = plane[i];
            }
        }
        return samples;
    }
}
