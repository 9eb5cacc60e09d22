package org.daybreak.scenes.gltf;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.Optional;
import javax.vecmath.Matrix4d;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.Value;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** What materials and textures are described as. */
class MaterialTest {
    /** A PNG image of one pixel. */
    static final String PNG =
            "iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mP8z8BQDwAEhQGAhKmMIQAAAABJRU5ErkJggg==";

    @TempDir
    Path folder;

    private Descriptions read(String attributes, String material) throws IOException {
        return Descriptions.read(text(attributes, material), folder);
    }

    static GltfText text(String attributes, String material) {
        return GltfText.mesh(attributes, ",'material':0")
                .with("materials", "[" + material + "]")
                .with("images", "[{'uri':'data:image/png;base64," + PNG + "'}]")
                .with("samplers", "[{'magFilter':9728,'wrapS':33071,'wrapT':33648}]")
                .with("textures", "[{'source':0},{'source':0,'sampler':0}]")
                .floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0)
                .floats("VEC2", 0, 0, 1, 0, 0, 1)
                .floats("VEC3", 1, 0, 0, 0, 1, 0, 0, 0, 1)
                .floats("VEC2", 0, 0, 5, 0, 0, 5);
    }

    private ObjectDescription bsdf(String material) throws IOException {
        return Descriptions.child(
                read("'POSITION':0,'TEXCOORD_0':1", material).only(ObjectKind.SHAPE), ObjectKind.BSDF);
    }

    /** The principled material inside the two-sided one. */
    private ObjectDescription principled(String material) throws IOException {
        ObjectDescription twoSided = bsdf(material);
        assertEquals("twosided", twoSided.type());
        ObjectDescription principled = Descriptions.child(twoSided, ObjectKind.BSDF);
        assertEquals("principled", principled.type());
        return principled;
    }

    @Test
    void theDefaultMaterialIsAWhiteRoughMetal() throws IOException {
        for (ObjectDescription p : List.of(
                principled("{}"),
                Descriptions.child(
                        Descriptions.child(
                                Descriptions.read(
                                                GltfText.mesh("'POSITION':0", "")
                                                        .floats("VEC3", 0, 0, 0, 1, 0, 0, 0, 1, 0),
                                                folder)
                                        .only(ObjectKind.SHAPE),
                                ObjectKind.BSDF),
                        ObjectKind.BSDF))) {
            assertEquals(new Value.Color(1, 1, 1), Descriptions.value(p, "base_color"));
            assertEquals(1, Descriptions.number(p, "metallic"));
            assertEquals(1, Descriptions.number(p, "roughness"));
            assertEquals(1.5, Descriptions.number(p, "eta"));
        }
    }

    @Test
    void factorsWithoutTextures() throws IOException {
        ObjectDescription p = principled("{'pbrMetallicRoughness':{'baseColorFactor':[0.1,0.2,0.3,0.4],"
                + "'metallicFactor':0.25,'roughnessFactor':0.5}}");
        assertEquals(new Value.Color(0.1, 0.2, 0.3), Descriptions.value(p, "base_color"));
        assertEquals(0.25, Descriptions.number(p, "metallic"));
        assertEquals(0.5, Descriptions.number(p, "roughness"));
    }

    @Test
    void texturesOfMetallicRoughness() throws IOException {
        ObjectDescription p = principled("{'pbrMetallicRoughness':{'baseColorFactor':[0.5,1,1,1],'metallicFactor':0.5,"
                + "'baseColorTexture':{'index':0},'metallicRoughnessTexture':{'index':1}}}");
        ObjectDescription product = Descriptions.nested(p, "base_color");
        assertEquals("scaled", product.type());
        assertEquals(new Value.Color(0.5, 1, 1), Descriptions.value(product, "scale"));
        ObjectDescription base = Descriptions.child(product, ObjectKind.TEXTURE);
        assertEquals(new Value.Switch(false), Descriptions.value(base, "raw"));
        assertEquals(Optional.empty(), Descriptions.find(base, "channel"));
        assertEquals(Optional.empty(), Descriptions.find(base, "wrap_mode"));
        Value.Content content = assertInstanceOf(Value.Content.class, Descriptions.value(base, "filename"));
        assertEquals("png", content.ending());
        assertArrayEquals(Base64.getDecoder().decode(PNG), content.bytes());

        ObjectDescription roughness = Descriptions.nested(p, "roughness");
        assertEquals("bitmap", roughness.type());
        assertEquals("g", Descriptions.text(roughness, "channel"));
        assertEquals(new Value.Switch(true), Descriptions.value(roughness, "raw"));
        assertEquals("nearest", Descriptions.text(roughness, "filter_type"));
        assertEquals("clamp", Descriptions.text(roughness, "wrap_mode"));
        assertEquals("mirror", Descriptions.text(roughness, "wrap_mode_v"));
        ObjectDescription metallic = Descriptions.nested(p, "metallic");
        assertEquals(new Value.RealNumber(0.5), Descriptions.value(metallic, "scale"));
        assertEquals("b", Descriptions.text(Descriptions.child(metallic, ObjectKind.TEXTURE), "channel"));
    }

    @Test
    void vertexColorsMultiplyTheBaseColor() throws IOException {
        ObjectDescription shape = read(
                        "'POSITION':0,'TEXCOORD_0':1,'COLOR_0':2",
                        "{'pbrMetallicRoughness':{'baseColorTexture':{'index':0}}}")
                .only(ObjectKind.SHAPE);
        ObjectDescription p = Descriptions.child(Descriptions.child(shape, ObjectKind.BSDF), ObjectKind.BSDF);
        ObjectDescription product = Descriptions.nested(p, "base_color");
        assertEquals("bitmap", Descriptions.nested(product, "first").type());
        assertEquals("mesh_attribute", Descriptions.nested(product, "second").type());
        assertArrayEquals(
                new float[] {1, 0, 0, 0, 1, 0, 0, 0, 1},
                Descriptions.mesh(shape).colors());
    }

    @Test
    void alphaModes() throws IOException {
        String pbr = "'pbrMetallicRoughness':{'baseColorFactor':[1,1,1,0.75],'baseColorTexture':{'index':0}}";
        assertEquals("twosided", bsdf("{" + pbr + "}").type());

        ObjectDescription blend = bsdf("{'alphaMode':'BLEND'," + pbr + "}");
        assertEquals("mask", blend.type());
        ObjectDescription opacity = Descriptions.nested(blend, "opacity");
        assertEquals(new Value.RealNumber(0.75), Descriptions.value(opacity, "scale"));
        ObjectDescription alpha = Descriptions.child(opacity, ObjectKind.TEXTURE);
        assertEquals("opacity", Descriptions.text(alpha, "channel"));
        assertEquals(new Value.Switch(true), Descriptions.value(alpha, "raw"));
        assertEquals("twosided", Descriptions.child(blend, ObjectKind.BSDF).type());

        ObjectDescription mask = bsdf("{'alphaMode':'MASK','alphaCutoff':0.3," + pbr + "}");
        ObjectDescription threshold = Descriptions.nested(mask, "opacity");
        assertEquals("threshold", threshold.type());
        assertEquals(0.3, Descriptions.number(threshold, "cutoff"));
        assertEquals("scaled", Descriptions.nested(threshold, "value").type());

        // Without a texture it is decided here.
        String half = "'pbrMetallicRoughness':{'baseColorFactor':[1,1,1,0.5]}";
        assertEquals("twosided", bsdf("{'alphaMode':'MASK'," + half + "}").type());
        assertEquals(0, Descriptions.number(bsdf("{'alphaMode':'MASK','alphaCutoff':0.6," + half + "}"), "opacity"));
    }

    @Test
    void emission() throws IOException {
        ObjectDescription shape = read(
                        "'POSITION':0,'TEXCOORD_0':1",
                        "{'emissiveFactor':[1,0.5,0],'extensions':{'KHR_materials_emissive_strength':"
                                + "{'emissiveStrength':4}},'emissiveTexture':{'index':0}}")
                .only(ObjectKind.SHAPE);
        ObjectDescription area = Descriptions.child(shape, ObjectKind.EMITTER);
        assertEquals("area", area.type());
        ObjectDescription radiance = Descriptions.nested(area, "radiance");
        assertEquals(new Value.Color(4, 2, 0), Descriptions.value(radiance, "scale"));
        assertEquals(
                new Value.Switch(false), Descriptions.value(Descriptions.child(radiance, ObjectKind.TEXTURE), "raw"));
        assertEquals(
                List.of(),
                Descriptions.children(
                        read("'POSITION':0", "{'emissiveFactor':[0,0,0]}").only(ObjectKind.SHAPE), ObjectKind.EMITTER));
    }

    @Test
    void unlitSurfacesEmitTheirColor() throws IOException {
        ObjectDescription shape = read(
                        "'POSITION':0",
                        "{'pbrMetallicRoughness':{'baseColorFactor':[0.1,0.2,0.3,1]},"
                                + "'extensions':{'KHR_materials_unlit':{}}}")
                .only(ObjectKind.SHAPE);
        assertEquals(
                new Value.Color(0.1, 0.2, 0.3),
                Descriptions.value(Descriptions.child(shape, ObjectKind.EMITTER), "radiance"));
        ObjectDescription black = Descriptions.child(shape, ObjectKind.BSDF);
        assertEquals("diffuse", black.type());
        assertEquals(0, Descriptions.number(black, "reflectance"));
    }

    /** Both sides of what reflects look alike, as light must meet the same on its way there and back. */
    @Test
    void sidesDoNotDependOnDoubleSided() throws IOException {
        for (String sides : List.of("", "'doubleSided':false", "'doubleSided':true")) {
            assertEquals("twosided", bsdf("{" + sides + "}").type());
        }
        String unlit = "{'doubleSided':true,'extensions':{'KHR_materials_unlit':{}}}";
        assertEquals(
                List.of("/materials/0 emits on the front of its surfaces only"),
                read("'POSITION':0", unlit).warnings());
    }

    @Test
    void normalMaps() throws IOException {
        ObjectDescription map = Descriptions.child(bsdf("{'normalTexture':{'index':0,'scale':0.5}}"), ObjectKind.BSDF);
        assertEquals("normalmap", map.type());
        assertEquals(0.5, Descriptions.number(map, "scale"));
        assertEquals("against_v", Descriptions.text(map, "green"));
        ObjectDescription texture = Descriptions.nested(map, "normalmap");
        assertEquals(new Value.Switch(true), Descriptions.value(texture, "raw"));
        assertEquals("principled", Descriptions.child(map, ObjectKind.BSDF).type());
    }

    /**
     * The example of KHR_texture_transform: with a rotation of 90° and this scale and offset, texture coordinates in the unit
     * square look up the lower left quarter of the image.
     */
    @Test
    void textureTransforms() throws IOException {
        ObjectDescription p = principled("{'pbrMetallicRoughness':{'baseColorTexture':{'index':0,'extensions':"
                + "{'KHR_texture_transform':{'offset':[0,1],'rotation':1.5707963267948966,'scale':[0.5,0.5]}}}}}");
        Matrix4d m = ((Value.Transform) Descriptions.value(Descriptions.nested(p, "base_color"), "to_uv")).matrix();
        for (double[] uv : new double[][] {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {0.3, 0.6}}) {
            double u = m.m00 * uv[0] + m.m01 * uv[1] + m.m03;
            double v = m.m10 * uv[0] + m.m11 * uv[1] + m.m13;
            assertEquals(0.5 * uv[1], u, 1e-12);
            assertEquals(1 - 0.5 * uv[0], v, 1e-12);
        }
    }

    /** A textureInfo names its texture coordinates, and KHR_texture_transform, if it names some, goes before it. */
    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            {'index':0}                                                                           | 0
            {'index':0,'texCoord':1}                                                              | 1
            {'index':0,'texCoord':1,'extensions':{'KHR_texture_transform':{'scale':[2,2]}}}       | 1
            {'index':0,'extensions':{'KHR_texture_transform':{'texCoord':1}}}                     | 1
            {'index':0,'texCoord':1,'extensions':{'KHR_texture_transform':{'texCoord':0}}}        | 0
            """, quoteCharacter = '`')
    void texturesNameTheirCoordinates(String info, int set) throws IOException {
        Descriptions read = read(
                "'POSITION':0,'TEXCOORD_0':1,'TEXCOORD_1':3",
                "{'normalTexture':" + info + ",'pbrMetallicRoughness':{'baseColorTexture':" + info + "}}");
        assertEquals(List.of(), read.warnings());
        ObjectDescription shape = read.only(ObjectKind.SHAPE);
        assertArrayEquals(
                new float[] {0, 0, 5, 0, 0, 5}, Descriptions.mesh(shape).secondUvs());
        ObjectDescription map = Descriptions.child(Descriptions.child(shape, ObjectKind.BSDF), ObjectKind.BSDF);
        assertUsesSet(set, Descriptions.nested(map, "normalmap"));
        ObjectDescription principled = Descriptions.child(map, ObjectKind.BSDF);
        assertUsesSet(set, Descriptions.nested(principled, "base_color"));
    }

    /** The first set is what a texture uses without a word. */
    private static void assertUsesSet(int set, ObjectDescription texture) {
        boolean named = texture.properties().stream().anyMatch(p -> p.name().equals("uv_set"));
        assertEquals(set != 0, named);
        if (named) {
            assertEquals(new Value.WholeNumber(set), Descriptions.value(texture, "uv_set"));
        }
    }

    @Test
    void thirdTextureCoordinatesAreLeftOut() throws IOException {
        Descriptions read = read(
                "'POSITION':0,'TEXCOORD_0':1",
                "{'pbrMetallicRoughness':{'baseColorTexture':{'index':0,'texCoord':2}}}");
        assertEquals(
                List.of("/materials/0/pbrMetallicRoughness/baseColorTexture is left out:"
                        + " only the texture coordinates 0 and 1 are supported, not 2"),
                read.warnings());
    }

    @Test
    void texturesNeedTheirCoordinates() throws IOException {
        Descriptions read = read("'POSITION':0", "{'pbrMetallicRoughness':{'baseColorTexture':{'index':0}}}");
        assertEquals(
                List.of("/materials/0/pbrMetallicRoughness/baseColorTexture is left out where a mesh lacks TEXCOORD_0"),
                read.warnings());
    }

    @Test
    void usesOfATextureAreDescribedOnce() throws IOException {
        GltfText text = text(
                        "'POSITION':0,'TEXCOORD_0':1",
                        "{'pbrMetallicRoughness':{'baseColorTexture':{'index':0}}},"
                                + "{'pbrMetallicRoughness':{'baseColorTexture':{'index':0}}}")
                .with(
                        "meshes",
                        "[{'primitives':[{'attributes':{'POSITION':0,'TEXCOORD_0':1},'material':0},"
                                + "{'attributes':{'POSITION':0,'TEXCOORD_0':1},'material':1}]}]");
        List<ObjectDescription> textures = Descriptions.read(text, folder).all(ObjectKind.SHAPE).stream()
                .map(s -> Descriptions.child(Descriptions.child(s, ObjectKind.BSDF), ObjectKind.BSDF))
                .map(p -> Descriptions.nested(p, "base_color"))
                .toList();
        assertEquals(2, textures.size());
        assertSame(textures.get(0), textures.get(1));
    }

    @Test
    void refractiveIndexAndSpecular() throws IOException {
        assertEquals(
                1.33,
                Descriptions.number(principled("{'extensions':{'KHR_materials_ior':{'ior':1.33}}}"), "eta"),
                1e-12);
        // Half the reflectance of 4 %: ((η − 1)/(η + 1))² = 0.02.
        double eta = Descriptions.number(
                principled("{'extensions':{'KHR_materials_specular':{'specularFactor':0.5}}}"), "eta");
        assertEquals(0.02, Math.pow((eta - 1) / (eta + 1), 2), 1e-12);
    }

    @Test
    void transmissionWithVolume() throws IOException {
        ObjectDescription glass = bsdf("{'pbrMetallicRoughness':{'roughnessFactor':0,'metallicFactor':0},'extensions':{"
                + "'KHR_materials_transmission':{'transmissionFactor':0.9},'KHR_materials_volume':{'thicknessFactor':2,"
                + "'attenuationDistance':1,'attenuationColor':[1,0.5,0.1]}}}");
        assertEquals("principled", glass.type());
        assertEquals(0.9, Descriptions.number(glass, "spec_trans"));
        Value.Color color = (Value.Color) Descriptions.value(glass, "base_color");
        assertEquals(1, color.r(), 1e-12);
        assertEquals(0.25, color.g(), 1e-12);
        assertEquals(0.01, color.b(), 1e-12);
    }

    @Test
    void transmissionWithoutVolumeIsThin() throws IOException {
        ObjectDescription pane =
                bsdf("{'pbrMetallicRoughness':{'roughnessFactor':0.2,'metallicFactor':0},'extensions':{"
                        + "'KHR_materials_transmission':{'transmissionFactor':0.9}}}");
        assertEquals("principledthin", pane.type());
        assertEquals(0.9, Descriptions.number(pane, "spec_trans"));
        assertEquals(0.2, Descriptions.number(pane, "roughness"));
    }

    @Test
    void clearcoatSheenAndAnisotropy() throws IOException {
        ObjectDescription p = principled("{'pbrMetallicRoughness':{'roughnessFactor':0.5},'extensions':{"
                + "'KHR_materials_clearcoat':{'clearcoatFactor':0.7,'clearcoatRoughnessFactor':0.2},"
                + "'KHR_materials_sheen':{'sheenColorFactor':[0.5,0.5,0.5]},"
                + "'KHR_materials_anisotropy':{'anisotropyStrength':0.5}}}");
        assertEquals(0.7, Descriptions.number(p, "clearcoat"));
        assertEquals((0.1 - 0.04) / 0.099, Descriptions.number(p, "clearcoat_gloss"), 1e-12);
        assertEquals(0.5, Descriptions.number(p, "sheen"), 1e-6);
        // α across is 0.25, along it is 0.25 + 0.75 · 0.25; the principled material makes them α/a and αa, a² = 1 − 0.9
        // x.
        double a = Math.sqrt(1 - 0.9 * Descriptions.number(p, "anisotropic"));
        double alpha = Math.pow(Descriptions.number(p, "roughness"), 2);
        assertEquals(0.4375, alpha / a, 1e-12);
        assertEquals(0.25, alpha * a, 1e-12);
        assertTrue(a < 1);
    }
}
