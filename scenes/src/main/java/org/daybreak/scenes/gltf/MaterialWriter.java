package org.daybreak.scenes.gltf;

import java.util.List;
import org.daybreak.core.color.Spectrum;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.daybreak.scenes.gltf.Textures.Channel;
import org.jspecify.annotations.Nullable;

/** Describes one material for meshes with certain attributes. */
final class MaterialWriter {
    private static final List<String> ALPHA_MODES = List.of("OPAQUE", "MASK", "BLEND");
    private static final double[] WHITE = {1, 1, 1};
    private static final double[] BLACK = {0, 0, 0};

    /** Roughness that {@code clearcoat_gloss} 0 and 1 stand for. */
    private static final double COAT_ALPHA_AT_0 = 0.1;

    private static final double COAT_ALPHA_AT_1 = 0.001;

    /** {@code anisotropic} a makes the square of the aspect of highlights 1 − 0.9 a. */
    private static final double ASPECT_RANGE = 0.9;

    /** Stand for reflectances at normal incidence of 0 and 1. */
    private static final double SMALLEST_INDEX = 1.0001;

    private static final double LARGEST_INDEX = 1000;

    private final JsonValue material;
    private final JsonValue pbr;
    private final Geometry geometry;
    private final Textures textures;
    private final Report report;
    private final SourceLocation location;

    MaterialWriter(JsonValue material, Geometry geometry, Textures textures, Report report) throws GltfException {
        this.material = material;
        JsonValue given = material.find("pbrMetallicRoughness");
        this.pbr = given == null
                ? new JsonValue(JsonValue.Kind.OBJECT, material, "pbrMetallicRoughness", 1, 1, 0, "")
                : given;
        this.geometry = geometry;
        this.textures = textures;
        this.report = report;
        this.location = report.location(material);
    }

    Materials.Look look() throws GltfException {
        double[] factor = pbr.numbersBetween("baseColorFactor", 0, 1, 1, 1, 1, 1);
        Value baseColor = product(
                new double[] {factor[0], factor[1], factor[2]},
                texture(pbr, "baseColorTexture", Channel.SRGB),
                vertexColor());
        if (extension("unlit") != null) {
            warnIfBackIsDark();
            return new Materials.Look(masked(black(), factor[3]), area(baseColor));
        }
        double[] emissive = material.numbersBetween("emissiveFactor", 0, 1, 0, 0, 0);
        JsonValue strength = extension("emissive_strength");
        double scale = strength == null ? 1 : strength.number("emissiveStrength", 1, 0, Double.MAX_VALUE);
        for (int i = 0; i < 3; i++) {
            emissive[i] *= scale;
        }
        ObjectDescription emitter = emissive[0] + emissive[1] + emissive[2] > 0
                ? area(product(emissive, texture(material, "emissiveTexture", Channel.SRGB), null))
                : null;
        if (emitter != null) {
            warnIfBackIsDark();
        }
        return new Materials.Look(masked(surface(baseColor), factor[3]), emitter);
    }

    private void warnIfBackIsDark() throws GltfException {
        if (material.truth("doubleSided", false)) {
            report.warning(material, "emits on the front of its surfaces only");
        }
    }

    private @Nullable JsonValue extension(String name) throws GltfException {
        return material.extension("KHR_materials_" + name);
    }

    private ObjectBuilder object(ObjectKind kind, String type) {
        return new ObjectBuilder(kind, type, location);
    }

    private @Nullable ObjectDescription texture(JsonValue owner, String name, Channel channel) throws GltfException {
        JsonValue info = owner.find(name);
        return info == null ? null : textures.texture(info, channel, geometry);
    }

    private @Nullable ObjectDescription vertexColor() {
        return geometry.colors() == null
                ? null
                : object(ObjectKind.TEXTURE, "mesh_attribute")
                        .text("name", "vertex_color")
                        .build();
    }

    /** Product of a colour and up to two textures. */
    private Value product(double[] factor, @Nullable ObjectDescription first, @Nullable ObjectDescription second) {
        if (first != null && second != null) {
            ObjectDescription both = object(ObjectKind.TEXTURE, "product")
                    .value("first", new Value.Nested(first))
                    .value("second", new Value.Nested(second))
                    .build();
            return product(factor, both, null);
        }
        Value color = new Value.Color(factor[0], factor[1], factor[2]);
        ObjectDescription texture = first == null ? second : first;
        boolean one = factor[0] == 1 && factor[1] == 1 && factor[2] == 1;
        return texture == null ? color : one ? new Value.Nested(texture) : scaled(color, texture);
    }

    private Value scaled(Value factor, ObjectDescription texture) {
        return new Value.Nested(object(ObjectKind.TEXTURE, "scaled")
                .value("scale", factor)
                .nested(texture)
                .build());
    }

    /** Product of a number and one channel of a texture. */
    private Value scaled(double factor, @Nullable ObjectDescription texture) {
        Value number = new Value.RealNumber(factor);
        return texture == null ? number : factor == 1 ? new Value.Nested(texture) : scaled(number, texture);
    }

    private ObjectDescription black() {
        return object(ObjectKind.BSDF, "diffuse").number("reflectance", 0).build();
    }

    private ObjectDescription area(Value radiance) {
        return object(ObjectKind.EMITTER, "area").value("radiance", radiance).build();
    }

    /** Adds the opacity that alphaMode asks for. */
    private ObjectDescription masked(ObjectDescription bsdf, double alphaFactor) throws GltfException {
        String mode = material.choice("alphaMode", "OPAQUE", ALPHA_MODES);
        if (mode.equals("OPAQUE")) {
            return bsdf;
        }
        if (geometry.hasVertexOpacity()) {
            report.warning(material, "is used with vertex colours whose opacity is ignored");
        }
        Value alpha = scaled(alphaFactor, texture(pbr, "baseColorTexture", Channel.OPACITY));
        if (mode.equals("MASK")) {
            double cutoff = material.number("alphaCutoff", 0.5, 0, Double.MAX_VALUE);
            alpha = alpha instanceof Value.RealNumber n
                    ? new Value.RealNumber(n.value() >= cutoff ? 1 : 0)
                    : new Value.Nested(object(ObjectKind.TEXTURE, "threshold")
                            .value("value", alpha)
                            .number("cutoff", cutoff)
                            .build());
        }
        if (alpha instanceof Value.RealNumber n && n.value() == 1) {
            return bsdf;
        }
        return object(ObjectKind.BSDF, "mask")
                .value("opacity", alpha)
                .nested(bsdf)
                .build();
    }

    /** The surface without opacity and emission. */
    private ObjectDescription surface(Value baseColor) throws GltfException {
        JsonValue transmission = extension("transmission");
        double transmitted = transmission == null ? 0 : transmission.number("transmissionFactor", 0, 0, 1);
        if (transmission == null || transmitted == 0) {
            ObjectBuilder opaque = object(ObjectKind.BSDF, "principled").value("base_color", baseColor);
            addMetal(opaque);
            addCommon(opaque, false);
            addClearcoat(opaque);
            return object(ObjectKind.BSDF, "twosided")
                    .nested(normalMapped(opaque.build()))
                    .build();
        }
        Value share = scaled(transmitted, texture(transmission, "transmissionTexture", Channel.RED));
        JsonValue volume = extension("volume");
        if (volume != null && volume.number("thicknessFactor", 0, 0, Double.MAX_VALUE) > 0) {
            ObjectBuilder glass =
                    object(ObjectKind.BSDF, "principled").value("base_color", absorbed(baseColor, volume));
            addMetal(glass);
            addCommon(glass, true);
            addClearcoat(glass);
            return normalMapped(glass.value("spec_trans", share).build());
        }
        // Without a volume behind it the surface is a sheet (KHR_materials_transmission).
        if (pbr.number("metallicFactor", 1, 0, 1) > 0 && pbr.find("metallicRoughnessTexture") == null) {
            report.warning(material, "transmits light, so that its metallicFactor is ignored");
        }
        if (extension("clearcoat") != null) {
            report.warning(material, "transmits light without a volume, so that its clearcoat is ignored");
        }
        ObjectBuilder sheet = object(ObjectKind.BSDF, "principledthin").value("base_color", baseColor);
        addCommon(sheet, true);
        return normalMapped(sheet.value("spec_trans", share).build());
    }

    private void addMetal(ObjectBuilder principled) throws GltfException {
        principled.value(
                "metallic",
                scaled(pbr.number("metallicFactor", 1, 0, 1), texture(pbr, "metallicRoughnessTexture", Channel.BLUE)));
    }

    /** What surfaces with and without a volume behind them have in common. */
    private void addCommon(ObjectBuilder principled, boolean refracts) throws GltfException {
        double roughness = addAnisotropy(principled, pbr.number("roughnessFactor", 1, 0, 1));
        principled.value("roughness", scaled(roughness, texture(pbr, "metallicRoughnessTexture", Channel.GREEN)));
        principled.number("eta", refractiveIndex(refracts));
        addSheen(principled);
    }

    /** KHR_materials_ior with KHR_materials_specular folded into it where nothing is refracted. */
    private double refractiveIndex(boolean refracts) throws GltfException {
        JsonValue iorExtension = extension("ior");
        double ior = iorExtension == null ? 1.5 : iorExtension.number("ior", 1.5, 0, 1e6);
        if (ior < 1 && ior != 0 && iorExtension != null) {
            throw iorExtension.get("ior").error("must be at least 1, or 0, but is " + ior);
        }
        JsonValue specular = extension("specular");
        if (specular == null) {
            return ior == 0 ? LARGEST_INDEX : Math.max(ior, SMALLEST_INDEX);
        }
        for (String name : new String[] {"specularTexture", "specularColorTexture"}) {
            if (specular.find(name) != null) {
                report.warning(specular.get(name), "is ignored; the factor is used");
            }
        }
        double factor = specular.number("specularFactor", 1, 0, 1);
        double[] tint = specular.numbersBetween("specularColorFactor", 0, Double.MAX_VALUE, 1, 1, 1);
        double weight = factor * Spectrum.luminance(tint[0], tint[1], tint[2]);
        if (refracts) {
            if (weight != 1) {
                report.warning(specular, "is ignored: the material transmits light, which fixes its reflection");
            }
            return ior == 0 ? LARGEST_INDEX : Math.max(ior, SMALLEST_INDEX);
        }
        double root = ior == 0 ? 1 : (ior - 1) / (ior + 1);
        double reflectance = Math.sqrt(Math.min(1, root * root * weight));
        return Math.min(LARGEST_INDEX, Math.max(SMALLEST_INDEX, (1 + reflectance) / (1 - reflectance)));
    }

    /**
     * KHR_materials_volume: what is absorbed on a way of the stated thickness goes into the colour of the transmission, which
     * counts once on the way in and out together.
     */
    private Value absorbed(Value baseColor, JsonValue volume) throws GltfException {
        double[] color = volume.numbersBetween("attenuationColor", 0, 1, WHITE);
        if (volume.find("attenuationDistance") == null) {
            return baseColor;
        }
        double thickness = volume.number("thicknessFactor", 0, 0, Double.MAX_VALUE);
        double distance = volume.number("attenuationDistance", 1, Double.MIN_VALUE, Double.MAX_VALUE);
        if (volume.find("thicknessTexture") != null) {
            report.warning(volume.get("thicknessTexture"), "is ignored; the factor is used");
        }
        double[] transmittance = new double[3];
        for (int i = 0; i < 3; i++) {
            transmittance[i] = Math.pow(color[i], thickness / distance);
        }
        Value factor = new Value.Color(transmittance[0], transmittance[1], transmittance[2]);
        if (baseColor instanceof Value.Color c) {
            return new Value.Color(c.r() * transmittance[0], c.g() * transmittance[1], c.b() * transmittance[2]);
        }
        return baseColor instanceof Value.Nested nested ? scaled(factor, nested.object()) : baseColor;
    }

    /** KHR_materials_anisotropy. Returns the roughness whose highlights have the same area. */
    private double addAnisotropy(ObjectBuilder principled, double roughness) throws GltfException {
        JsonValue anisotropy = extension("anisotropy");
        double strength = anisotropy == null ? 0 : anisotropy.number("anisotropyStrength", 0, 0, 1);
        if (anisotropy == null || strength == 0) {
            return roughness;
        }
        if (anisotropy.number("anisotropyRotation", 0) != 0) {
            report.warning(anisotropy.get("anisotropyRotation"), "is ignored: highlights run along u");
        }
        if (anisotropy.find("anisotropyTexture") != null) {
            report.warning(anisotropy.get("anisotropyTexture"), "is ignored; the factor is used");
        }
        double across = roughness * roughness;
        double along = across + (1 - across) * strength * strength;
        double squaredAspect = along > 0 ? across / along : 1;
        principled.number("anisotropic", Math.min(1, (1 - squaredAspect) / ASPECT_RANGE));
        return Math.sqrt(Math.sqrt(across * along));
    }

    private void addClearcoat(ObjectBuilder principled) throws GltfException {
        JsonValue coat = extension("clearcoat");
        double factor = coat == null ? 0 : coat.number("clearcoatFactor", 0, 0, 1);
        if (coat == null || factor == 0) {
            return;
        }
        for (String name : new String[] {"clearcoatRoughnessTexture", "clearcoatNormalTexture"}) {
            if (coat.find(name) != null) {
                report.warning(coat.get(name), "is ignored");
            }
        }
        double roughness = coat.number("clearcoatRoughnessFactor", 0, 0, 1);
        double gloss = (COAT_ALPHA_AT_0 - roughness * roughness) / (COAT_ALPHA_AT_0 - COAT_ALPHA_AT_1);
        principled.value("clearcoat", scaled(factor, texture(coat, "clearcoatTexture", Channel.RED)));
        principled.number("clearcoat_gloss", Math.min(1, Math.max(0, gloss)));
    }

    private void addSheen(ObjectBuilder principled) throws GltfException {
        JsonValue sheen = extension("sheen");
        if (sheen == null) {
            return;
        }
        double[] color = sheen.numbersBetween("sheenColorFactor", 0, 1, BLACK);
        double amount = Spectrum.luminance(color[0], color[1], color[2]);
        if (amount > 0) {
            if (sheen.find("sheenColorTexture") != null) {
                report.warning(sheen.get("sheenColorTexture"), "is ignored; the factor is used");
            }
            principled.number("sheen", amount);
        }
    }

    private ObjectDescription normalMapped(ObjectDescription bsdf) throws GltfException {
        JsonValue info = material.find("normalTexture");
        ObjectDescription map = info == null ? null : textures.texture(info, Channel.LINEAR, geometry);
        if (info == null || map == null) {
            return bsdf;
        }
        return object(ObjectKind.BSDF, "normalmap")
                .value("normalmap", new Value.Nested(map))
                .number("scale", info.number("scale", 1))
                .text("green", "against_v")
                .nested(bsdf)
                .build();
    }
}
