package org.daybreak.scenes.build;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.material.Blend;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.BumpMap;
import org.daybreak.core.material.Conductor;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.GroimpPhong;
import org.daybreak.core.material.Leaf;
import org.daybreak.core.material.Mask;
import org.daybreak.core.material.Microfacet;
import org.daybreak.core.material.NormalMap;
import org.daybreak.core.material.NullBsdf;
import org.daybreak.core.material.Plastic;
import org.daybreak.core.material.Principled;
import org.daybreak.core.material.PrincipledThin;
import org.daybreak.core.material.RoughConductor;
import org.daybreak.core.material.RoughDielectric;
import org.daybreak.core.material.RoughPlastic;
import org.daybreak.core.material.Roughness;
import org.daybreak.core.material.ScaledTexture;
import org.daybreak.core.material.Texture;
import org.daybreak.core.material.ThinDielectric;
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
        return context.shared(built, object, usedAt, DEFAULT, () -> make(object));
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
                case "roughdielectric" ->
                    new RoughDielectric(
                            distribution(p),
                            roughness(p),
                            p.refractiveIndex("int_ior"),
                            p.refractiveIndex("ext_ior"),
                            textures.texture(p, "specular_reflectance"),
                            textures.texture(p, "specular_transmittance"));
                case "thindielectric" ->
                    new ThinDielectric(
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
                case "difftrans" -> Leaf.transmitter(textures.texture(p, "transmittance"));
                case "leaf" -> leaf(p);
                case "groimp_phong" -> phong(p);
                case "principled" -> principled(p);
                case "principledthin" -> principledThin(p);
                case "blendbsdf" -> blend(p);
                case "normalmap" -> normalMap(p);
                case "bumpmap" -> bumpMap(p);
                case "null" -> new NullBsdf();
                default -> throw new IllegalStateException("no builder for " + object.label());
            };
        } catch (IllegalArgumentException e) {
            context.error(object.location(), object.label() + ": " + e.getMessage());
            return null;
        }
    }

    private Bsdf conductor(Properties p) {
        Texture reflectance = textures.texture(p, "specular_reflectance");
        Metals.ComplexIndex index = index(p);
        return index == null ? Conductor.mirror(reflectance) : new Conductor(index.eta(), index.k(), reflectance);
    }

    private Bsdf roughConductor(Properties p) {
        Texture reflectance = textures.texture(p, "specular_reflectance");
        Roughness roughness = roughness(p);
        Metals.ComplexIndex index = index(p);
        return index == null
                ? RoughConductor.mirror(distribution(p), roughness, reflectance)
                : new RoughConductor(distribution(p), roughness, index.eta(), index.k(), reflectance);
    }

    /** Null for a mirror, which is the default: η = 0 and k = 1 reflect all light at every angle. */
    private Metals.@Nullable ComplexIndex index(Properties p) {
        boolean given = p.mentions("eta") || p.mentions("k");
        String material = p.text("material");
        if (material.equals("none")) {
            return given ? new Metals.ComplexIndex(spectrum(p, "eta"), spectrum(p, "k")) : null;
        }
        if (given) {
            context.error(p.location("material"), "either 'material' or 'eta' and 'k' can be given, not both");
            return null;
        }
        Metals.ComplexIndex index = Metals.of(material);
        if (index == null) {
            context.problems()
                    .unknownName(
                            p.location("material"),
                            "there is no metal '" + material + "' (give 'eta' and 'k' for others)",
                            material,
                            Metals.names());
        }
        return index;
    }

    private Roughness roughness(Properties p) {
        if (!p.mentions("alpha_u") && !p.mentions("alpha_v")) {
            return Roughness.of(textures.texture(p, "alpha"));
        }
        SourceLocation location = p.location(p.has("alpha_u") ? "alpha_u" : "alpha_v");
        if (p.mentions("alpha")) {
            context.error(location, "either 'alpha' or 'alpha_u' and 'alpha_v' can be given, not both");
        } else if (!p.mentions("alpha_u") || !p.mentions("alpha_v")) {
            context.error(location, "'alpha_u' and 'alpha_v' must be given together");
        }
        if (!p.has("alpha_u") || !p.has("alpha_v")) {
            return Roughness.of(DEFAULT_ALPHA);
        }
        return Roughness.of(textures.texture(p, "alpha_u"), textures.texture(p, "alpha_v"));
    }

    private Bsdf leaf(Properties p) {
        Texture reflectance = textures.texture(p, "reflectance");
        Texture transmittance = textures.texture(p, "transmittance");
        return new Leaf(
                reflectance,
                transmittance,
                p.has("back_reflectance") ? textures.texture(p, "back_reflectance") : reflectance,
                p.has("back_transmittance") ? textures.texture(p, "back_transmittance") : transmittance);
    }

    private Bsdf phong(Properties p) {
        return new GroimpPhong(
                new GroimpPhong.Parameters(
                        textures.texture(p, "diffuse"),
                        textures.texture(p, "alpha"),
                        p.has("specular") ? textures.texture(p, "specular") : null,
                        textures.texture(p, "shininess"),
                        textures.texture(p, "transparency"),
                        textures.texture(p, "transparency_shininess"),
                        textures.texture(p, "diffuse_transparency"),
                        p.truth("interpolated_transparency")),
                p.refractiveIndex("int_ior"),
                p.refractiveIndex("ext_ior"));
    }

    private Bsdf principled(Properties p) {
        if (p.mentions("eta") && p.mentions("specular")) {
            context.error(p.location("eta"), "either 'eta' or 'specular' can be given, not both");
        }
        return new Principled(new Principled.Parameters(
                textures.texture(p, "base_color"),
                textures.texture(p, "roughness"),
                textures.texture(p, "anisotropic"),
                textures.texture(p, "metallic"),
                textures.texture(p, "spec_trans"),
                p.has("eta") ? p.number("eta") : Principled.etaOfSpecular(p.number("specular")),
                textures.texture(p, "spec_tint"),
                textures.texture(p, "sheen"),
                textures.texture(p, "sheen_tint"),
                textures.texture(p, "flatness"),
                textures.texture(p, "clearcoat"),
                textures.texture(p, "clearcoat_gloss")));
    }

    private Bsdf principledThin(Properties p) {
        return new PrincipledThin(new PrincipledThin.Parameters(
                textures.texture(p, "base_color"),
                textures.texture(p, "roughness"),
                textures.texture(p, "anisotropic"),
                textures.texture(p, "spec_trans"),
                p.number("eta"),
                textures.texture(p, "spec_tint"),
                textures.texture(p, "sheen"),
                textures.texture(p, "sheen_tint"),
                textures.texture(p, "flatness"),
                new ScaledTexture(textures.texture(p, "diff_trans"), 0.5, 0.5, 0.5)));
    }

    private @Nullable Bsdf blend(Properties p) {
        List<Properties.Child> nested = p.children(ObjectKind.BSDF);
        if (nested.size() != 2) {
            return null;
        }
        return new Blend(
                textures.texture(p, "weight"),
                bsdf(nested.get(0).object(), nested.get(0).location()),
                bsdf(nested.get(1).object(), nested.get(1).location()));
    }

    private @Nullable Bsdf normalMap(Properties p) {
        Properties.Child nested = p.child(ObjectKind.BSDF);
        return nested == null
                ? null
                : new NormalMap(
                        textures.texture(p, "normalmap"),
                        p.number("scale"),
                        p.text("green").equals("against_v"),
                        bsdf(nested.object(), nested.location()),
                        p.truth("use_shadowing_function"));
    }

    private @Nullable Bsdf bumpMap(Properties p) {
        Properties.Child nested = p.child(ObjectKind.BSDF);
        Properties.Child height = p.child(ObjectKind.TEXTURE);
        if (nested == null || height == null) {
            return null;
        }
        Texture texture = textures.texture(height.object(), height.location());
        Bsdf base = bsdf(nested.object(), nested.location());
        return texture == TextureBuilder.PLACEHOLDER
                ? null
                : new BumpMap(texture, p.number("scale"), base, p.truth("use_shadowing_function"));
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
        List<Bsdf> sides = new ArrayList<>();
        for (Properties.Child child : nested) {
            Bsdf side = bsdf(child.object(), child.location());
            sides.add(side);
            if (side.transmissive() || side.maybeTransparent()) {
                context.error(
                        child.location(),
                        "<bsdf type=\"twosided\"> must contain opaque materials, not "
                                + child.object().type());
                opaque = false;
            }
        }
        return opaque ? new TwoSided(sides.get(0), sides.get(sides.size() > 1 ? 1 : 0)) : null;
    }

    private @Nullable Bsdf mask(Properties p) {
        Properties.Child nested = p.child(ObjectKind.BSDF);
        return nested == null
                ? null
                : new Mask(textures.texture(p, "opacity"), bsdf(nested.object(), nested.location()));
    }
}
