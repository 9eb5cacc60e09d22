package org.daybreak.scenes.build;

import static org.daybreak.scenes.build.Plugins.join;
import static org.daybreak.scenes.build.Plugins.plugin;
import static org.daybreak.scenes.build.PropertyDefinition.choice;
import static org.daybreak.scenes.build.PropertyDefinition.optional;
import static org.daybreak.scenes.build.PropertyDefinition.value;

import java.util.List;
import org.daybreak.scenes.description.ObjectKind;

/** The types of lights. */
final class EmitterPlugins {
    private EmitterPlugins() {}

    /** Adds them to the table. */
    static void addTo(List<PluginDefinition> list) {
        PropertyDefinition weight = value("sampling_weight", ValueType.FLOAT, "1", Plugins.NO_EFFECT)
                .between(0, Double.MAX_VALUE);
        list.add(plugin(
                ObjectKind.EMITTER,
                "area",
                "Makes the shape it stands in a light, on its front.",
                value("radiance", ValueType.TEXTURED_EMISSION, "1", "Radiance in W/(m² sr)."),
                weight));
        list.add(plugin(
                ObjectKind.EMITTER,
                "point",
                "Point light.",
                value("intensity", ValueType.EMISSION, "1", "Radiant intensity in W/sr."),
                optional(
                        "ies",
                        ValueType.FILE,
                        "IES file of a luminaire with its axis along +z; intensity is then a factor on its candela / 683."),
                optional("position", ValueType.POINT, "Position; excludes to_world."),
                optional("to_world", ValueType.TRANSFORM, "Light to world."),
                weight));
        list.add(plugin(
                ObjectKind.EMITTER,
                "spot",
                "Spot at the origin that shines along +z; linear fall-off in angle.",
                value("intensity", ValueType.EMISSION, "1", "Radiant intensity on the axis in W/sr."),
                value("cutoff_angle", ValueType.FLOAT, "20", "Angle from the axis where light ends, in degrees.")
                        .between(1e-3, 180),
                optional(
                                "beam_width",
                                ValueType.FLOAT,
                                "Angle of full intensity in degrees; default 3/4 of cutoff_angle.")
                        .between(0, 180),
                value(
                        "texture",
                        ValueType.TEXTURED_EMISSION,
                        "1",
                        "Projected factor on the intensity; needs a cutoff_angle below 90."),
                optional("to_world", ValueType.TRANSFORM, "Light to world."),
                weight));
        list.add(plugin(
                ObjectKind.EMITTER,
                "directional",
                "Parallel light from infinity along +z.",
                value("irradiance", ValueType.EMISSION, "1", "Irradiance of a surface that faces it in W/m²."),
                optional("direction", ValueType.POINT, "Direction of travel; excludes to_world."),
                optional("to_world", ValueType.TRANSFORM, "Light to world."),
                weight));
        list.add(plugin(
                ObjectKind.EMITTER,
                "constant",
                "The same radiance from all directions.",
                value("radiance", ValueType.EMISSION, "1", "Radiance in W/(m² sr)."),
                weight));
        list.add(plugin(
                ObjectKind.EMITTER,
                "envmap",
                "Equirectangular image around the scene, +y up.",
                optional("filename", ValueType.FILE, "The file.").asRequired(),
                value("scale", ValueType.FLOAT, "1", "Factor on the image.").between(0, Double.MAX_VALUE),
                optional("to_world", ValueType.TRANSFORM, "Image to world."),
                weight));
        addSkies(list, weight);
    }

    private static void addSkies(List<PluginDefinition> list, PropertyDefinition weight) {
        List<PropertyDefinition> common = List.of(
                value("turbidity", ValueType.FLOAT, "3", "Haze: 1 for pure air; 1.7 at least for preetham.")
                        .between(1, 10),
                value("albedo", ValueType.COLOR, "0.3", "Albedo of the ground; not used by preetham.")
                        .between(0, 1),
                optional(
                        "sun_direction",
                        ValueType.POINT,
                        "Direction to the sun in the world; excludes date and place."),
                value("year", ValueType.INTEGER, "2010", "Year.").between(1900, 2100),
                value("month", ValueType.INTEGER, "7", "Month.").between(1, 12),
                value("day", ValueType.INTEGER, "10", "Day of the month.").between(1, 31),
                value("hour", ValueType.FLOAT, "15", "Local time: hours.").between(0, 24),
                value("minute", ValueType.FLOAT, "0", "Local time: minutes.").between(0, 60),
                value("second", ValueType.FLOAT, "0", "Local time: seconds.").between(0, 60),
                value("latitude", ValueType.FLOAT, "35.6894", "Degrees to the north.")
                        .between(-90, 90),
                value("longitude", ValueType.FLOAT, "139.6917", "Degrees to the east.")
                        .between(-180, 180),
                value("timezone", ValueType.FLOAT, "9", "Hours that local time is ahead of universal time.")
                        .between(-14, 14),
                optional("to_world", ValueType.TRANSFORM, "Sky to world; +z is up, +x south, +y west."),
                weight);
        PropertyDefinition skyScale = value("sky_scale", ValueType.FLOAT, "1", "Factor on the sky; 0 for none.")
                .between(0, Double.MAX_VALUE);
        PropertyDefinition model = choice(
                "model", "hosek_wilkie", List.of("hosek_wilkie", "preetham"), "Model of the sky; not in Mitsuba.");
        List<PropertyDefinition> sun = List.of(
                value("sun_scale", ValueType.FLOAT, "1", "Factor on the sun; 0 for none.")
                        .between(0, Double.MAX_VALUE),
                value("sun_aperture", ValueType.FLOAT, "0.5358", "Angular diameter of the sun in degrees.")
                        .between(1e-3, 179),
                value("complex_sun", ValueType.BOOLEAN, "false", "Must be false: the disk has one radiance."));
        list.add(plugin(
                ObjectKind.EMITTER,
                "sunsky",
                "Clear sky with the sun, +z up.",
                join(common, join(sun, skyScale, model))));
        list.add(plugin(ObjectKind.EMITTER, "sky", "Clear sky without the sun, +z up.", join(common, skyScale, model)));
        list.add(plugin(ObjectKind.EMITTER, "sun", "The sun of a clear sky, +z up.", join(common, join(sun))));
    }
}
