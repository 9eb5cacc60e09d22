package org.daybreak.scenes.gltf;

import static org.daybreak.scenes.gltf.GltfText.FLOAT;
import static org.daybreak.scenes.gltf.GltfText.UNSIGNED_BYTE;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.daybreak.scenes.description.ProblemList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/** Wrong files are refused with the place and the reason. */
class GltfErrorsTest {
    private static final double[] TRIANGLE = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    private static final String ACCESSOR = "{'bufferView':0,'componentType':5126,'count':3,'type':'VEC3'";

    @TempDir
    Path folder;

    /** A triangle whose position accessor is given. */
    private static GltfText accessor(String json) {
        GltfText text = GltfText.mesh("'POSITION':0", "");
        text.view(GltfText.bytes(FLOAT, TRIANGLE), 0);
        text.accessor(json);
        return text;
    }

    private static GltfText sparse(String json, double... indices) {
        GltfText text = GltfText.mesh("'POSITION':0", "");
        text.view(GltfText.bytes(FLOAT, TRIANGLE), 0);
        text.view(GltfText.bytes(UNSIGNED_BYTE, indices), 0);
        text.accessor(ACCESSOR + ",'sparse':" + json + "}");
        return text;
    }

    private static GltfText nodes(String json) {
        return new GltfText().with("nodes", json);
    }

    static Stream<Arguments> files() {
        String sparse = "{'count':2,'indices':{'bufferView':1,'componentType':5121},'values':{'bufferView':0}}";
        return Stream.of(
                arguments(new GltfText().with("asset", "{}"), "/asset needs the property 'version'"),
                arguments(
                        new GltfText().with("asset", "{'version':'1.0'}"),
                        "/asset/version is 1.0 but only glTF 2.0 is supported"),
                arguments(
                        new GltfText().with("extensionsRequired", "['KHR_texture_transfrom']"),
                        "/extensionsRequired/0 requires the extension KHR_texture_transfrom, which is not supported;"
                                + " supported are " + String.join(", ", Extensions.SUPPORTED)
                                + "; did you mean 'KHR_texture_transform'?"),
                arguments(
                        accessor(ACCESSOR + ",'byteOffset':4}"),
                        "/accessors/0 needs 40 bytes of a buffer view of 36 bytes"),
                arguments(
                        accessor("{'bufferView':0,'componentType':5126,'count':2147483647,'type':'VEC3'}"),
                        "/accessors/0 needs 25769803764 bytes of a buffer view of 36 bytes"),
                arguments(
                        accessor("{'bufferView':7,'componentType':5126,'count':3,'type':'VEC3'}"),
                        "/accessors/0/bufferView refers to bufferViews/7 but there is 1"),
                arguments(
                        accessor("{'bufferView':0,'componentType':5124,'count':3,'type':'VEC3'}"),
                        "/accessors/0/componentType must be one of 5120, 5121, 5122, 5123, 5125, 5126 but is 5124"),
                arguments(
                        accessor("{'bufferView':0,'componentType':5126,'count':3,'type':'VEC2'}"),
                        "/meshes/0/primitives/0/attributes/POSITION must be of type VEC3 but /accessors/0 is of type VEC2"),
                arguments(
                        accessor("{'bufferView':0,'componentType':5126,'count':0,'type':'VEC3'}"),
                        "/accessors/0/count must be from 1 to 2147483647 but is 0"),
                arguments(
                        accessor("{'bufferView':0,'componentType':5126,'count':1.5,'type':'VEC3'}"),
                        "/accessors/0/count must be an integer but is 1.5"),
                arguments(
                        accessor("{'bufferView':0,'componentType':5126,'count':3,'type':'VEC'}"),
                        "/accessors/0/type must be one of MAT2, MAT3, MAT4, SCALAR, VEC2, VEC3, VEC4 but is 'VEC';"
                                + " did you mean 'VEC2'?"),
                arguments(
                        accessor("{'componentType':5126,'count':2147483647,'type':'VEC3'}"),
                        "/meshes/0/primitives/0 is one too many: the meshes have more corners and vertices together than"
                                + " a file of this size may have"),
                arguments(
                        sparse(sparse, 2, 1),
                        "/accessors/0/sparse/indices has 1 at position 1; indices must rise and be less than the"
                                + " accessor's count, 3"),
                arguments(
                        sparse(sparse, 1, 3),
                        "/accessors/0/sparse/indices has 3 at position 1; indices must rise and be less than the"
                                + " accessor's count, 3"),
                arguments(
                        sparse(sparse.replace("'count':2", "'count':4"), 1, 2, 3, 4),
                        "/accessors/0/sparse/count must be from 1 to 3 but is 4"),
                arguments(
                        GltfText.mesh("'POSITION':0", ",'indices':1")
                                .floats("VEC3", TRIANGLE)
                                .numbers(UNSIGNED_BYTE, "SCALAR", false, 0, 1, 3),
                        "/meshes/0/primitives/0/indices leads to index 3 at position 2 but there are 3 vertices"),
                arguments(
                        GltfText.mesh("'POSITION':0", "").floats("VEC3", 0, 0, 0, 1, 0, 0, 0, Double.NaN, 0),
                        "/accessors/0 has an element that is not finite, number 2"),
                arguments(
                        GltfText.mesh("'POSITION':0,'NORMAL':1", "")
                                .floats("VEC3", TRIANGLE)
                                .floats("VEC3", 0, 0, 1),
                        "/meshes/0/primitives/0/attributes/NORMAL leads to 1 elements but there are 3 positions"),
                arguments(
                        GltfText.mesh("'POSITION':0", ",'mode':7").floats("VEC3", TRIANGLE),
                        "/meshes/0/primitives/0/mode must be from 0 to 6 but is 7"),
                arguments(nodes("[{'children':[1]},{'children':[0]}]"), "/nodes/0 is its own ancestor"),
                arguments(nodes("[{'children':[0]}]"), "/nodes/0 is its own ancestor"),
                arguments(
                        nodes("[{'children':[2]},{'children':[2]},{}]"),
                        "/nodes/1/children/0 makes node 2 a child of node 1, but it is one of node 0 already"),
                arguments(nodes("[{'children':[5]}]"), "/nodes/0/children/0 refers to nodes/5 but there is 1"),
                arguments(
                        nodes("[{'matrix':[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],'scale':[1,1,1]}]"),
                        "/nodes/0 must not have both 'matrix' and 'scale'"),
                arguments(
                        nodes("[{'translation':[0,0,'x']}]"),
                        "/nodes/0/translation/2 must be a number but is a string"),
                arguments(nodes("[{'translation':[0,0]}]"), "/nodes/0/translation must have 3 numbers but has 2"),
                arguments(nodes("[{'rotation':[0,0,0,0]}]"), "/nodes/0/rotation must be a unit quaternion but is 0"),
                arguments(nodes("[{'translation':[0,0,1e999]}]"), "/nodes/0/translation/2 is too large a number"),
                arguments(
                        MaterialTest.text("'POSITION':0", "{'alphaMode':'MASKED'}"),
                        "/materials/0/alphaMode must be one of OPAQUE, MASK, BLEND but is 'MASKED'; did you mean"
                                + " 'MASK'?"),
                arguments(
                        MaterialTest.text("'POSITION':0", "{'pbrMetallicRoughness':{'metallicFactor':2}}"),
                        "/materials/0/pbrMetallicRoughness/metallicFactor must be from 0 to 1 but is 2"),
                arguments(
                        MaterialTest.text(
                                        "'POSITION':0,'TEXCOORD_0':1",
                                        "{'pbrMetallicRoughness':{'baseColorTexture':{'index':0}}}")
                                .with("images", "[{'uri':'https://example.org/a.png'}]"),
                        "/images/0/uri must be a relative file name, not 'https://example.org/a.png'"),
                arguments(
                        MaterialTest.text(
                                        "'POSITION':0,'TEXCOORD_0':1",
                                        "{'pbrMetallicRoughness':{'baseColorTexture':{'index':0}}}")
                                .with("images", "[{'uri':'data:image/ktx2;base64,AAAA'}]"),
                        "/images/0/uri is neither a PNG nor a JPEG image, but image/ktx2"));
    }

    @ParameterizedTest
    @MethodSource("files")
    void areRefused(GltfText text, String message) throws IOException {
        assertEquals(List.of(message), Descriptions.errors(text.write(folder)));
    }

    @Test
    void allErrorsOfAFileAreFound() throws IOException {
        GltfText text = new GltfText()
                .with("cameras", "[{'type':'perspective','perspective':{'yfov':9,'znear':1}}]")
                .with("meshes", "[{'primitives':[{'attributes':{'POSITION':0}},{}]}]")
                .with("nodes", "[{'mesh':0},{'camera':0}]");
        assertEquals(
                List.of(
                        "/meshes/0/primitives/0/attributes/POSITION refers to accessors/0 but there are none",
                        "/meshes/0/primitives/1 needs the property 'attributes'",
                        "/cameras/0/perspective/yfov must be greater than 0 and less than π but is 9.0"),
                Descriptions.errors(text.write(folder)));
    }

    @Test
    void errorsNameFileLineAndColumn() throws IOException {
        Path file = Files.writeString(
                folder.resolve("a.gltf"), "{\n \"asset\": {\"version\": \"2.0\"},\n  \"nodes\": [{\"mesh\": 3}]\n}");
        ProblemList problems = new ProblemList();
        GltfReader.read(file, problems);
        assertEquals(
                file + ":3:22: /nodes/0/mesh refers to meshes/3 but there are none",
                problems.errors().get(0).toString());
    }

    @ParameterizedTest
    @MethodSource("texts")
    void damagedJsonIsRefusedWithItsPlace(String text, String start) throws IOException {
        Path file = Files.writeString(folder.resolve("a.gltf"), text);
        ProblemList problems = new ProblemList();
        assertTrue(GltfReader.read(file, problems).isEmpty());
        String message = problems.errors().get(0).toString();
        assertTrue(message.startsWith(file + start), message);
    }

    static Stream<Arguments> texts() {
        return Stream.of(
                arguments("", ":1:1: the JSON is damaged: the document is empty"),
                arguments("{\n\"a\" 1}", ":2:"),
                arguments("{\"a\":1,\"a\":2}", ":1:"),
                arguments("{} {}", ":1:"),
                arguments("[", ":1:"),
                arguments("[".repeat(100_000), ":1:"),
                arguments("3", ":1:1: / must be an object but is a number"));
    }

    @Test
    void buffersMustBeThereAndLongEnough() throws IOException {
        GltfText text = GltfText.mesh("'POSITION':0", "").floats("VEC3", TRIANGLE);
        Path file = text.writeSeparate(folder, "a.bin", "a.bin");
        Files.write(folder.resolve("a.bin"), new byte[35]);
        assertEquals(List.of("/buffers/0/byteLength is 36 but there are only 35 bytes"), Descriptions.errors(file));
        Files.delete(folder.resolve("a.bin"));
        assertEquals(
                List.of("/buffers/0/uri names the file " + folder.resolve("a.bin") + ", which does not exist"),
                Descriptions.errors(file));
        Files.createDirectory(folder.resolve("a.bin"));
        assertEquals(
                List.of("/buffers/0/uri names " + folder.resolve("a.bin") + ", which is no regular file"),
                Descriptions.errors(file));
        for (String uri : List.of("/dev/zero", "file:///dev/zero", "data:,x", "a%zz", "a\\u0000b")) {
            Path bad = text.writeSeparate(folder, "b.bin", uri);
            assertEquals(1, Descriptions.errors(bad).size(), uri);
        }
    }

    @Test
    void damagedBinaryFilesAreRefused() throws IOException {
        byte[] good = GltfText.mesh("'POSITION':0", "").floats("VEC3", TRIANGLE).binary();
        assertEquals(List.of(), binaryErrors(good));
        assertEquals(
                List.of("the file is cut off: its header says " + good.length + " bytes but it has 100"),
                binaryErrors(java.util.Arrays.copyOf(good, 100)));
        assertEquals(List.of("the file ends within its header"), binaryErrors(java.util.Arrays.copyOf(good, 16)));
        assertEquals(
                List.of("binary glTF of version 1 is not supported, only version 2"), binaryErrors(with(good, 4, 1)));
        assertEquals(List.of("chunk 0 reaches beyond the end of the file"), binaryErrors(with(good, 12, -1)));
        assertEquals(List.of("the first chunk must be JSON"), binaryErrors(with(good, 16, 7)));
    }

    private static byte[] with(byte[] bytes, int at, int value) {
        byte[] out = bytes.clone();
        ByteBuffer.wrap(out).order(ByteOrder.LITTLE_ENDIAN).putInt(at, value);
        return out;
    }

    private List<String> binaryErrors(byte[] bytes) throws IOException {
        return Descriptions.errors(Files.write(folder.resolve("a.glb"), bytes));
    }
}
