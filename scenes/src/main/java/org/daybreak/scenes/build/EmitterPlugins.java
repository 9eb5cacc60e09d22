package org.daybreak.scenes.build;

import static org.daybreak.scenes.build.Plugins.plugin;
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
                optional("position", ValueType.POINT, "Position; excludes to_world."),
                optional("to_world", ValueType.TRANSFORM, "Light to world."),
                weight));
        list.add(plugin(
                ObjectKind.EMITTER,
                "spot",
                "Spot at the origin that shines along +z; linear fall-off in angle. No texture.",
                value("intensity", ValueType.EMISSION, "1", "Radiant intensity on the axis in W/sr."),
                value("cutoff_angle", ValueType.FLOAT, "20", "Angle from the axis where light ends, in degrees.")
                        .between(1e-3, 180),
                optional(
                                "beam_width",
                                ValueType.FLOAT,
                                "Angle of full intensity in degrees; default 3/4 of cutoff_angle.")
                        .between(0, 180),
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
    }
}
