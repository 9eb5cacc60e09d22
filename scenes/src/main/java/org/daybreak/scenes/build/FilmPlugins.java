package org.daybreak.scenes.build;

import static org.daybreak.scenes.build.Plugins.plugin;
import static org.daybreak.scenes.build.PropertyDefinition.choice;
import static org.daybreak.scenes.build.PropertyDefinition.objects;
import static org.daybreak.scenes.build.PropertyDefinition.optional;
import static org.daybreak.scenes.build.PropertyDefinition.value;

import java.util.List;
import org.daybreak.scenes.description.ObjectKind;

/** The types of films and their reconstruction filters. */
final class FilmPlugins {
    private FilmPlugins() {}

    /** Adds them to the table. */
    static void addTo(List<PluginDefinition> list) {
        list.add(plugin(
                ObjectKind.FILM,
                "hdrfilm",
                "Image of linear values. Output formats are chosen on the command line.",
                value("width", ValueType.INTEGER, "768", "Width in pixels.").between(1, 65_536),
                value("height", ValueType.INTEGER, "576", "Height in pixels.").between(1, 65_536),
                value("crop_offset_x", ValueType.INTEGER, "0", "First column to render.")
                        .between(0, 65_535),
                value("crop_offset_y", ValueType.INTEGER, "0", "First row to render.")
                        .between(0, 65_535),
                optional("crop_width", ValueType.INTEGER, "Columns to render; default all.")
                        .between(1, 65_536),
                optional("crop_height", ValueType.INTEGER, "Rows to render; default all.")
                        .between(1, 65_536),
                choice(
                        "pixel_format",
                        "rgb",
                        List.of("luminance", "luminance_alpha", "rgb", "rgba", "xyz", "xyza"),
                        Plugins.NO_EFFECT),
                choice("component_format", "float16", List.of("float16", "float32", "uint32"), Plugins.NO_EFFECT),
                choice("file_format", "openexr", List.of("openexr", "exr", "rgbe", "pfm"), Plugins.NO_EFFECT),
                optional("sample_border", ValueType.BOOLEAN, Plugins.NO_EFFECT),
                optional("compensate", ValueType.BOOLEAN, Plugins.NO_EFFECT),
                optional("banner", ValueType.BOOLEAN, Plugins.NO_EFFECT),
                value(
                        "filter_sampling",
                        ValueType.BOOLEAN,
                        "false",
                        "Draws samples in proportion to the filter, each for its own pixel; not in Mitsuba."),
                objects(ObjectKind.RFILTER, 0, 1, "Reconstruction filter; gaussian if there is none.")));
        list.add(plugin(ObjectKind.RFILTER, "box", "Every sample belongs to the pixel it lies in."));
        list.add(plugin(
                ObjectKind.RFILTER,
                "tent",
                "Linear fall-off.",
                value("radius", ValueType.FLOAT, "1", "Half-width in pixels.").between(0.5, 16)));
        list.add(plugin(
                ObjectKind.RFILTER,
                "gaussian",
                "Gaussian, cut at four standard deviations.",
                value("stddev", ValueType.FLOAT, "0.5", "Standard deviation in pixels.")
                        .between(0.125, 4)));
        list.add(plugin(
                ObjectKind.RFILTER,
                "mitchell",
                "Cubic of Mitchell and Netravali, radius 2. C must be (1 - B) / 2.",
                value("B", ValueType.FLOAT, "0.3333333333333333", "First parameter."),
                value("C", ValueType.FLOAT, "0.3333333333333333", "Second parameter.")));
        list.add(plugin(ObjectKind.RFILTER, "catmullrom", "Catmull-Rom cubic: mitchell with B = 0, C = 1/2."));
        list.add(plugin(
                ObjectKind.RFILTER,
                "lanczos",
                "Windowed sinc.",
                value("lobes", ValueType.INTEGER, "3", "Number of lobes, the radius in pixels.")
                        .between(1, 16)));
        list.add(plugin(
                ObjectKind.RFILTER,
                "blackmanharris",
                "Window of Blackman and Harris; not in Mitsuba.",
                value("radius", ValueType.FLOAT, "1.5", "Half-width in pixels.").between(0.5, 16)));
    }
}
