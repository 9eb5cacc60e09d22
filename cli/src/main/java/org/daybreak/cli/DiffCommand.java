package org.daybreak.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import org.daybreak.cli.flip.Flip;
import org.daybreak.core.render.NearestName;
import org.daybreak.exr.ImageFileException;
import org.daybreak.scenes.image.ImageLoader;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code daybreak diff}: the difference of an image from a reference in figures. */
@Command(
        name = "diff",
        description = {
            "Compares an image with a reference (exr or pfm).",
            "Prints, for each colour channel that both have and for all of them together:",
            "  rmse     root of the mean squared difference",
            "  relmse   mean of d^2 / (reference^2 + 0.01)",
            "  bias     mean of image - reference, and in percent of the reference's mean",
            "With --flip also the mean of FLIP, the visible difference, from 0 to 1."
        },
        footer = {
            "",
            "Examples:",
            "  daybreak diff picture.exr reference.exr",
            "  daybreak diff --layer albedo a.exr b.exr",
            "  daybreak diff --flip hdr --false-color flip.png picture.exr reference.exr",
            "  daybreak diff --json a.exr b.pfm"
        })
final class DiffCommand implements Callable<Integer> {
    private static final String NO_FLIP = "none";

    private final Session session;

    @Parameters(index = "0", paramLabel = "IMAGE", description = "The image.")
    private Path image = Path.of("");

    @Parameters(index = "1", paramLabel = "REFERENCE", description = "What it should be.")
    private Path reference = Path.of("");

    @Option(names = "--layer", paramLabel = "LAYER", description = "Compares this layer; default: the colour.")
    private String layer = "";

    @Option(
            names = "--flip",
            paramLabel = "MODE",
            description = "Computes FLIP: hdr over a range of exposures, ldr as a display shows the image; none.")
    private @Nullable String flip;

    @Option(
            names = "--false-color",
            paramLabel = "FILE",
            description =
                    "Writes the FLIP error of each pixel as PNG, black for none to pale yellow; default mode: hdr.")
    private @Nullable Path falseColor;

    @Option(names = "--json", description = "Prints JSON.")
    private boolean json;

    DiffCommand(Session session) {
        this.session = session;
    }

    @Override
    public Integer call() {
        String mode = flipMode();
        ImageData a = ImageData.read(image);
        ImageData b = ImageData.read(reference);
        if (a.width() != b.width() || a.height() != b.height()) {
            throw new CommandException(
                    ExitCode.DIFFERENT,
                    String.format(
                            Locale.ROOT,
                            "the images differ in size: %s has %dx%d pixels, %s has %dx%d",
                            image,
                            a.width(),
                            a.height(),
                            reference,
                            b.width(),
                            b.height()));
        }
        Map<String, ImageComparison> results = compare(a, b);
        ImageComparison all = results.get("all");
        if (all == null) {
            throw new CommandException(
                    ExitCode.DIFFERENT,
                    "the images have no channel in common" + (layer.isEmpty() ? "" : " in the layer '" + layer + "'")
                            + ": " + image + " has "
                            + String.join(", ", a.channels().keySet()) + "; " + reference
                            + " has " + String.join(", ", b.channels().keySet()));
        }
        float[] error = mode.equals(NO_FLIP) ? null : flipError(mode, a, b);
        double meanError = error == null ? Double.NaN : mean(error);
        print(results, error == null ? null : meanError);
        if (error != null && falseColor != null) {
            try {
                FalseColor.write(falseColor, a.width(), a.height(), error);
            } catch (ImageFileException e) {
                throw new CommandException(ExitCode.OUTPUT, String.valueOf(e.getMessage()), e);
            }
        }
        if (all.nonFinite() > 0) {
            session.warning(all.nonFinite() + " values are infinite or not numbers and are left out");
            return ExitCode.NON_FINITE.number();
        }
        return ExitCode.OK.number();
    }

    /** The mode of FLIP; {@link ExitCode#USAGE} if there is none of that name. */
    private String flipMode() {
        List<String> modes = List.of("hdr", "ldr", NO_FLIP);
        String mode = flip != null ? flip : falseColor != null ? "hdr" : NO_FLIP;
        if (!modes.contains(mode)) {
            throw new CommandException(
                    ExitCode.USAGE, "there is no mode of FLIP '" + mode + "'" + NearestName.hint(mode, modes));
        }
        if (falseColor != null) {
            if (mode.equals(NO_FLIP)) {
                throw new CommandException(ExitCode.USAGE, "--false-color shows FLIP and needs --flip hdr or ldr");
            }
            if (!ImageLoader.ending(falseColor).equals("png")) {
                throw new CommandException(ExitCode.USAGE, "--false-color writes a file with the ending png");
            }
            OutputFile.checkWritable(List.of(falseColor));
        }
        return mode;
    }

    private float[] flipError(String mode, ImageData a, ImageData b) {
        Flip metric = new Flip(a.width(), a.height(), Flip.DEFAULT_PIXELS_PER_DEGREE);
        float[] own = color(image, a);
        float[] other = color(reference, b);
        return mode.equals("ldr") ? metric.displayError(own, other) : metric.highDynamicRangeError(own, other);
    }

    /** Red, green and blue of the layer, interleaved; values that are no numbers are black. */
    private float[] color(Path file, ImageData data) {
        String prefix = layer.isEmpty() ? "" : layer + ".";
        float[] rgb = new float[3 * data.width() * data.height()];
        for (int c = 0; c < 3; c++) {
            float[] samples = data.channels().get(prefix + "RGB".charAt(c));
            if (samples == null) {
                throw new CommandException(
                        ExitCode.DIFFERENT,
                        "FLIP compares colours, but " + file + " has no " + prefix + "RGB".charAt(c));
            }
            for (int p = 0; p < samples.length; p++) {
                rgb[3 * p + c] = Float.isFinite(samples[p]) ? samples[p] : 0;
            }
        }
        return rgb;
    }

    private static double mean(float[] values) {
        double sum = 0;
        for (float value : values) {
            sum += value;
        }
        return sum / values.length;
    }

    /** By channel, and under {@code all} the sum of them; empty if there is no channel in common. */
    private Map<String, ImageComparison> compare(ImageData a, ImageData b) {
        Map<String, ImageComparison> results = new LinkedHashMap<>();
        ImageComparison all = new ImageComparison();
        for (String channel : colorsFirst(a.channels().keySet())) {
            float[] other = b.channels().get(channel);
            float[] own = a.channels().get(channel);
            if (other != null && own != null) {
                ImageComparison one = new ImageComparison();
                one.add(own, other);
                all.add(own, other);
                results.put(channel, one);
            }
        }
        if (!results.isEmpty()) {
            results.put("all", all);
        }
        return results;
    }

    /** The channels of the layer; alpha is no part of a picture's error. */
    private List<String> colorsFirst(Iterable<String> channels) {
        List<String> chosen = new ArrayList<>();
        for (String color : new String[] {"R", "G", "B"}) {
            chosen.add(layer.isEmpty() ? color : layer + "." + color);
        }
        for (String channel : channels) {
            int dot = channel.lastIndexOf('.');
            boolean inLayer = layer.equals(dot < 0 ? "" : channel.substring(0, dot));
            if (inLayer
                    && !chosen.contains(channel)
                    && !channel.substring(dot + 1).equals("A")) {
                chosen.add(channel);
            }
        }
        return chosen;
    }

    private void print(Map<String, ImageComparison> results, @Nullable Double flipMean) {
        if (json) {
            Map<String, Object> document = new LinkedHashMap<>();
            results.forEach((name, result) -> {
                Map<String, Object> values = new LinkedHashMap<>();
                values.put("rmse", result.rmse());
                values.put("relmse", result.relMse());
                values.put("bias", result.bias());
                values.put("relativeBias", result.relativeBias());
                values.put("nonFinite", result.nonFinite());
                document.put(name, values);
            });
            if (flipMean != null) {
                document.put("flip", flipMean);
            }
            session.out().print(JsonText.document(document));
            return;
        }
        session.out().printf(Locale.ROOT, "%-12s %12s %12s %13s %10s%n", "channel", "rmse", "relmse", "bias", "bias %");
        results.forEach((name, r) -> session.out()
                .printf(
                        Locale.ROOT,
                        "%-12s %12.5e %12.5e %+13.5e %+10.4f%n",
                        name,
                        r.rmse(),
                        r.relMse(),
                        r.bias(),
                        100 * r.relativeBias()));
        if (flipMean != null) {
            session.out().printf(Locale.ROOT, "%-12s %12.6f%n", "flip", flipMean);
        }
    }
}
