package org.daybreak.scenes.gltf;

import static org.daybreak.scenes.gltf.GltfText.UNSIGNED_BYTE;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.daybreak.scenes.SceneReader;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Whatever is in a file: it is read, or it is refused with the exception of scene files. Seeds are fixed. */
class GltfMutationTest {
    private static final int MUTATIONS = 2000;
    private static final Pattern TOKEN =
            Pattern.compile("-?[0-9][0-9.eE+-]*|true|false|\"[A-Za-z_0-9]*\"|[\\[\\]{},:]");
    private static final List<String> HOSTILE = List.of(
            "0",
            "-1",
            "1",
            "3",
            "0.5",
            "255",
            "2147483647",
            "2147483648",
            "1e9",
            "1e308",
            "1e999",
            "-1e-300",
            "null",
            "true",
            "\"\"",
            "\"POSITION\"",
            "\"MASK\"",
            "[]",
            "{}",
            "[0]",
            "{\"index\":0}",
            "{\"extensions\":{}}");

    @TempDir
    Path folder;

    private GltfText scene;

    /** Something of everything. */
    @BeforeEach
    void makeScene() {
        scene = new GltfText()
                .floats("VEC3", 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0)
                .floats("VEC3", 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1)
                .floats("VEC2", 0, 0, 1, 0, 1, 1, 0, 1)
                .numbers(UNSIGNED_BYTE, "VEC4", true, 255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 9, 1, 2, 3, 4)
                .numbers(UNSIGNED_BYTE, "SCALAR", false, 0, 1, 2, 2, 3, 0)
                .numbers(UNSIGNED_BYTE, "VEC4", false, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0)
                .floats("VEC4", 1, 0, 0, 0, 0.5, 0.5, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0)
                .floats("VEC3", 1, 2, 3, 4, 5, 6);
        int indices = scene.view(new byte[] {1, 3}, 0);
        scene.accessor("{'bufferView':0,'componentType':5126,'count':4,'type':'VEC3','sparse':{'count':2,'indices':"
                + "{'bufferView':" + indices + ",'componentType':5121},'values':{'bufferView':1}}}");
        String texture = "{'index':0,'scale':0.5,'extensions':{'KHR_texture_transform':{'offset':[0.5,0],"
                + "'rotation':1,'scale':[2,2],'texCoord':0}}}";
        scene.with("extensionsUsed", "['KHR_texture_transform','KHR_lights_punctual','EXT_mesh_gpu_instancing']")
                .with("extensionsRequired", "['KHR_texture_transform']")
                .with(
                        "extensions",
                        "{'KHR_lights_punctual':{'lights':[{'type':'point','intensity':3},{'type':'spot',"
                                + "'spot':{'innerConeAngle':0.1,'outerConeAngle':0.5}},{'type':'directional'}]}}")
                .with("scene", "0")
                .with("scenes", "[{'nodes':[0,1,4]}]")
                .with(
                        "nodes",
                        "[{'mesh':0,'children':[2],'translation':[1,2,3],'rotation':[0,0,0,1],'scale':[1,2,3]},"
                                + "{'mesh':1,'skin':0},{'camera':0,'matrix':[1,0,0,0,0,1,0,0,0,0,1,0,0,0,5,1],'children':[3]},"
                                + "{'mesh':0,'weights':[0.25],'extensions':{'KHR_lights_punctual':{'light':1}}},"
                                + "{'mesh':2,'extensions':{'EXT_mesh_gpu_instancing':{'attributes':{'TRANSLATION':7}}}}]")
                .with("cameras", "[{'type':'perspective','perspective':{'yfov':0.7,'znear':0.1,'aspectRatio':1.5}}]")
                .with(
                        "meshes",
                        "[{'weights':[0.5],'primitives':[{'attributes':{'POSITION':0,'NORMAL':1,'TEXCOORD_0':2,"
                                + "'COLOR_0':3},'indices':4,'material':0,'targets':[{'POSITION':1}]}]},"
                                + "{'primitives':[{'attributes':{'POSITION':0,'NORMAL':1,'JOINTS_0':5,'WEIGHTS_0':6},"
                                + "'mode':6,'material':1}]},{'primitives':[{'attributes':{'POSITION':8},'mode':5}]}]")
                .with("skins", "[{'joints':[0,2]}]")
                .with("images", "[{'uri':'data:image/png;base64," + MaterialTest.PNG + "'}]")
                .with("samplers", "[{'magFilter':9729,'minFilter':9987,'wrapS':10497,'wrapT':33071}]")
                .with("textures", "[{'source':0,'sampler':0}]")
                .with(
                        "materials",
                        "[{'pbrMetallicRoughness':{'baseColorFactor':[1,0.5,0.5,0.9],'baseColorTexture':"
                                + texture + ",'metallicFactor':0.5,'roughnessFactor':0.3,'metallicRoughnessTexture':"
                                + texture
                                + "},'normalTexture':" + texture + ",'emissiveFactor':[1,1,0],'emissiveTexture':"
                                + texture
                                + ",'alphaMode':'MASK','alphaCutoff':0.25,'doubleSided':true,'extensions':{'KHR_materials_sheen':"
                                + "{'sheenColorFactor':[1,0,0]},'KHR_materials_clearcoat':{'clearcoatFactor':1}}},"
                                + "{'extensions':{'KHR_materials_transmission':{'transmissionFactor':1},'KHR_materials_volume':"
                                + "{'thicknessFactor':1,'attenuationDistance':2,'attenuationColor':[0.5,0.6,0.7]},"
                                + "'KHR_materials_ior':{'ior':1.4},'KHR_materials_anisotropy':{'anisotropyStrength':0.5}}}]");
    }

    /** True if the file is refused. */
    private boolean refused(byte[] bytes, String name) throws IOException {
        Path file = Files.write(folder.resolve(name), bytes);
        try {
            // Seconds, where reading takes milliseconds: this catches what would never end.
            assertTimeoutPreemptively(Duration.ofSeconds(60), () -> new SceneReader().load(file, Map.of()));
            return false;
        } catch (AssertionError e) {
            throw e;
        } catch (Throwable e) {
            assertEquals(SceneException.class, e.getClass(), () -> new String(bytes, StandardCharsets.ISO_8859_1));
            String message = String.valueOf(e.getMessage());
            assertTrue(message.startsWith(file.toString()), message);
            assertFalse(message.contains("Exception"), message);
            return true;
        }
    }

    private static void assertSome(int refused) {
        assertTrue(refused > MUTATIONS / 8 && refused < MUTATIONS, "refused: " + refused);
    }

    @Test
    void theSceneItselfIsRead() throws IOException {
        assertFalse(refused(scene.text().getBytes(StandardCharsets.UTF_8), "a.gltf"));
        assertFalse(refused(scene.binary(), "a.glb"));
    }

    @Test
    void editsOfTheJson() throws IOException {
        String text = scene.text();
        List<int[]> tokens = new ArrayList<>();
        Matcher matcher = TOKEN.matcher(text);
        while (matcher.find()) {
            tokens.add(new int[] {matcher.start(), matcher.end()});
        }
        SplittableRandom random = new SplittableRandom(11);
        int refused = 0;
        for (int i = 0; i < MUTATIONS; i++) {
            int[] token = tokens.get(random.nextInt(tokens.size()));
            int[] other = tokens.get(random.nextInt(tokens.size()));
            String replacement = random.nextInt(4) == 0
                    ? text.substring(other[0], other[1])
                    : HOSTILE.get(random.nextInt(HOSTILE.size()));
            String edited = text.substring(0, token[0]) + replacement + text.substring(token[1]);
            refused += refused(edited.getBytes(StandardCharsets.UTF_8), "a.gltf") ? 1 : 0;
        }
        assertSome(refused);
    }

    @Test
    void bytesOfABinaryFile() throws IOException {
        byte[] good = scene.binary();
        SplittableRandom random = new SplittableRandom(12);
        int refused = 0;
        for (int i = 0; i < MUTATIONS; i++) {
            byte[] bytes = good.clone();
            int flips = 1 + random.nextInt(4);
            for (int f = 0; f < flips; f++) {
                bytes[random.nextInt(bytes.length)] ^= (byte) (1 << random.nextInt(8));
            }
            if (random.nextInt(20) == 0) {
                bytes = java.util.Arrays.copyOf(bytes, random.nextInt(bytes.length));
            }
            refused += refused(bytes, "a.glb") ? 1 : 0;
        }
        assertSome(refused);
    }

    /** Only numbers of the buffer: positions, indices, joints and weights of any value. */
    @Test
    void numbersOfTheBuffer() throws IOException {
        byte[] good = scene.binary();
        ByteBuffer view = ByteBuffer.wrap(good).order(ByteOrder.LITTLE_ENDIAN);
        int start = 28 + view.getInt(12);
        SplittableRandom random = new SplittableRandom(13);
        int refused = 0;
        for (int i = 0; i < MUTATIONS; i++) {
            byte[] bytes = good.clone();
            int at = start + random.nextInt(bytes.length - start - 4);
            ByteBuffer.wrap(bytes).putInt(at, random.nextInt());
            refused += refused(bytes, "a.glb") ? 1 : 0;
        }
        assertTrue(refused > 0 && refused < MUTATIONS, "refused: " + refused);
    }
}
