package org.daybreak.scenes.gltf;

import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.daybreak.core.render.NearestName;

/** The extensions of glTF that are read. */
final class Extensions {
    static final List<String> SUPPORTED = List.of(
            Instancing.EXTENSION,
            Lights.EXTENSION,
            "KHR_materials_anisotropy",
            "KHR_materials_clearcoat",
            "KHR_materials_emissive_strength",
            "KHR_materials_ior",
            "KHR_materials_sheen",
            "KHR_materials_specular",
            "KHR_materials_transmission",
            "KHR_materials_unlit",
            "KHR_materials_volume",
            "KHR_mesh_quantization",
            Textures.TRANSFORM);

    private Extensions() {}

    /** Reports extensions that are not read: errors for those that the file requires, warnings for others. */
    static void check(JsonValue root, Report report) throws GltfException {
        Set<String> required = new TreeSet<>();
        for (JsonValue name : root.list("extensionsRequired")) {
            required.add(name.text());
            if (!SUPPORTED.contains(name.text())) {
                String shown = JsonValue.quotable(name.text());
                report.error(
                        name,
                        "requires the extension " + shown + ", which is not supported; supported are "
                                + String.join(", ", SUPPORTED) + "; did you mean '"
                                + NearestName.of(shown, SUPPORTED, 1).get(0) + "'?");
            }
        }
        for (JsonValue name : root.list("extensionsUsed")) {
            if (!SUPPORTED.contains(name.text()) && !required.contains(name.text())) {
                report.warning(
                        name, "uses the extension " + JsonValue.quotable(name.text()) + ", which is not supported");
            }
        }
    }
}
