package org.daybreak.scenes.gltf;

import java.util.HashMap;
import java.util.Map;
import org.daybreak.scenes.description.ObjectDescription;
import org.jspecify.annotations.Nullable;

/**
 * Maps materials to the {@code principled} material of descriptions; how, and where the two differ, is in
 * {@code docs/formats.md}. One that several meshes use is described once and so built once.
 */
final class Materials {
    private final Report report;
    private final Textures textures;
    private final JsonValue defaults;
    private final Map<String, Look> described = new HashMap<>();

    Materials(Container container, Report report, Textures textures) {
        this.report = report;
        this.textures = textures;
        this.defaults = new JsonValue(JsonValue.Kind.OBJECT, container.root(), "materials", 1, 1, 0, "");
    }

    /**
     * How a surface looks.
     *
     * @param bsdf how it scatters light
     * @param emitter what it emits, or null
     */
    record Look(ObjectDescription bsdf, @Nullable ObjectDescription emitter) {}

    /**
     * Describes a material on a mesh.
     *
     * @param material the material, null for the default one
     * @param geometry the mesh: which attributes it has decides what is used of the material
     */
    Look look(@Nullable JsonValue material, Geometry geometry) throws GltfException {
        String key = (material == null ? -1 : material.index()) + " " + (geometry.uv0() != null) + " "
                + (geometry.uv1() != null) + " " + (geometry.colors() != null);
        Look known = described.get(key);
        if (known == null) {
            known = new MaterialWriter(material == null ? defaults : material, geometry, textures, report).look();
            described.put(key, known);
        }
        return known;
    }
}
