package org.daybreak.scenes.build;

import static org.daybreak.scenes.build.PropertyDefinition.choice;
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
    static @Nullable PluginDefinition find(ObjectKind kind, String type) {
        return ofKind(kind).get(type);
    }

    private static Map<ObjectKind, Map<String, PluginDefinition>> byKind() {
        Map<ObjectKind, Map<String, PluginDefinition>> map = new LinkedHashMap<>();
        for (PluginDefinition p : ALL) {
            map.computeIfAbsent(p.kind(), k -> new LinkedHashMap<>()).put(p.type(), p);
        }
        map.computeIfAbsent(ObjectKind.SCENE, k -> new LinkedHashMap<>()).put(ModelReader.MODEL, model());
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
        addIntegrators(list);
        addSensors(list);
        addFilms(list);
        addSamplers(list);
        ShapePlugins.addTo(list);
        BsdfPlugins.addTo(list);
        TexturePlugins.addTo(list);
        addEmitters(list);
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

    /** The root of a model's description; files do not name it. */
    private static PluginDefinition model() {
        return plugin(
                ObjectKind.SCENE,
                ModelReader.MODEL,
                "A model without camera and light.",
                objects(ObjectKind.SHAPE, 0, MANY, "Geometry."),
                objects(ObjectKind.BSDF, 0, MANY, "Materials to refer to."));
    }

    private static void addIntegrators(List<PluginDefinition> list) {
        List<PropertyDefinition> depths = List.of(
                value(
                                "max_depth",
                                ValueType.INTEGER,
                                "-1",
                                "Longest path in edges: 1 shows lights only, 2 direct light; -1 is unlimited.")
                        .between(-1, Integer.MAX_VALUE),
                value("rr_depth", ValueType.INTEGER, "5", "Length from which Russian roulette may end a path.")
                        .between(1, Integer.MAX_VALUE));
        List<PropertyDefinition> common = List.of(
                value("hide_emitters", ValueType.BOOLEAN, "false", "Must be false: lights are always visible."),
                optional("samples_per_pass", ValueType.INTEGER, NO_EFFECT),
                optional("block_size", ValueType.INTEGER, NO_EFFECT));
        list.add(plugin(ObjectKind.INTEGRATOR, "path", "Path tracer: renderer 'path'.", join(common, join(depths))));
        list.add(plugin(
                ObjectKind.INTEGRATOR,
                "direct",
                "Direct light: renderer 'path' with paths of at most 2 edges.",
                join(
                        common,
                        optional("shading_samples", ValueType.INTEGER, NO_EFFECT),
                        optional("emitter_samples", ValueType.INTEGER, NO_EFFECT),
                        optional("bsdf_samples", ValueType.INTEGER, NO_EFFECT))));
        list.add(plugin(
                ObjectKind.INTEGRATOR,
                "ptracer",
                "Particle tracer: renderer 'light'. It cannot show what only specular paths reach.",
                join(common, join(depths))));
    }

    private static void addSensors(List<PluginDefinition> list) {
        List<PropertyDefinition> common = List.of(
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
                optional(
                        "to_world", ValueType.TRANSFORM, "Camera to world, without scaling; looks along +z, +y is up."),
                value("near_clip", ValueType.FLOAT, "0.01", "Nothing is clipped; other values give a warning.")
                        .positive(),
                value("far_clip", ValueType.FLOAT, "10000", "Nothing is clipped; default focus distance.")
                        .positive(),
                value("principal_point_offset_x", ValueType.FLOAT, "0", "Must be 0.")
                        .between(0, 0),
                value("principal_point_offset_y", ValueType.FLOAT, "0", "Must be 0.")
                        .between(0, 0),
                value("shutter_open", ValueType.FLOAT, "0", NO_EFFECT),
                value("shutter_close", ValueType.FLOAT, "0", NO_EFFECT),
                objects(ObjectKind.FILM, 0, 1, "The image."),
                objects(ObjectKind.SAMPLER, 0, 1, "Samples per pixel."));
        list.add(plugin(ObjectKind.SENSOR, "perspective", "Pinhole camera.", join(common)));
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
    }

    private static void addFilms(List<PluginDefinition> list) {
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
                        NO_EFFECT),
                choice("component_format", "float16", List.of("float16", "float32", "uint32"), NO_EFFECT),
                choice("file_format", "openexr", List.of("openexr", "exr", "rgbe", "pfm"), NO_EFFECT),
                optional("sample_border", ValueType.BOOLEAN, NO_EFFECT),
                optional("compensate", ValueType.BOOLEAN, NO_EFFECT),
                optional("banner", ValueType.BOOLEAN, NO_EFFECT),
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

    private static void addEmitters(List<PluginDefinition> list) {
        PropertyDefinition weight = value("sampling_weight", ValueType.FLOAT, "1", "Accepted, has no effect.")
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
