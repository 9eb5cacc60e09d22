package org.daybreak.scenes.build;

import static org.daybreak.scenes.build.PropertyDefinition.objects;
import static org.daybreak.scenes.build.PropertyDefinition.optional;
import static org.daybreak.scenes.build.PropertyDefinition.value;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.model.ModelReader;
import org.jspecify.annotations.Nullable;

/** The table of all types of objects that scene files may contain. Defaults are those of Mitsuba 3.9. */
public final class Plugins {
    static final int MANY = Integer.MAX_VALUE;
    static final String NO_EFFECT = "Accepted, has no effect.";
    private static final List<PluginDefinition> ALL = all();
    private static final Map<ObjectKind, Map<String, PluginDefinition>> BY_KIND = byKind();

    private Plugins() {}

    /** All types, by kind. */
    public static List<PluginDefinition> list() {
        return ALL;
    }

    /** The types of a kind by name. */
    static Map<String, PluginDefinition> ofKind(ObjectKind kind) {
        return BY_KIND.getOrDefault(kind, Map.of());
    }

    /** A type, or null if there is none of that name. */
    public static @Nullable PluginDefinition find(ObjectKind kind, String type) {
        return ofKind(kind).get(type);
    }

    private static Map<ObjectKind, Map<String, PluginDefinition>> byKind() {
        Map<ObjectKind, Map<String, PluginDefinition>> map = new LinkedHashMap<>();
        for (PluginDefinition p : ALL) {
            map.computeIfAbsent(p.kind(), k -> new LinkedHashMap<>()).put(p.type(), p);
        }
        map.computeIfAbsent(ObjectKind.SCENE, k -> new LinkedHashMap<>()).put(ModelReader.MODEL, model());
        PluginDefinition mesh = ShapePlugins.meshInMemory();
        map.computeIfAbsent(mesh.kind(), k -> new LinkedHashMap<>()).put(mesh.type(), mesh);
        return map;
    }

    /** A type with its properties. */
    static PluginDefinition plugin(ObjectKind kind, String type, String doc, PropertyDefinition... properties) {
        return new PluginDefinition(kind, type, doc, Arrays.asList(properties));
    }

    /** Own properties followed by shared ones. */
    static PropertyDefinition[] join(List<PropertyDefinition> shared, PropertyDefinition... own) {
        List<PropertyDefinition> list = new ArrayList<>(Arrays.asList(own));
        list.addAll(shared);
        return list.toArray(new PropertyDefinition[0]);
    }

    private static List<PluginDefinition> all() {
        List<PluginDefinition> list = new ArrayList<>();
        list.add(scene());
        IntegratorPlugins.addTo(list);
        SensorPlugins.addTo(list);
        FilmPlugins.addTo(list);
        addSamplers(list);
        ShapePlugins.addTo(list);
        BsdfPlugins.addTo(list);
        TexturePlugins.addTo(list);
        EmitterPlugins.addTo(list);
        return Collections.unmodifiableList(list);
    }

    private static PluginDefinition scene() {
        return plugin(
                ObjectKind.SCENE,
                "scene",
                "The root of a file.",
                objects(ObjectKind.INTEGRATOR, 0, 1, "How to render; the path tracer if there is none."),
                objects(ObjectKind.SENSOR, 1, MANY, "The cameras, of which the first is used."),
                objects(ObjectKind.SHAPE, 0, MANY, "Geometry."),
                objects(ObjectKind.EMITTER, 0, MANY, "Lights that are not on a shape."),
                objects(ObjectKind.BSDF, 0, MANY, "Materials to refer to."),
                objects(ObjectKind.TEXTURE, 0, MANY, "Textures to refer to."));
    }

    /** The root of a model's description; scene files do not name it. */
    private static PluginDefinition model() {
        return plugin(
                ObjectKind.SCENE,
                ModelReader.MODEL,
                "A model that may lack camera and light.",
                objects(ObjectKind.SENSOR, 0, MANY, "The cameras, of which the first is used."),
                objects(ObjectKind.SHAPE, 0, MANY, "Geometry."),
                objects(ObjectKind.EMITTER, 0, MANY, "Lights that are not on a shape."),
                objects(ObjectKind.BSDF, 0, MANY, "Materials to refer to."));
    }

    private static void addSamplers(List<PluginDefinition> list) {
        for (String type : List.of("independent", "stratified", "multijitter", "orthogonal", "ldsampler")) {
            list.add(plugin(
                    ObjectKind.SAMPLER,
                    type,
                    "Only the number of samples and the seed are taken; the pattern is an option of the renderer.",
                    value("sample_count", ValueType.INTEGER, "4", "Samples per pixel.")
                            .between(1, Integer.MAX_VALUE),
                    optional("seed", ValueType.INTEGER, "Seed of the random numbers."),
                    optional("jitter", ValueType.BOOLEAN, NO_EFFECT),
                    optional("strength", ValueType.INTEGER, NO_EFFECT)));
        }
    }
}
