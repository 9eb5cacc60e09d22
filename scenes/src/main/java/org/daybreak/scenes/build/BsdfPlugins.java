package org.daybreak.scenes.build;

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
                value("material", ValueType.STRING, "none", "Must be 'none': give eta and k for a metal."),
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
        list.add(plugin(
                ObjectKind.BSDF,
                "roughconductor",
                "Rough metal.",
                join(
                        metal,
                        join(
                                rough,
                                alpha,
                                optional("alpha_u", ValueType.FLOAT, "Roughness along u; must equal alpha_v.")
                                        .between(1e-6, 10),
                                optional("alpha_v", ValueType.FLOAT, "Roughness along v.")
                                        .between(1e-6, 10)))));
        list.add(plugin(
                ObjectKind.BSDF,
                "dielectric",
                "Clear glass.",
                join(
                        dielectric,
                        value("int_ior", ValueType.REFRACTIVE_INDEX, "bk7", "Refractive index behind the surface."),
                        value("specular_transmittance", ValueType.REFLECTANCE, "1", "Factor on the refraction."))));
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
    }
}
