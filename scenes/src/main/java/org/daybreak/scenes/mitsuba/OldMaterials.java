package org.daybreak.scenes.mitsuba;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.Value;

/** Translates the materials of Mitsuba 0.6. */
final class OldMaterials {
    private static final Set<String> AIR = Set.of("air", "vacuum");

    private OldMaterials() {}

    static void translate(ObjectEditor e) {
        switch (e.type()) {
            case "lambertian" -> e.setType("diffuse");
            case "mirror" -> {
                e.setType("conductor");
                e.put("material", new Value.Text("none"));
            }
            case "roughglass" -> e.setType("roughdielectric");
            case "roughmetal" -> e.setType("roughconductor");
            case "microfacet" -> e.setType("roughplastic");
            default -> {}
        }
        switch (e.type()) {
            case "diffuse" -> {
                e.rename("diffuse_reflectance", "reflectance");
                e.remove("diffuse_amount");
            }
            case "roughdiffuse" -> {
                e.warn("", "the roughness of 'roughdiffuse' has no effect: it is replaced by 'diffuse'");
                e.setType("diffuse");
                e.rename("diffuse_reflectance", "reflectance");
                e.remove("alpha", "use_fast_approx");
            }
            case "conductor", "roughconductor" -> metal(e);
            case "mixturebsdf" -> mixture(e);
            default -> {}
        }
        distribution(e);
        // No roughness at all was allowed.
        if (e.type().startsWith("rough") && e.has("alpha") && e.number("alpha", 1) == 0) {
            e.setType(e.type().substring("rough".length()));
            e.remove("alpha", "distribution", "sample_visible");
        }
    }

    /** The default metal was copper, and the surroundings could have a refractive index. */
    private static void metal(ObjectEditor e) {
        if (!e.has("material") && !e.has("eta") && !e.has("k")) {
            e.put("material", new Value.Text("Cu"));
        }
        String outside = e.text("ext_eta");
        if (e.has("ext_eta") && !(outside != null && AIR.contains(outside)) && e.number("ext_eta", 1) != 1) {
            e.warn("ext_eta", "'extEta' has no effect: metals are in air");
        }
        e.remove("ext_eta");
    }

    private static void distribution(ObjectEditor e) {
        String distribution = e.text("distribution");
        if (distribution != null && (distribution.equals("phong") || distribution.equals("as"))) {
            e.warn("distribution", "the distribution '" + distribution + "' is replaced by 'beckmann'");
            e.put("distribution", new Value.Text("beckmann"));
        }
    }

    /** A mixture of several materials as nested blends of two. */
    private static void mixture(ObjectEditor e) {
        String text = e.text("weights");
        List<PropertyDescription> parts = new ArrayList<>();
        for (PropertyDescription p : e.properties()) {
            boolean material = p.value() instanceof Value.Nested n && n.object().kind() == ObjectKind.BSDF;
            if (material || p.value() instanceof Value.Reference) {
                parts.add(new PropertyDescription("", p.value(), p.location()));
            }
        }
        double[] weights;
        try {
            weights = Numbers.list(text == null ? "" : text);
        } catch (Numbers.FormatException malformed) {
            return;
        }
        if (weights.length != parts.size() || weights.length < 2) {
            return;
        }
        // b(0, b(1, b(2, …))): the weight of the rest in what is left at each level.
        double rest = weights[weights.length - 1];
        PropertyDescription result = parts.get(parts.size() - 1);
        for (int i = weights.length - 2; i >= 0; i--) {
            double whole = rest + weights[i];
            double weight = whole > 0 ? rest / whole : 0;
            ObjectDescription blend = new ObjectDescription(
                    ObjectKind.BSDF,
                    "blendbsdf",
                    null,
                    e.location(),
                    List.of(
                            new PropertyDescription("weight", new Value.RealNumber(weight), e.location()),
                            parts.get(i),
                            result));
            rest = whole;
            result = new PropertyDescription("", new Value.Nested(blend), e.location());
        }
        if (result.value() instanceof Value.Nested n) {
            e.takeOver(n.object());
        }
    }
}
