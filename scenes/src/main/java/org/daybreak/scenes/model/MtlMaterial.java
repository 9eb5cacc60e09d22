package org.daybreak.scenes.model;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import javax.vecmath.Matrix4d;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.jspecify.annotations.Nullable;

/**
 * A material of an MTL file, and what it becomes:
 *
 * <ul>
 *   <li>{@code Kd}, {@code map_Kd}: diffuse reflectance; a map goes before the colour;
 *   <li>{@code Ks}, {@code Ns}: a coat over it of index {@code Ni} (1.5 if it has none), Beckmann roughness
 *       α = √(2/(Ns + 2)) and a factor that brings its reflectance at normal incidence to Ks, at most 1. {@code Pr} gives
 *       α = Pr² instead;
 *   <li>{@code Pm} of at least ½, or {@code illum} 3, 5 or 8 with black Kd: metal or mirror of colour Kd or Ks;
 *   <li>{@code illum} 4, 6, 7 or 9 with {@code d} below 1 or {@code Tf}: clear glass of index {@code Ni} and colour Tf;
 *   <li>{@code d}, {@code Tr}, {@code map_d} otherwise: a mask;
 *   <li>{@code Ke}: emitted radiance.
 * </ul>
 *
 * All are two-sided but glass. Other statements, bump maps among them, are passed over.
 */
final class MtlMaterial {
    private static final double SMOOTH_ALPHA = 0.01;
    private static final Set<Integer> GLASS = Set.of(4, 6, 7, 9);
    /** Largest scale and offset of a texture, and one over the smallest scale. */
    private static final double LARGEST_SCALE = 1e30;

    private static final Set<Integer> MIRROR = Set.of(3, 5, 8);
    private static final Set<String> COLORS = Set.of("kd", "ks", "ke", "tf");
    private static final Set<String> NUMBERS = Set.of("ns", "ni", "d", "tr", "illum", "pr", "pm");
    private static final Set<String> MAPS = Set.of("map_kd", "map_d");

    private final String name;
    private final SourceLocation location;
    private final Map<String, double[]> values = new HashMap<>();
    private final Map<String, ObjectDescription> maps = new HashMap<>();

    MtlMaterial(String name, SourceLocation location) {
        this.name = name;
        this.location = location;
    }

    String name() {
        return name;
    }

    /** Takes a statement. What is wrong in it is reported as a warning. */
    void set(String keyword, String argument, SourceLocation at, ProblemList problems) {
        if (MAPS.contains(keyword)) {
            ObjectDescription texture = texture(keyword, argument, at, problems);
            if (texture != null) {
                maps.put(keyword, texture);
            }
            return;
        }
        if (!COLORS.contains(keyword) && !NUMBERS.contains(keyword)) {
            return;
        }
        List<Double> numbers = new ArrayList<>();
        for (String word : argument.split("\\s+", -1)) {
            Double number = number(word);
            if (number == null) {
                break;
            }
            numbers.add(number);
        }
        if (numbers.isEmpty()) {
            // "Kd spectral file" and "d -halo factor" are allowed by the format but used by nobody.
            problems.warning(at, "'" + keyword + " " + argument + "' is passed over: a number is expected");
            return;
        }
        double[] v = new double[3];
        for (int i = 0; i < 3; i++) {
            v[i] = numbers.get(Math.min(i, numbers.size() - 1));
        }
        values.put(keyword, v);
    }

    private static @Nullable Double number(String word) {
        try {
            double value = Double.parseDouble(word);
            return Double.isFinite(value) ? (Double) value : null;
        } catch (NumberFormatException e) {
            return null;
        }
    }

    /** The properties that a shape of this material has: a bsdf, and an emitter if it emits. */
    List<PropertyDescription> describe(ProblemList problems) {
        List<PropertyDescription> properties = new ArrayList<>();
        properties.add(nested(bsdf()));
        double[] emission = values.get("ke");
        if (emission != null && Math.max(emission[0], Math.max(emission[1], emission[2])) > 0) {
            properties.add(
                    nested(object(ObjectKind.EMITTER, "area", List.of(color("radiance", emission, Double.MAX_VALUE)))));
        }
        return properties;
    }

    private ObjectDescription bsdf() {
        int illumination = (int) scalar("illum", 2);
        double opacity = values.containsKey("d") ? scalar("d", 1) : 1 - scalar("tr", 0);
        if (GLASS.contains(illumination) && (opacity < 1 || values.containsKey("tf")) && scalar("ni", 1) > 1.0001) {
            return object(
                    ObjectKind.BSDF,
                    "dielectric",
                    List.of(
                            real("int_ior", scalar("ni", 1.5)),
                            color("specular_transmittance", values.getOrDefault("tf", white()), 1)));
        }
        ObjectDescription base = object(ObjectKind.BSDF, "twosided", List.of(nested(opaque(illumination))));
        ObjectDescription mask = maps.get("map_d");
        if (mask != null) {
            return object(
                    ObjectKind.BSDF,
                    "mask",
                    List.of(new PropertyDescription("opacity", new Value.Nested(mask), location), nested(base)));
        }
        return opacity >= 1
                ? base
                : object(ObjectKind.BSDF, "mask", List.of(real("opacity", Math.max(0, opacity)), nested(base)));
    }

    private ObjectDescription opaque(int illumination) {
        double[] diffuse = values.getOrDefault("kd", maps.containsKey("map_kd") ? white() : grey(0.6));
        double[] specular = values.getOrDefault("ks", grey(0));
        double shine = Math.max(specular[0], Math.max(specular[1], specular[2]));
        double alpha = values.containsKey("pr")
                ? scalar("pr", 1) * scalar("pr", 1)
                : Math.sqrt(2 / (Math.max(0, scalar("ns", 0)) + 2));
        boolean black = Math.max(diffuse[0], Math.max(diffuse[1], diffuse[2])) < 1e-3 && !maps.containsKey("map_kd");
        boolean metal = scalar("pm", 0) >= 0.5;
        if (metal || (MIRROR.contains(illumination) && black && shine > 0)) {
            PropertyDescription tint =
                    metal ? diffuse("specular_reflectance", diffuse) : color("specular_reflectance", specular, 1);
            return !metal || alpha < SMOOTH_ALPHA
                    ? object(ObjectKind.BSDF, "conductor", List.of(tint))
                    : object(
                            ObjectKind.BSDF, "roughconductor", List.of(tint, real("alpha", Math.min(1, alpha)), ggx()));
        }
        boolean glossy = values.containsKey("pr") || (shine > 0 && illumination >= 2 && values.containsKey("ns"));
        if (!glossy) {
            return object(ObjectKind.BSDF, "diffuse", List.of(diffuse("reflectance", diffuse)));
        }
        double index = scalar("ni", 1) > 1.05 ? scalar("ni", 1) : 1.5;
        double normal = (index - 1) / (index + 1) * (index - 1) / (index + 1);
        double[] factor = values.containsKey("pr") && shine == 0
                ? white()
                : new double[] {specular[0] / normal, specular[1] / normal, specular[2] / normal};
        List<PropertyDescription> coat = new ArrayList<>(List.of(
                diffuse("diffuse_reflectance", diffuse),
                color("specular_reflectance", factor, 1),
                real("int_ior", index)));
        if (alpha < SMOOTH_ALPHA) {
            return object(ObjectKind.BSDF, "plastic", coat);
        }
        coat.add(real("alpha", Math.min(1, alpha)));
        return object(ObjectKind.BSDF, "roughplastic", coat);
    }

    private PropertyDescription diffuse(String property, double[] color) {
        ObjectDescription map = maps.get("map_kd");
        return map == null
                ? color(property, color, 1)
                : new PropertyDescription(property, new Value.Nested(map), location);
    }

    private PropertyDescription ggx() {
        return new PropertyDescription("distribution", new Value.Text("ggx"), location);
    }

    private double scalar(String keyword, double otherwise) {
        double[] v = values.get(keyword);
        return v == null ? otherwise : v[0];
    }

    private static double[] white() {
        return grey(1);
    }

    private static double[] grey(double value) {
        return new double[] {value, value, value};
    }

    private ObjectDescription object(ObjectKind kind, String type, List<PropertyDescription> properties) {
        return new ObjectDescription(kind, type, null, location, properties);
    }

    private PropertyDescription nested(ObjectDescription object) {
        return new PropertyDescription("", new Value.Nested(object), location);
    }

    private PropertyDescription real(String property, double value) {
        return new PropertyDescription(property, new Value.RealNumber(value), location);
    }

    private PropertyDescription color(String property, double[] rgb, double limit) {
        double[] c = new double[3];
        for (int i = 0; i < 3; i++) {
            c[i] = Math.max(0, Math.min(limit, rgb[i]));
        }
        return new PropertyDescription(property, new Value.Color(c[0], c[1], c[2]), location);
    }

    /** Whether a texture can be placed that way: the inverse must exist, in numbers of ordinary size. */
    private static boolean isUsable(double[] scale, double[] offset) {
        boolean usable = true;
        for (int i = 0; i < 2; i++) {
            double s = Math.abs(scale[i]);
            usable &= s >= 1 / LARGEST_SCALE && s <= LARGEST_SCALE && Math.abs(offset[i]) <= LARGEST_SCALE;
        }
        return usable;
    }

    /** A bitmap; null if there is no such file, which is reported as a warning. */
    private static @Nullable ObjectDescription texture(
            String keyword, String argument, SourceLocation at, ProblemList problems) {
        List<PropertyDescription> properties = new ArrayList<>();
        double[] scale = {1, 1};
        double[] offset = {0, 0};
        boolean clamped = false;
        String rest = argument.strip();
        while (rest.startsWith("-")) {
            String[] words = rest.split("\\s+", -1);
            String option = words[0].toLowerCase(Locale.ROOT);
            int used = 1;
            if (option.equals("-s") || option.equals("-o") || option.equals("-t")) {
                while (used <= 3 && used < words.length && number(words[used]) != null) {
                    Double value = number(words[used]);
                    if (used <= 2 && value != null && !option.equals("-t")) {
                        (option.equals("-s") ? scale : offset)[used - 1] = value;
                    }
                    used++;
                }
            } else {
                used = option.equals("-mm") ? 3 : 2;
                if (option.equals("-clamp") && words.length > 1) {
                    clamped = words[1].equals("on");
                }
            }
            String[] left = rest.split("\\s+", used + 1);
            rest = left.length > used ? left[used] : "";
        }
        String name = rest.strip().replace('\\', '/');
        try {
            Path file = at.file().resolveSibling(name);
            if (name.isEmpty() || !Files.isRegularFile(file)) {
                problems.warning(at, "the texture '" + name + "' does not exist");
                return null;
            }
        } catch (InvalidPathException e) {
            problems.warning(at, "'" + name + "' is no file name");
            return null;
        }
        properties.add(new PropertyDescription("filename", new Value.Text(name), at));
        if (keyword.equals("map_d")) {
            properties.add(new PropertyDescription("raw", new Value.Switch(true), at));
        }
        if (clamped) {
            properties.add(new PropertyDescription("wrap_mode", new Value.Text("clamp"), at));
        }
        if (!isUsable(scale, offset)) {
            problems.warning(
                    at, "scale and offset of '" + keyword + " " + argument + "' are passed over: too small or large");
        } else if (scale[0] != 1 || scale[1] != 1 || offset[0] != 0 || offset[1] != 0) {
            // v counts from the bottom in the file and from the top here: 1 − (s·v + o) = s·(1 − v) + 1 − s − o.
            Matrix4d m = new Matrix4d(
                    scale[0], 0, 0, offset[0], 0, scale[1], 0, 1 - scale[1] - offset[1], 0, 0, 1, 0, 0, 0, 0, 1);
            properties.add(new PropertyDescription("to_uv", new Value.Transform(m), at));
        }
        return new ObjectDescription(ObjectKind.TEXTURE, "bitmap", null, at, properties);
    }
}
