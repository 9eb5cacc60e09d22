package org.daybreak.scenes.build;

import java.util.IdentityHashMap;
import java.util.List;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.Conductor;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.Mask;
import org.daybreak.core.material.Microfacet;
import org.daybreak.core.material.Plastic;
import org.daybreak.core.material.RoughConductor;
import org.daybreak.core.material.RoughPlastic;
import org.daybreak.core.material.TwoSided;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.SourceLocation;
import org.jspecify.annotations.Nullable;

/** Builds materials. One that is referred to several times is built once and shared. */
final class BsdfBuilder {
    private static final double DEFAULT_ALPHA = 0.1;

    /** Material of shapes that name none. */
    static final Bsdf DEFAULT = new Diffuse(ConstantTexture.grey(0.5));

    /** Material of emitting shapes that name none. */
    static final Bsdf BLACK = new Diffuse(ConstantTexture.grey(0));

    private final BuildContext context;
    private final TextureBuilder textures;
    private final IdentityHashMap<ObjectDescription, Bsdf> built = new IdentityHashMap<>();

    BsdfBuilder(BuildContext context, TextureBuilder textures) {
        this.context = context;
        this.textures = textures;
    }

    /** Builds a material. After an error that has been reported it is a placeholder. */
    Bsdf bsdf(ObjectDescription object, SourceLocation usedAt) {
        Bsdf known = built.get(object);
        if (known == null) {
            Bsdf made = context.<Bsdf>build(object, usedAt, () -> make(object));
            known = made == null ? DEFAULT : made;
            built.put(object, known);
        }
        return known;
    }

    private @Nullable Bsdf make(ObjectDescription object) {
        Properties p = context.properties(object);
        if (p == null) {
            return null;
        }
        try {
            return switch (object.type()) {
                case "diffuse" -> new Diffuse(textures.texture(p, "reflectance"));
                case "conductor" -> conductor(p);
                case "roughconductor" -> roughConductor(p);
                case "dielectric" ->
                    new Dielectric(
                            p.refractiveIndex("int_ior"),
                            p.refractiveIndex("ext_ior"),
                            textures.texture(p, "specular_reflectance"),
                            textures.texture(p, "specular_transmittance"));
                case "plastic" ->
                    new Plastic(
                            p.refractiveIndex("int_ior"),
                            p.refractiveIndex("ext_ior"),
                            textures.texture(p, "diffuse_reflectance"),
                            textures.texture(p, "specular_reflectance"),
                            p.truth("nonlinear"));
                case "roughplastic" ->
                    new RoughPlastic(
                            distribution(p),
                            p.number("alpha", DEFAULT_ALPHA),
                            p.refractiveIndex("int_ior"),
                            p.refractiveIndex("ext_ior"),
                            textures.texture(p, "diffuse_reflectance"),
                            textures.texture(p, "specular_reflectance"),
                            p.truth("nonlinear"));
                case "twosided" -> twoSided(p);
                case "mask" -> mask(p);
                default -> throw new IllegalStateException("no builder for " + object.label());
            };
        } catch (IllegalArgumentException e) {
            context.error(object.location(), object.label() + ": " + e.getMessage());
            return null;
        }
    }

    private Bsdf conductor(Properties p) {
        boolean mirror = isMirror(p);
        return mirror
                ? Conductor.mirror(textures.texture(p, "specular_reflectance"))
                : new Conductor(spectrum(p, "eta"), spectrum(p, "k"), textures.texture(p, "specular_reflectance"));
    }

    private Bsdf roughConductor(Properties p) {
        double alpha = conductorAlpha(p);
        return isMirror(p)
                ? RoughConductor.mirror(distribution(p), alpha, textures.texture(p, "specular_reflectance"))
                : new RoughConductor(
                        distribution(p),
                        alpha,
                        spectrum(p, "eta"),
                        spectrum(p, "k"),
                        textures.texture(p, "specular_reflectance"));
    }

    /** With the defaults, η = 0 and k = 1, all light is reflected at every angle. */
    private boolean isMirror(Properties p) {
        boolean index = p.mentions("eta") || p.mentions("k");
        String material = p.text("material");
        if (!material.equals("none")) {
            context.error(
                    p.location("material"),
                    index
                            ? "either 'material' or 'eta' and 'k' can be given, not both"
                            : "metals by name ('" + material + "') are not supported: give 'eta' and 'k', or 'none'");
        }
        return !index;
    }

    private double conductorAlpha(Properties p) {
        if (!p.mentions("alpha_u") && !p.mentions("alpha_v")) {
            return p.number("alpha", DEFAULT_ALPHA);
        }
        SourceLocation location = p.location(p.has("alpha_u") ? "alpha_u" : "alpha_v");
        if (p.mentions("alpha")) {
            context.error(location, "either 'alpha' or 'alpha_u' and 'alpha_v' can be given, not both");
        } else if (!p.mentions("alpha_u") || !p.mentions("alpha_v")) {
            context.error(location, "'alpha_u' and 'alpha_v' must be given together");
        } else if (p.has("alpha_u") && p.has("alpha_v") && p.number("alpha_u") != p.number("alpha_v")) {
            context.error(location, "anisotropic roughness is not supported: 'alpha_u' and 'alpha_v' must be equal");
        }
        return p.number("alpha_u", DEFAULT_ALPHA);
    }

    private static Microfacet.Kind distribution(Properties p) {
        return p.text("distribution").equals("ggx") ? Microfacet.Kind.GGX : Microfacet.Kind.BECKMANN;
    }

    private static Spectrum spectrum(Properties p, String name) {
        double[] rgb = p.color(name);
        Spectrum spectrum = new Spectrum();
        spectrum.set(rgb[0], rgb[1], rgb[2]);
        return spectrum;
    }

    private @Nullable Bsdf twoSided(Properties p) {
        List<Properties.Child> nested = p.children(ObjectKind.BSDF);
        if (nested.isEmpty()) {
            return null;
        }
        boolean opaque = true;
        for (Properties.Child child : nested) {
            String type = child.object().type();
            if (type.equals("dielectric") || type.equals("mask")) {
                context.error(child.location(), "<bsdf type=\"twosided\"> must contain opaque materials, not " + type);
                opaque = false;
            }
        }
        Bsdf front = bsdf(nested.get(0).object(), nested.get(0).location());
        Bsdf back =
                nested.size() > 1 ? bsdf(nested.get(1).object(), nested.get(1).location()) : front;
        return opaque ? new TwoSided(front, back) : null;
    }

    private @Nullable Bsdf mask(Properties p) {
        Properties.Child nested = p.child(ObjectKind.BSDF);
        return nested == null
                ? null
                : new Mask(textures.texture(p, "opacity"), bsdf(nested.object(), nested.location()));
    }
}
