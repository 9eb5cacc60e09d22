package org.daybreak.scenes.model;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.daybreak.scenes.image.ImageLoader;
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
 *   <li>{@code bump} or {@code map_bump}: heights in the file's units times {@code -bm}, or normals if the image holds such;
 *   <li>{@code norm}: normals, green up;
 *   <li>{@code Ke}: emitted radiance.
 * </ul>
 *
 * All are two-sided but glass, which has no bumps. Other statements are passed over.
 */
final class MtlMaterial {
    private static final double SMOOTH_ALPHA = 0.01;
    private static final Set<Integer> GLASS = Set.of(4, 6, 7, 9);
    private static final Set<Integer> MIRROR = Set.of(3, 5, 8);
    private static final Set<String> COLORS = Set.of("kd", "ks", "ke", "tf");
    private static final Set<String> NUMBERS = Set.of("ns", "ni", "d", "tr", "illum", "pr", "pm");
    private static final Set<String> MAPS = Set.of("map_kd", "map_d", "bump", "map_bump", "norm");
    private static final String BUMP = "bump";
    private static final String NORMALS = "norm";

    private final String name;
    private final SourceLocation location;
    private final Map<String, double[]> values = new HashMap<>();
    private final Map<String, MtlTexture> maps = new HashMap<>();

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
            MtlTexture texture = MtlTexture.read(argument, !keyword.equals("map_kd"), at, problems);
            if (texture != null) {
                maps.put(keyword.equals("map_bump") ? BUMP : keyword, texture);
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

    /** The number that a word is; null if it is none or not finite. */
    static @Nullable Double number(String word) {
        try {
            double value = Double.parseDouble(word);
            return Double.isFinite(value) ? (Double) value : null;
        } catch (NumberFormatException e) {
            return null;
        }
    }

    /**
     * The properties that a shape of this material has: a bsdf, and an emitter if it emits.
     *
     * @param images reads bump maps to tell whether they hold heights or normals
     */
    List<PropertyDescription> describe(ImageLoader images) {
        List<PropertyDescription> properties = new ArrayList<>();
        properties.add(nested(bsdf(images)));
        double[] emission = values.get("ke");
        if (emission != null && Math.max(emission[0], Math.max(emission[1], emission[2])) > 0) {
            properties.add(
                    nested(object(ObjectKind.EMITTER, "area", List.of(color("radiance", emission, Double.MAX_VALUE)))));
        }
        return properties;
    }

    private ObjectDescription bsdf(ImageLoader images) {
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
        ObjectDescription base =
                object(ObjectKind.BSDF, "twosided", List.of(nested(bumpy(opaque(illumination), images))));
        MtlTexture mask = maps.get("map_d");
        if (mask != null) {
            return object(
                    ObjectKind.BSDF,
                    "mask",
                    List.of(
                            new PropertyDescription("opacity", new Value.Nested(mask.bitmap()), location),
                            nested(base)));
        }
        return opacity >= 1
                ? base
                : object(ObjectKind.BSDF, "mask", List.of(real("opacity", Math.max(0, opacity)), nested(base)));
    }

    /** A material with the bumps of the maps; normals go before heights. */
    private ObjectDescription bumpy(ObjectDescription smooth, ImageLoader images) {
        MtlTexture bump = maps.get(BUMP);
        MtlTexture normals = maps.get(NORMALS);
        if (normals == null && bump != null && NormalImages.holdsNormals(bump.file(), images)) {
            normals = bump;
        }
        if (normals != null) {
            return object(
                    ObjectKind.BSDF,
                    "normalmap",
                    List.of(
                            new PropertyDescription("normalmap", new Value.Nested(normals.bitmap()), location),
                            real("scale", normals.multiplier()),
                            new PropertyDescription("green", new Value.Text("against_v"), location),
                            nested(smooth)));
        }
        return bump == null
                ? smooth
                : object(
                        ObjectKind.BSDF,
                        "bumpmap",
                        List.of(nested(bump.bitmap()), real("scale", bump.multiplier()), nested(smooth)));
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
        MtlTexture map = maps.get("map_kd");
        return map == null
                ? color(property, color, 1)
                : new PropertyDescription(property, new Value.Nested(map.bitmap()), location);
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
}
