package org.daybreak.scenes.build;

import static org.daybreak.scenes.build.Plugins.NO_EFFECT;
import static org.daybreak.scenes.build.Plugins.join;
import static org.daybreak.scenes.build.Plugins.plugin;
import static org.daybreak.scenes.build.PropertyDefinition.choice;
import static org.daybreak.scenes.build.PropertyDefinition.objects;
import static org.daybreak.scenes.build.PropertyDefinition.optional;
import static org.daybreak.scenes.build.PropertyDefinition.value;

import java.util.List;
import org.daybreak.scenes.description.ObjectKind;

/** The materials that scene files may contain. Names and defaults are those of Mitsuba 3.9 where it has the same model. */
final class BsdfPlugins {
    private BsdfPlugins() {}

    /** Appends all materials. */
    static void addTo(List<PluginDefinition> list) {
        PropertyDefinition specular =
                value("specular_reflectance", ValueType.REFLECTANCE, "1", "Factor on the specular reflection.");
        List<PropertyDefinition> metal = List.of(
                value(
                        "material",
                        ValueType.STRING,
                        "none",
                        "Symbol of a metal, such as Au, in place of eta and k: " + String.join(", ", Metals.names())
                                + "; 'none' for a mirror."),
                value("eta", ValueType.COLOR, "0", "Real part of the refractive index, relative to vacuum.")
                        .between(0, 1e6),
                value("k", ValueType.COLOR, "1", "Imaginary part of the refractive index.")
                        .between(0, 1e6),
                specular);
        List<PropertyDefinition> rough = List.of(
                choice("distribution", "beckmann", List.of("beckmann", "ggx"), "Distribution of microfacet normals."),
                value("sample_visible", ValueType.BOOLEAN, "true", "Accepted; visible normals are always sampled."));
        List<PropertyDefinition> dielectric = List.of(
                value("ext_ior", ValueType.REFRACTIVE_INDEX, "air", "Refractive index on the side of the normal."),
                specular);
        PropertyDefinition alpha = optional("alpha", ValueType.FLOAT, "Roughness; default 0.1. No textures.")
                .between(1e-6, 10);
        List<PropertyDefinition> anisotropic = List.of(
                value("alpha", ValueType.TEXTURED_NUMBER, "0.1", "Roughness; excludes the next two.")
                        .between(1e-6, 10),
                optional("alpha_u", ValueType.TEXTURED_NUMBER, "Roughness along the texture coordinate u.")
                        .between(1e-6, 10),
                optional("alpha_v", ValueType.TEXTURED_NUMBER, "Roughness across it.")
                        .between(1e-6, 10));
        PropertyDefinition glass =
                value("int_ior", ValueType.REFRACTIVE_INDEX, "bk7", "Refractive index behind the surface.");
        PropertyDefinition transmittance =
                value("specular_transmittance", ValueType.REFLECTANCE, "1", "Factor on the transmission.");
        List<PropertyDefinition> plastic = List.of(
                value("int_ior", ValueType.REFRACTIVE_INDEX, "polypropylene", "Refractive index behind the surface."),
                value("diffuse_reflectance", ValueType.REFLECTANCE, "0.5", "Reflectance of the base."),
                value("nonlinear", ValueType.BOOLEAN, "false", "Colour shift by internal reflection."));
        list.add(plugin(
                ObjectKind.BSDF,
                "diffuse",
                "Lambertian reflection.",
                value("reflectance", ValueType.REFLECTANCE, "0.5", "Albedo.")));
        list.add(plugin(
                ObjectKind.BSDF, "conductor", "Smooth metal; a perfect mirror unless eta or k is given.", join(metal)));
        list.add(
                plugin(ObjectKind.BSDF, "roughconductor", "Rough metal.", join(metal, join(rough, join(anisotropic)))));
        list.add(plugin(ObjectKind.BSDF, "dielectric", "Clear glass.", join(dielectric, glass, transmittance)));
        list.add(plugin(
                ObjectKind.BSDF,
                "roughdielectric",
                "Frosted glass.",
                join(dielectric, join(rough, join(anisotropic, glass, transmittance)))));
        list.add(plugin(
                ObjectKind.BSDF,
                "thindielectric",
                "A thin pane of clear glass, which does not bend light.",
                join(dielectric, glass, transmittance)));
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
                value("opacity", ValueType.REFLECTANCE, "0.5", "1 for opaque."),
                objects(ObjectKind.BSDF, 1, 1, "The masked material.")));
        list.add(plugin(
                ObjectKind.BSDF,
                "blendbsdf",
                "Two materials side by side, too fine to be told apart.",
                unit("weight", "0.5", "Share of the second material."),
                objects(ObjectKind.BSDF, 2, 2, "The materials.")));
        PropertyDefinition flip = value(
                "flip_invalid_normals",
                ValueType.BOOLEAN,
                "false",
                "Accepted, has no effect: where the normal faces away it is black. Mitsuba's default flips the normal,"
                        + " which is not reciprocal.");
        PropertyDefinition shadowing =
                value("use_shadowing_function", ValueType.BOOLEAN, "true", "Softens the edge of darkness.");
        list.add(plugin(
                ObjectKind.BSDF,
                "normalmap",
                "A material with the normals of a picture.",
                value("normalmap", ValueType.REFLECTANCE, "0.5", "Normals, mapped to colours; a raw bitmap.")
                        .asRequired(),
                flip,
                shadowing,
                value("scale", ValueType.FLOAT, "1", "Factor on the components along the surface; not in Mitsuba."),
                choice(
                        "green",
                        "along_t",
                        List.of("along_t", "against_v"),
                        "Direction of the green component: across u to the left, or that in which v falls."
                                + " Not in Mitsuba."),
                objects(ObjectKind.BSDF, 1, 1, "The material.")));
        list.add(plugin(
                ObjectKind.BSDF,
                "bumpmap",
                "A material with the normals of a displaced surface.",
                value("scale", ValueType.FLOAT, "1", "World units per unit of the texture."),
                flip,
                shadowing,
                objects(ObjectKind.TEXTURE, 1, 1, "The displacement; a raw bitmap."),
                objects(ObjectKind.BSDF, 1, 1, "The material.")));
        list.add(plugin(ObjectKind.BSDF, "null", "No surface: everything passes straight through."));
        addThin(list);
        addPrincipled(list);
    }

    private static PropertyDefinition unit(String name, String defaultValue, String doc) {
        return value(name, ValueType.TEXTURED_NUMBER, defaultValue, doc).between(0, 1);
    }

    private static void addThin(List<PluginDefinition> list) {
        list.add(plugin(
                ObjectKind.BSDF,
                "difftrans",
                "Transmits diffusely and reflects nothing; the name is that of Mitsuba 0.6.",
                value("transmittance", ValueType.REFLECTANCE, "0.5", "Fraction of light that passes.")));
        list.add(plugin(
                ObjectKind.BSDF,
                "leaf",
                "A plant's leaf: diffuse on both sides. A side's two values must not exceed 1 together.",
                value("reflectance", ValueType.REFLECTANCE, "0.4", "Reflectance of the front."),
                value("transmittance", ValueType.REFLECTANCE, "0.4", "Transmittance for light that arrives in front."),
                optional("back_reflectance", ValueType.REFLECTANCE, "Reflectance of the back; default the front's."),
                optional(
                        "back_transmittance",
                        ValueType.REFLECTANCE,
                        "Transmittance for light that arrives at the back; default the front's.")));
        list.add(plugin(
                ObjectKind.BSDF,
                "groimp_phong",
                "The Phong shader of GroIMP.",
                value("diffuse", ValueType.REFLECTANCE, "0.5", "Diffuse colour."),
                unit("alpha", "1", "Its alpha."),
                optional("specular", ValueType.REFLECTANCE, "Specular colour; default none."),
                unit("shininess", "0.372728655", "Channel value of the exponent of reflection; the default is 4."),
                value("transparency", ValueType.REFLECTANCE, "0", "Transparency colour."),
                unit("transparency_shininess", "1", "Channel value of the exponent of transmission; 1 is clear."),
                value("diffuse_transparency", ValueType.REFLECTANCE, "0", "Diffuse transmittance."),
                value(
                        "interpolated_transparency",
                        ValueType.BOOLEAN,
                        "true",
                        "Transparency takes its share from the colours."),
                value("int_ior", ValueType.REFRACTIVE_INDEX, "vacuum", "Refractive index behind the surface."),
                value("ext_ior", ValueType.REFRACTIVE_INDEX, "vacuum", "Refractive index on the side of the normal.")));
    }

    private static void addPrincipled(List<PluginDefinition> list) {
        PropertyDefinition unused = optional("diffuse_reflectance_sampling_rate", ValueType.FLOAT, NO_EFFECT);
        List<PropertyDefinition> common = List.of(
                value("base_color", ValueType.REFLECTANCE, "0.5", "Colour."),
                unit("roughness", "0.5", "Roughness; its square is alpha."),
                unit("anisotropic", "0", "Stretches highlights along the texture coordinate u."),
                unit("spec_trans", "0", "Share of glass."),
                unit("spec_tint", "0", "Share of the colour's hue in reflections of the dielectric."),
                unit("sheen", "0", "Cloth-like light at grazing angles."),
                unit("sheen_tint", "0", "Share of the colour's hue in it."),
                unit("flatness", "0", "Blends to an approximation of subsurface scattering."),
                unused);
        list.add(plugin(
                ObjectKind.BSDF,
                "principled",
                "The principled material of Disney.",
                join(
                        common,
                        unit("metallic", "0", "Share of metal."),
                        optional("eta", ValueType.FLOAT, "Relative refractive index; excludes specular.")
                                .positive(),
                        value("specular", ValueType.FLOAT, "0.5", "Reflectance at normal incidence from 0 to 8 %.")
                                .between(0, 1),
                        unit("clearcoat", "0", "Strength of a clear coat."),
                        unit("clearcoat_gloss", "0", "Its gloss."),
                        optional("main_specular_sampling_rate", ValueType.FLOAT, NO_EFFECT),
                        optional("clearcoat_sampling_rate", ValueType.FLOAT, NO_EFFECT))));
        list.add(plugin(
                ObjectKind.BSDF,
                "principledthin",
                "The principled material for surfaces without thickness.",
                join(
                        common,
                        value("eta", ValueType.FLOAT, "1.5", "Relative refractive index.")
                                .positive(),
                        value("diff_trans", ValueType.TEXTURED_NUMBER, "0", "Diffuse transmission; 2 transmits all.")
                                .between(0, 2),
                        optional("spec_reflect_sampling_rate", ValueType.FLOAT, NO_EFFECT),
                        optional("spec_trans_sampling_rate", ValueType.FLOAT, NO_EFFECT),
                        optional("diffuse_transmittance_sampling_rate", ValueType.FLOAT, NO_EFFECT))));
    }
}
