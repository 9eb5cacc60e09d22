package org.daybreak.scenes.build;

import static org.daybreak.scenes.build.PropertyDefinition.choice;
import static org.daybreak.scenes.build.PropertyDefinition.objects;
import static org.daybreak.scenes.build.PropertyDefinition.of;
import static org.daybreak.scenes.build.PropertyDefinition.optional;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.daybreak.scenes.build.PropertyDefinition.Type;
import org.daybreak.scenes.description.ObjectKind;
import org.jspecify.annotations.Nullable;

/** The table of all types of objects that scene files may contain. Defaults are those of Mitsuba 3.9. */
public final class Plugins {
    private static final int MANY = Integer.MAX_VALUE;
    private static final String NO_EFFECT = "Accepted, has no effect.";
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
        return map;
    }

    private static PluginDefinition plugin(ObjectKind kind, String type, String doc, PropertyDefinition... properties) {
        return new PluginDefinition(kind, type, doc, Arrays.asList(properties));
    }

    private static PropertyDefinition[] join(List<PropertyDefinition> shared, PropertyDefinition... own) {
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
        addShapes(list);
        addBsdfs(list);
        addTextures(list);
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

    private static void addIntegrators(List<PluginDefinition> list) {
        List<PropertyDefinition> depths = List.of(
                of(
                                "max_depth",
                                Type.INTEGER,
                                "-1",
                                "Longest path in edges: 1 shows lights only, 2 direct light; -1 is unlimited.")
                        .between(-1, Integer.MAX_VALUE),
                of("rr_depth", Type.INTEGER, "5", "Length from which Russian roulette may end a path.")
                        .between(1, Integer.MAX_VALUE));
        List<PropertyDefinition> common = List.of(
                of("hide_emitters", Type.BOOLEAN, "false", "Must be false: lights are always visible."),
                optional("samples_per_pass", Type.INTEGER, NO_EFFECT),
                optional("block_size", Type.INTEGER, NO_EFFECT));
        list.add(plugin(ObjectKind.INTEGRATOR, "path", "Path tracer: renderer 'path'.", join(common, join(depths))));
        list.add(plugin(
                ObjectKind.INTEGRATOR,
                "direct",
                "Direct light: renderer 'path' with paths of at most 2 edges.",
                join(
                        common,
                        optional("shading_samples", Type.INTEGER, NO_EFFECT),
                        optional("emitter_samples", Type.INTEGER, NO_EFFECT),
                        optional("bsdf_samples", Type.INTEGER, NO_EFFECT))));
        list.add(plugin(
                ObjectKind.INTEGRATOR,
                "ptracer",
                "Particle tracer: renderer 'light'. It cannot show what only specular paths reach.",
                join(common, join(depths))));
    }

    private static void addSensors(List<PluginDefinition> list) {
        List<PropertyDefinition> common = List.of(
                optional("fov", Type.FLOAT, "Opening angle in degrees; excludes focal_length.")
                        .between(1e-4, 179.9999),
                choice(
                        "fov_axis",
                        "x",
                        List.of("x", "y", "diagonal", "smaller", "larger"),
                        "Side of the image that fov refers to."),
                of(
                        "focal_length",
                        Type.STRING,
                        "50mm",
                        "Focal length for 35 mm film: fov across the diagonal of 36x24 mm."),
                optional("to_world", Type.TRANSFORM, "Camera to world, without scaling; looks along +z, +y is up."),
                of("near_clip", Type.FLOAT, "0.01", "Nothing is clipped; other values give a warning.")
                        .positive(),
                of("far_clip", Type.FLOAT, "10000", "Nothing is clipped; default focus distance.")
                        .positive(),
                of("principal_point_offset_x", Type.FLOAT, "0", "Must be 0.").between(0, 0),
                of("principal_point_offset_y", Type.FLOAT, "0", "Must be 0.").between(0, 0),
                of("shutter_open", Type.FLOAT, "0", NO_EFFECT),
                of("shutter_close", Type.FLOAT, "0", NO_EFFECT),
                objects(ObjectKind.FILM, 0, 1, "The image."),
                objects(ObjectKind.SAMPLER, 0, 1, "Samples per pixel."));
        list.add(plugin(ObjectKind.SENSOR, "perspective", "Pinhole camera.", join(common)));
        list.add(plugin(
                ObjectKind.SENSOR,
                "thinlens",
                "Camera with depth of field.",
                join(
                        common,
                        optional("aperture_radius", Type.FLOAT, "Radius of the lens in world units; 0 for a pinhole.")
                                .between(0, Double.MAX_VALUE)
                                .asRequired(),
                        optional("focus_distance", Type.FLOAT, "Distance of what is sharp; default far_clip.")
                                .positive())));
    }

    private static void addFilms(List<PluginDefinition> list) {
        list.add(plugin(
                ObjectKind.FILM,
                "hdrfilm",
                "Image of linear values. Output formats are chosen on the command line.",
                of("width", Type.INTEGER, "768", "Width in pixels.").between(1, 65_536),
                of("height", Type.INTEGER, "576", "Height in pixels.").between(1, 65_536),
                of("crop_offset_x", Type.INTEGER, "0", "First column to render.")
                        .between(0, 65_535),
                of("crop_offset_y", Type.INTEGER, "0", "First row to render.").between(0, 65_535),
                optional("crop_width", Type.INTEGER, "Columns to render; default all.")
                        .between(1, 65_536),
                optional("crop_height", Type.INTEGER, "Rows to render; default all.")
                        .between(1, 65_536),
                choice(
                        "pixel_format",
                        "rgb",
                        List.of("luminance", "luminance_alpha", "rgb", "rgba", "xyz", "xyza"),
                        NO_EFFECT),
                choice("component_format", "float16", List.of("float16", "float32", "uint32"), NO_EFFECT),
                choice("file_format", "openexr", List.of("openexr", "exr", "rgbe", "pfm"), NO_EFFECT),
                optional("sample_border", Type.BOOLEAN, NO_EFFECT),
                optional("compensate", Type.BOOLEAN, NO_EFFECT),
                optional("banner", Type.BOOLEAN, NO_EFFECT),
                objects(ObjectKind.RFILTER, 0, 1, "Reconstruction filter; gaussian if there is none.")));
        list.add(plugin(ObjectKind.RFILTER, "box", "Every sample belongs to the pixel it lies in."));
        list.add(plugin(
                ObjectKind.RFILTER,
                "tent",
                "Linear fall-off.",
                of("radius", Type.FLOAT, "1", "Half-width in pixels.").between(0.5, 16)));
        list.add(plugin(
                ObjectKind.RFILTER,
                "gaussian",
                "Gaussian, cut at four standard deviations.",
                of("stddev", Type.FLOAT, "0.5", "Standard deviation in pixels.").between(0.125, 4)));
        list.add(plugin(
                ObjectKind.RFILTER,
                "mitchell",
                "Cubic of Mitchell and Netravali, radius 2. C must be (1 - B) / 2.",
                of("B", Type.FLOAT, "0.3333333333333333", "First parameter."),
                of("C", Type.FLOAT, "0.3333333333333333", "Second parameter.")));
        list.add(plugin(ObjectKind.RFILTER, "catmullrom", "Catmull-Rom cubic: mitchell with B = 0, C = 1/2."));
    }

    private static void addSamplers(List<PluginDefinition> list) {
        for (String type : List.of("independent", "stratified", "multijitter", "orthogonal", "ldsampler")) {
            list.add(plugin(
                    ObjectKind.SAMPLER,
                    type,
                    "Only the number of samples and the seed are taken; the pattern is an option of the renderer.",
                    of("sample_count", Type.INTEGER, "4", "Samples per pixel.").between(1, Integer.MAX_VALUE),
                    optional("seed", Type.INTEGER, "Seed of the random numbers."),
                    optional("jitter", Type.BOOLEAN, NO_EFFECT),
                    optional("strength", Type.INTEGER, NO_EFFECT)));
        }
    }

    private static void addShapes(List<PluginDefinition> list) {
        List<PropertyDefinition> common = List.of(
                optional("to_world", Type.TRANSFORM, "Shape to world."),
                of("flip_normals", Type.BOOLEAN, "false", "Exchanges front and back."),
                objects(
                        ObjectKind.BSDF,
                        0,
                        1,
                        "Material; diffuse with reflectance 0.5 if there is none, 0 on a shape that emits."),
                objects(ObjectKind.EMITTER, 0, 1, "Makes the shape a light."));
        PropertyDefinition file = optional("filename", Type.FILE, "The file.").asRequired();
        PropertyDefinition faceNormals = of(
                "face_normals",
                Type.BOOLEAN,
                "false",
                "Flat triangles. Otherwise normals are those of the file or, if it has none, computed.");
        list.add(plugin(
                ObjectKind.SHAPE,
                "obj",
                "Wavefront OBJ mesh.",
                join(
                        common,
                        file,
                        faceNormals,
                        of(
                                "flip_tex_coords",
                                Type.BOOLEAN,
                                "true",
                                "Turns v into 1 - v, as images start at the top."))));
        list.add(plugin(
                ObjectKind.SHAPE,
                "ply",
                "PLY mesh, ASCII or binary.",
                join(common, file, faceNormals, of("flip_tex_coords", Type.BOOLEAN, "false", "Turns v into 1 - v."))));
        list.add(plugin(
                ObjectKind.SHAPE,
                "sphere",
                "Sphere.",
                join(
                        common,
                        of("center", Type.POINT, "0, 0, 0", "Centre."),
                        of("radius", Type.FLOAT, "1", "Radius.").positive())));
        list.add(plugin(ObjectKind.SHAPE, "rectangle", "Square [-1, 1]² in z = 0, normal +z.", join(common)));
        list.add(plugin(ObjectKind.SHAPE, "disk", "Unit disk in z = 0, normal +z.", join(common)));
        list.add(plugin(ObjectKind.SHAPE, "cube", "Cube [-1, 1]³, normals outwards.", join(common)));
        list.add(plugin(
                ObjectKind.SHAPE,
                "cylinder",
                "Cylinder without caps, normal outwards.",
                join(
                        common,
                        of("p0", Type.POINT, "0, 0, 0", "Centre of one end."),
                        of("p1", Type.POINT, "0, 0, 1", "Centre of the other end."),
                        of("radius", Type.FLOAT, "1", "Radius.").positive())));
        list.add(plugin(
                ObjectKind.SHAPE,
                "shapegroup",
                "Shapes that only appear through instances.",
                objects(ObjectKind.SHAPE, 1, MANY, "The shapes.")));
        list.add(plugin(
                ObjectKind.SHAPE,
                "instance",
                "Appearance of a shapegroup; its geometry is stored once.",
                optional("to_world", Type.TRANSFORM, "Group to world."),
                objects(ObjectKind.SHAPE, 1, 1, "The shapegroup, usually by reference.")));
    }

    private static void addBsdfs(List<PluginDefinition> list) {
        PropertyDefinition specular =
                of("specular_reflectance", Type.REFLECTANCE, "1", "Factor on the specular reflection.");
        List<PropertyDefinition> metal = List.of(
                of("material", Type.STRING, "none", "Must be 'none': give eta and k for a metal."),
                of("eta", Type.COLOR, "0", "Real part of the refractive index, relative to vacuum.")
                        .between(0, 1e6),
                of("k", Type.COLOR, "1", "Imaginary part of the refractive index.")
                        .between(0, 1e6),
                specular);
        List<PropertyDefinition> rough = List.of(
                choice("distribution", "beckmann", List.of("beckmann", "ggx"), "Distribution of microfacet normals."),
                of("sample_visible", Type.BOOLEAN, "true", "Accepted; visible normals are always sampled."));
        List<PropertyDefinition> dielectric = List.of(
                of("ext_ior", Type.REFRACTIVE_INDEX, "air", "Refractive index on the side of the normal."), specular);
        PropertyDefinition alpha = optional("alpha", Type.FLOAT, "Roughness; default 0.1. No textures.")
                .between(1e-6, 10);
        List<PropertyDefinition> plastic = List.of(
                of("int_ior", Type.REFRACTIVE_INDEX, "polypropylene", "Refractive index behind the surface."),
                of("diffuse_reflectance", Type.REFLECTANCE, "0.5", "Reflectance of the base."),
                of("nonlinear", Type.BOOLEAN, "false", "Colour shift by internal reflection."));
        list.add(plugin(
                ObjectKind.BSDF,
                "diffuse",
                "Lambertian reflection.",
                of("reflectance", Type.REFLECTANCE, "0.5", "Albedo.")));
        list.add(plugin(
                ObjectKind.BSDF, "conductor", "Smooth metal; a perfect mirror unless eta or k is given.", join(metal)));
        list.add(plugin(
                ObjectKind.BSDF,
                "roughconductor",
                "Rough metal.",
                join(
                        metal,
                        join(
                                rough,
                                alpha,
                                optional("alpha_u", Type.FLOAT, "Roughness along u; must equal alpha_v.")
                                        .between(1e-6, 10),
                                optional("alpha_v", Type.FLOAT, "Roughness along v.")
                                        .between(1e-6, 10)))));
        list.add(plugin(
                ObjectKind.BSDF,
                "dielectric",
                "Clear glass.",
                join(
                        dielectric,
                        of("int_ior", Type.REFRACTIVE_INDEX, "bk7", "Refractive index behind the surface."),
                        of("specular_transmittance", Type.REFLECTANCE, "1", "Factor on the refraction."))));
        list.add(plugin(
                ObjectKind.BSDF, "plastic", "Diffuse base under a smooth coat.", join(dielectric, join(plastic))));
        list.add(plugin(
                ObjectKind.BSDF,
                "roughplastic",
                "Diffuse base under a rough coat.",
                join(dielectric, join(plastic, join(rough, alpha)))));
        list.add(plugin(
                ObjectKind.BSDF,
                "twosided",
                "Reflects on both sides alike, or differently if there are two materials.",
                objects(ObjectKind.BSDF, 1, 2, "Front and, if it differs, back; opaque.")));
        list.add(plugin(
                ObjectKind.BSDF,
                "mask",
                "Lets part of the light through unchanged.",
                of("opacity", Type.REFLECTANCE, "0.5", "1 for opaque."),
                objects(ObjectKind.BSDF, 1, 1, "The masked material.")));
    }

    private static void addTextures(List<PluginDefinition> list) {
        PropertyDefinition toUv =
                optional("to_uv", Type.TRANSFORM, "Applied to texture coordinates; x, y and translation count.");
        list.add(plugin(
                ObjectKind.TEXTURE,
                "bitmap",
                "Image file; its first row is at v = 0. Alpha is dropped.",
                optional("filename", Type.FILE, "The file.").asRequired(),
                choice("filter_type", "bilinear", List.of("bilinear", "nearest"), "Interpolation."),
                choice("wrap_mode", "repeat", List.of("repeat", "mirror", "clamp"), "What lies outside the image."),
                of("raw", Type.BOOLEAN, "false", "Takes values of 8 and 16 bits as linear instead of sRGB."),
                toUv,
                optional("format", Type.STRING, NO_EFFECT),
                optional("accel", Type.BOOLEAN, NO_EFFECT)));
        list.add(plugin(
                ObjectKind.TEXTURE,
                "checkerboard",
                "Four squares per unit of texture space.",
                of("color0", Type.TEXTURED_EMISSION, "0.4", "Colour of the square at (0, 0)."),
                of("color1", Type.TEXTURED_EMISSION, "0.2", "The other colour."),
                toUv));
    }

    private static void addEmitters(List<PluginDefinition> list) {
        PropertyDefinition weight = of("sampling_weight", Type.FLOAT, "1", "Accepted, has no effect.")
                .between(0, Double.MAX_VALUE);
        list.add(plugin(
                ObjectKind.EMITTER,
                "area",
                "Makes the shape it stands in a light, on its front.",
                of("radiance", Type.TEXTURED_EMISSION, "1", "Radiance in W/(m² sr)."),
                weight));
        list.add(plugin(
                ObjectKind.EMITTER,
                "point",
                "Point light.",
                of("intensity", Type.EMISSION, "1", "Radiant intensity in W/sr."),
                optional("position", Type.POINT, "Position; excludes to_world."),
                optional("to_world", Type.TRANSFORM, "Light to world."),
                weight));
        list.add(plugin(
                ObjectKind.EMITTER,
                "spot",
                "Spot at the origin that shines along +z; linear fall-off in angle. No texture.",
                of("intensity", Type.EMISSION, "1", "Radiant intensity on the axis in W/sr."),
                of("cutoff_angle", Type.FLOAT, "20", "Angle from the axis where light ends, in degrees.")
                        .between(1e-3, 180),
                optional("beam_width", Type.FLOAT, "Angle of full intensity in degrees; default 3/4 of cutoff_angle.")
                        .between(0, 180),
                optional("to_world", Type.TRANSFORM, "Light to world."),
                weight));
        list.add(plugin(
                ObjectKind.EMITTER,
                "constant",
                "The same radiance from all directions.",
                of("radiance", Type.EMISSION, "1", "Radiance in W/(m² sr)."),
                weight));
        list.add(plugin(
                ObjectKind.EMITTER,
                "envmap",
                "Equirectangular image around the scene, +y up.",
                optional("filename", Type.FILE, "The file.").asRequired(),
                of("scale", Type.FLOAT, "1", "Factor on the image.").between(0, Double.MAX_VALUE),
                optional("to_world", Type.TRANSFORM, "Image to world."),
                weight));
    }
}
