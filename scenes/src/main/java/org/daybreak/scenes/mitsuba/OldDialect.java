package org.daybreak.scenes.mitsuba;

import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import javax.vecmath.Matrix4d;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.Value;
import org.jspecify.annotations.Nullable;

/**
 * Translates objects of Mitsuba 0.6 files, and what little differs in those of 0.3, into the names of Mitsuba 3. What only
 * concerns how Mitsuba works inside goes away; what changes the picture and cannot be had leaves a warning, or stays and
 * becomes an error.
 */
final class OldDialect {
    private static final Map<String, ObjectKind> ELEMENTS =
            Map.of("luminaire", ObjectKind.EMITTER, "camera", ObjectKind.SENSOR);

    /** Integrators whose picture, when it has converged, is that of the path tracer. */
    private static final Set<String> GLOBAL =
            Set.of("volpath", "volpath_simple", "erpt", "photonmapper", "ppm", "sppm", "vpl", "adaptive", "irrcache");

    private static final Set<String> PATH_PROPERTIES = Set.of("max_depth", "rr_depth", "hide_emitters");
    private static final String[] FILM_OUTPUT = {
        "file_format",
        "pixel_format",
        "component_format",
        "attach_log",
        "banner",
        "high_quality_edges",
        "gamma",
        "exposure",
        "tonemap_method",
        "key",
        "burn",
        "alpha",
        "digits",
        "variable"
    };

    private static final List<String> SIGNS =
            List.of("\"toWorld\"", "'toWorld'", "\"sampleCount\"", "\"maxDepth\"", "<luminaire", "<camera");

    private OldDialect() {}

    /** Whether a file that does not say its version looks like one of before version 2. */
    static boolean isLikely(String text) {
        return SIGNS.stream().anyMatch(text::contains);
    }

    /** The kind that an element stood for before version 0.4, or null. */
    static @Nullable ObjectKind kind(String element) {
        return ELEMENTS.get(element);
    }

    /** Translates an object whose nested objects have been translated. */
    static ObjectDescription translate(ObjectDescription object, ProblemList problems) {
        ObjectEditor e = new ObjectEditor(object, problems);
        e.renameAll(OldDialect::snakeCase);
        switch (object.kind()) {
            case INTEGRATOR -> integrator(e);
            case SENSOR -> sensor(e);
            case FILM -> film(e);
            case RFILTER -> filter(e);
            case SAMPLER -> sampler(e);
            case SHAPE -> shape(e);
            case BSDF -> OldMaterials.translate(e);
            case TEXTURE -> texture(e);
            case EMITTER -> emitter(e);
            case SCENE -> {}
        }
        return e.result();
    }

    /** {@code maxDepth} and {@code intIOR} as {@code max_depth} and {@code int_ior}; single letters stay as they are. */
    static String snakeCase(String name) {
        if (name.length() < 2) {
            return name;
        }
        StringBuilder result = new StringBuilder();
        for (int i = 0; i < name.length(); i++) {
            char c = name.charAt(i);
            if (Character.isUpperCase(c) && i > 0 && !Character.isUpperCase(name.charAt(i - 1))) {
                result.append('_');
            }
            result.append(c);
        }
        return result.toString().toLowerCase(Locale.ROOT).replace("__", "_");
    }

    private static void shape(ObjectEditor e) {
        e.remove("collapse", "srgb");
        if (e.has("max_smooth_angle")) {
            e.warn("max_smooth_angle", "'maxSmoothAngle' has no effect");
            e.remove("max_smooth_angle");
        }
        if (e.type().equals("heightfield") && e.has("shading_normals")) {
            e.put("face_normals", new Value.Switch(!e.isTrue("shading_normals")));
            e.remove("shading_normals");
        }
    }

    private static void integrator(ObjectEditor e) {
        if (e.isTrue("strict_normals")) {
            e.warn("strict_normals", "'strictNormals' has no effect");
        }
        e.remove("strict_normals");
        if (e.type().equals("bdpt")) {
            e.remove("sample_direct");
        }
        if (e.type().equals("mlt") || e.type().equals("pssmlt")) {
            chains(e);
        }
        if (GLOBAL.contains(e.type())) {
            ObjectDescription nested = e.nested(ObjectKind.INTEGRATOR);
            e.warn("", "the integrator '" + e.type() + "' is replaced by 'path'");
            if (nested != null) {
                e.takeOver(nested);
            }
            e.setType("path");
            e.retain(PATH_PROPERTIES);
        }
    }

    /** Markov chains. */
    private static void chains(ObjectEditor e) {
        if (e.number("timeout", 0) > 0) {
            e.warn("timeout", "'timeout' has no effect: give --time");
        }
        e.remove("timeout", "work_units", "first_stage");
        if (e.type().equals("mlt")) {
            if (!e.has("lambda")) {
                e.rename("prob_factor", "lambda");
            }
            e.remove("prob_factor");
        } else {
            if (e.has("bidirectional") && !e.isTrue("bidirectional")) {
                e.warn(
                        "bidirectional",
                        "'bidirectional' has no effect: samples are those of bidirectional path tracing");
            }
            e.remove("bidirectional", "kelemen_style_weights", "direct_sampling");
        }
    }

    private static void sensor(ObjectEditor e) {
        e.remove("shutter_open", "shutter_close", "kc");
        if (e.type().equals("perspective_rdist")) {
            e.warn("", "lens distortion is not supported: 'perspective_rdist' is replaced by 'perspective'");
            e.setType("perspective");
        }
        if (e.has("map_smaller_side")) {
            e.put("fov_axis", new Value.Text(e.isTrue("map_smaller_side") ? "smaller" : "larger"));
            e.remove("map_smaller_side");
        }
        if (e.type().equals("perspective")) {
            e.remove("focus_distance", "aperture_radius");
        }
    }

    private static void film(ObjectEditor e) {
        if (Set.of("ldrfilm", "tiledhdrfilm", "mfilm", "exrfilm", "pngfilm").contains(e.type())) {
            if (e.number("exposure", 0) != 0) {
                e.warn("exposure", "'exposure' has no effect: images are written as they are");
            }
            e.setType("hdrfilm");
        }
        // How images are written is a matter of the command line.
        e.remove(FILM_OUTPUT);
    }

    private static void filter(ObjectEditor e) {
        if (e.type().equals("lanczos")) {
            e.warn("", "the filter 'lanczos' is replaced by 'catmullrom'");
            e.setType("catmullrom");
            e.remove("lobes");
        }
    }

    private static void sampler(ObjectEditor e) {
        if (Set.of("halton", "hammersley", "sobol").contains(e.type())) {
            e.setType("independent");
        }
        e.remove("dimension", "scramble");
    }

    private static void texture(ObjectEditor e) {
        if (e.type().equals("ldrtexture") || e.type().equals("exrtexture")) {
            e.setType("bitmap");
        }
        uvTransform(e);
        if (e.type().equals("checkerboard")) {
            e.rename("dark_color", "color0");
            e.rename("bright_color", "color1");
        }
        if (!e.type().equals("bitmap")) {
            return;
        }
        if (e.has("gamma")) {
            double gamma = e.number("gamma", -1);
            if (gamma == 1) {
                e.put("raw", new Value.Switch(true));
            } else if (gamma > 0 && gamma != 2.2) {
                e.warn("gamma", "'gamma' " + gamma + " is taken for that of sRGB");
            }
        }
        if (e.has("wrap_mode_u") && !e.has("wrap_mode")) {
            e.rename("wrap_mode_u", "wrap_mode");
        }
        String filter = e.text("filter_type");
        if (filter != null) {
            e.put("filter_type", new Value.Text(filter.equals("nearest") ? "nearest" : "bilinear"));
        }
        String wrap = e.text("wrap_mode");
        if (wrap != null && (wrap.equals("zero") || wrap.equals("black") || wrap.equals("one"))) {
            e.warn("wrap_mode", "the wrap mode '" + wrap + "' is replaced by 'clamp'");
            e.put("wrap_mode", new Value.Text("clamp"));
        }
        e.remove("gamma", "wrap_mode_u", "wrap_mode_v", "max_anisotropy", "cache", "srgb");
    }

    /** {@code uscale} and its kin as {@code to_uv}. */
    private static void uvTransform(ObjectEditor e) {
        boolean any = false;
        double scale = e.number("uvscale", 1);
        double[] values = {scale, scale, 0, 0};
        String[] names = {"uscale", "vscale", "uoffset", "voffset"};
        for (int i = 0; i < 4; i++) {
            any |= e.has(names[i]);
            values[i] = e.number(names[i], values[i]);
        }
        if (any || e.has("uvscale")) {
            Matrix4d m = Transforms.scaling(values[0], values[1], 1);
            m.m03 = values[2];
            m.m13 = values[3];
            e.put("to_uv", new Value.Transform(m));
            e.remove("uscale", "vscale", "uoffset", "voffset", "uvscale");
        }
    }

    private static void emitter(ObjectEditor e) {
        switch (e.type()) {
            case "area", "constant" -> {
                if (!e.has("radiance")) {
                    e.rename("intensity", "radiance");
                }
            }
            case "envmap" -> {
                if (e.has("gamma") && e.number("gamma", 1) > 0 && e.number("gamma", 1) != 1) {
                    e.warn("gamma", "'gamma' has no effect: the kind of image says how it is encoded");
                }
                if (!e.has("scale")) {
                    e.rename("intensity_scale", "scale");
                }
                e.remove("gamma", "cache");
            }
            case "directional" -> {
                if (!e.has("irradiance")) {
                    e.rename("intensity", "irradiance");
                }
            }
            default -> {}
        }
    }
}
