package org.daybreak.scenes.gltf;

import java.util.List;
import javax.vecmath.Matrix4d;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.Value;
import org.jspecify.annotations.Nullable;

/**
 * Lights of KHR_lights_punctual. One lumen counts as one watt, as do the nits of emissive materials, so that the balance of all
 * lights in a file is kept: candela are W/sr, lux are W/m².
 */
final class Lights {
    static final String EXTENSION = "KHR_lights_punctual";
    private static final List<String> TYPES = List.of("directional", "point", "spot");

    private final Container container;
    private final Report report;

    Lights(Container container, Report report) {
        this.container = container;
        this.report = report;
    }

    /** The light of a node, or null if it has none or it is dark. */
    @Nullable
    ObjectDescription light(JsonValue node, Matrix4d world) throws GltfException {
        JsonValue use = node.extension(EXTENSION);
        if (use == null) {
            return null;
        }
        JsonValue reference = use.get("light");
        JsonValue definitions = container.root().extension(EXTENSION);
        List<JsonValue> all = definitions == null ? List.of() : definitions.list("lights");
        int index = reference.integer(0, Integer.MAX_VALUE);
        if (index >= all.size()) {
            throw reference.error("refers to light " + index + " but there are " + all.size());
        }
        JsonValue light = all.get(index);
        String type = light.get("type").text();
        if (!TYPES.contains(type)) {
            light.choice("type", "", TYPES);
        }
        double[] color = light.numbersBetween("color", 0, Double.MAX_VALUE, 1, 1, 1);
        double intensity = light.number("intensity", 1, 0, Double.MAX_VALUE);
        if (light.find("range") != null) {
            report.warning(light.get("range"), "is ignored: light falls off with the square of the distance");
        }
        ObjectBuilder builder = new ObjectBuilder(ObjectKind.EMITTER, type, report.location(light));
        builder.value(
                type.equals("directional") ? "irradiance" : "intensity",
                new Value.Color(color[0] * intensity, color[1] * intensity, color[2] * intensity));
        builder.transform("to_world", Frames.rigid(world, node));
        if (type.equals("spot")) {
            cone(light.find("spot"), builder);
        }
        return intensity > 0 ? builder.build() : null;
    }

    private static void cone(@Nullable JsonValue spot, ObjectBuilder builder) throws GltfException {
        double outer =
                spot == null ? Math.PI / 4 : spot.number("outerConeAngle", Math.PI / 4, 1e-4, Math.PI / 2 + 1e-6);
        double inner = spot == null ? 0 : spot.number("innerConeAngle", 0, 0, Math.PI / 2);
        if (spot != null && inner >= outer) {
            throw spot.error("must have an innerConeAngle below outerConeAngle, " + outer + ", but it is " + inner);
        }
        builder.number("cutoff_angle", Math.toDegrees(outer)).number("beam_width", Math.toDegrees(inner));
    }
}
