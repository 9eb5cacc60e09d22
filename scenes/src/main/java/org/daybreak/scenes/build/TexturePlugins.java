package org.daybreak.scenes.build;

import static org.daybreak.scenes.build.Plugins.NO_EFFECT;
import static org.daybreak.scenes.build.Plugins.plugin;
import static org.daybreak.scenes.build.PropertyDefinition.choice;
import static org.daybreak.scenes.build.PropertyDefinition.objects;
import static org.daybreak.scenes.build.PropertyDefinition.optional;
import static org.daybreak.scenes.build.PropertyDefinition.value;

import java.util.List;
import org.daybreak.scenes.description.ObjectKind;

/** The textures that scene files may contain. Names and defaults are those of Mitsuba 3.9 where it has the same. */
final class TexturePlugins {
    private TexturePlugins() {}

    /** Appends all textures. */
    static void addTo(List<PluginDefinition> list) {
        PropertyDefinition toUv =
                optional("to_uv", ValueType.TRANSFORM, "Applied to texture coordinates; x, y and translation count.");
        list.add(plugin(
                ObjectKind.TEXTURE,
                "bitmap",
                "Image file; its first row is at v = 0. Alpha is dropped unless it is the channel.",
                optional("filename", ValueType.FILE, "The file.").asRequired(),
                choice("filter_type", "bilinear", List.of("bilinear", "nearest"), "Interpolation."),
                choice("wrap_mode", "repeat", List.of("repeat", "mirror", "clamp"), "What lies outside the image."),
                choice(
                        "wrap_mode_v",
                        null,
                        List.of("repeat", "mirror", "clamp"),
                        "What lies above and below it; default wrap_mode. Not in Mitsuba."),
                value("raw", ValueType.BOOLEAN, "false", "Takes values of 8 and 16 bits as linear instead of sRGB."),
                toUv,
                choice(
                        "channel",
                        "all",
                        List.of("all", "r", "g", "b", "a", "opacity"),
                        "Takes one channel as a grey image; opacity is a, or 1 where there is none. Not in Mitsuba."),
                value("uv_set", ValueType.INTEGER, "0", "1 for the second texture coordinates; not in Mitsuba.")
                        .between(0, 1),
                optional("format", ValueType.STRING, NO_EFFECT),
                optional("accel", ValueType.BOOLEAN, NO_EFFECT)));
        list.add(plugin(
                ObjectKind.TEXTURE,
                "checkerboard",
                "Four squares per unit of texture space.",
                value("color0", ValueType.TEXTURED_EMISSION, "0.4", "Colour of the square at (0, 0)."),
                value("color1", ValueType.TEXTURED_EMISSION, "0.2", "The other colour."),
                toUv));
        list.add(plugin(
                ObjectKind.TEXTURE,
                "mesh_attribute",
                "Colours of the vertices of a mesh, white on shapes without.",
                value("name", ValueType.STRING, "vertex_color", "Must be 'vertex_color'."),
                value("scale", ValueType.FLOAT, "1", "Factor on the colours.").between(0, Double.MAX_VALUE)));
        list.add(plugin(
                ObjectKind.TEXTURE,
                "scaled",
                "A texture times a colour; not in Mitsuba.",
                value("scale", ValueType.EMISSION, "1", "The factor."),
                objects(ObjectKind.TEXTURE, 1, 1, "The texture.")));
        list.add(plugin(
                ObjectKind.TEXTURE,
                "product",
                "Product of two textures, component by component; not in Mitsuba.",
                value("first", ValueType.TEXTURED_EMISSION, "1", "The one factor."),
                value("second", ValueType.TEXTURED_EMISSION, "1", "The other factor.")));
        list.add(plugin(
                ObjectKind.TEXTURE,
                "threshold",
                "1 where a texture reaches a cutoff, 0 elsewhere: for cut-out shapes; not in Mitsuba.",
                value("value", ValueType.TEXTURED_EMISSION, "1", "The texture; of colours the luminance counts."),
                value("cutoff", ValueType.FLOAT, "0.5", "Smallest value that gives 1.")));
    }
}
