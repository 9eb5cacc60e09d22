package org.daybreak.cli;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
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
            "  bias     mean of image - reference, and in percent of the reference's mean"
        },
        footer = {
            "",
            "Examples:",
            "  daybreak diff picture.exr reference.exr",
            "  daybreak diff --layer albedo a.exr b.exr",
            "  daybreak diff --json a.exr b.pfm"
        })
final class DiffCommand implements Callable<Integer> {
    private final Session session;

    @Parameters(index = "0", paramLabel = "IMAGE", description = "The image.")
    private Path image = Path.of("");

    @Parameters(index = "1", paramLabel = "REFERENCE", description = "What it should be.")
    private Path reference = Path.of("");

    @Option(names = "--layer", paramLabel = "LAYER", description = "Compares this layer; default: the colour.")
    private String layer = "";

    @Option(names = "--json", description = "Prints JSON.")
    private boolean json;

    DiffCommand(Session session) {
        this.session = session;
    }

    @Override
    public Integer call() {
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
        print(results);
        if (all.nonFinite() > 0) {
            session.warning(all.nonFinite() + " values are infinite or not numbers and are left out");
            return ExitCode.NON_FINITE.number();
        }
        return ExitCode.OK.number();
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

    private void print(Map<String, ImageComparison> results) {
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
    }
}
