package org.daybreak.scenes.build;

import static org.daybreak.scenes.build.Plugins.join;
import static org.daybreak.scenes.build.Plugins.plugin;
import static org.daybreak.scenes.build.PropertyDefinition.choice;
import static org.daybreak.scenes.build.PropertyDefinition.objects;
import static org.daybreak.scenes.build.PropertyDefinition.optional;
import static org.daybreak.scenes.build.PropertyDefinition.value;

import java.util.List;
import org.daybreak.scenes.description.ObjectKind;

/** The types of cameras. */
final class SensorPlugins {
    private SensorPlugins() {}

    /** Adds them to the table. */
    static void addTo(List<PluginDefinition> list) {
        List<PropertyDefinition> all = List.of(
                value("near_clip", ValueType.FLOAT, "0.01", "Nothing is clipped; other values give a warning.")
                        .positive(),
                value("far_clip", ValueType.FLOAT, "10000", "Nothing is clipped; default focus distance.")
                        .positive(),
                value("shutter_open", ValueType.FLOAT, "0", Plugins.NO_EFFECT),
                value("shutter_close", ValueType.FLOAT, "0", Plugins.NO_EFFECT),
                objects(ObjectKind.FILM, 0, 1, "The image."),
                objects(ObjectKind.SAMPLER, 0, 1, "Samples per pixel."));
        PropertyDefinition rigid = optional(
                "to_world", ValueType.TRANSFORM, "Camera to world, without scaling; looks along +z, +y is up.");
        PropertyDefinition pixelAspect = value(
                        "pixel_aspect", ValueType.FLOAT, "1", "Width of a pixel over its height; not in Mitsuba.")
                .between(1e-3, 1e3);
        List<PropertyDefinition> common = List.of(join(
                all,
                optional("fov", ValueType.FLOAT, "Opening angle in degrees; excludes focal_length.")
                        .between(1e-4, 179.9999),
                choice(
                        "fov_axis",
                        "x",
                        List.of("x", "y", "diagonal", "smaller", "larger"),
                        "Side of the image that fov refers to."),
                value(
                        "focal_length",
                        ValueType.STRING,
                        "50mm",
                        "Focal length for 35 mm film: fov across the diagonal of 36x24 mm."),
                rigid,
                value(
                                "principal_point_offset_x",
                                ValueType.FLOAT,
                                "0",
                                "Shift of the film to the right against the axis, in film widths.")
                        .between(-100, 100),
                value("principal_point_offset_y", ValueType.FLOAT, "0", "Shift of the film downwards, in film heights.")
                        .between(-100, 100),
                pixelAspect));
        list.add(plugin(
                ObjectKind.SENSOR,
                "perspective",
                "Pinhole camera.",
                join(common, optional("focus_distance", ValueType.FLOAT, Plugins.NO_EFFECT))));
        list.add(plugin(
                ObjectKind.SENSOR,
                "thinlens",
                "Camera with depth of field.",
                join(
                        common,
                        optional(
                                        "aperture_radius",
                                        ValueType.FLOAT,
                                        "Radius of the lens in world units; 0 for a pinhole.")
                                .between(0, Double.MAX_VALUE)
                                .asRequired(),
                        optional("focus_distance", ValueType.FLOAT, "Distance of what is sharp; default far_clip.")
                                .positive())));
        list.add(plugin(
                ObjectKind.SENSOR,
                "orthographic",
                "Parallel rays; the image is 2 units of camera space wide.",
                join(
                        all,
                        optional(
                                "to_world",
                                ValueType.TRANSFORM,
                                "Camera to world; its scale sets the size of the view."),
                        pixelAspect)));
        for (String type : List.of("spherical", "environment")) {
            list.add(plugin(
                    ObjectKind.SENSOR,
                    type,
                    "All directions as an equirectangular panorama, +y up, as envmap takes it.",
                    join(all, rigid)));
        }
    }
}
