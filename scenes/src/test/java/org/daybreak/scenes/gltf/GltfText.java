package org.daybreak.scenes.gltf;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Writes small glTF files: one buffer, the accessors into it, and whatever JSON a test adds. */
final class GltfText {
    static final int BYTE = 5120;
    static final int UNSIGNED_BYTE = 5121;
    static final int SHORT = 5122;
    static final int UNSIGNED_SHORT = 5123;
    static final int UNSIGNED_INT = 5125;
    static final int FLOAT = 5126;

    private final ByteArrayOutputStream buffer = new ByteArrayOutputStream();
    private final List<String> views = new ArrayList<>();
    private final List<String> accessors = new ArrayList<>();
    private final Map<String, String> members = new LinkedHashMap<>();

    GltfText() {
        members.put("asset", "{\"version\":\"2.0\"}");
    }

    /** A scene that shows mesh 0, whose only primitive has these attributes and further members. */
    static GltfText mesh(String attributes, String more) {
        return new GltfText()
                .with("meshes", "[{'primitives':[{'attributes':{" + attributes + "}" + more + "}]}]")
                .with("nodes", "[{'mesh':0}]");
    }

    /** A scene with something of everything. */
    static GltfText everything() {
        GltfText scene = new GltfText()
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
        return scene.with("extensionsUsed", "['KHR_texture_transform','KHR_lights_punctual','EXT_mesh_gpu_instancing']")
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

    /** Sets a top-level member; single quotes stand for double ones. */
    GltfText with(String name, String json) {
        members.put(name, json.replace('\'', '"'));
        return this;
    }

    /** Appends bytes and a view of them. */
    int view(byte[] bytes, int stride) {
        while (buffer.size() % 4 != 0) {
            buffer.write(0);
        }
        views.add("{\"buffer\":0,\"byteOffset\":" + buffer.size() + ",\"byteLength\":" + bytes.length
                + (stride == 0 ? "" : ",\"byteStride\":" + stride) + "}");
        buffer.writeBytes(bytes);
        return views.size() - 1;
    }

    /** Appends an accessor as it is; single quotes stand for double ones. */
    int accessor(String json) {
        accessors.add(json.replace('\'', '"'));
        return accessors.size() - 1;
    }

    /** Appends numbers and an accessor to them. */
    GltfText numbers(int componentType, String type, boolean normalized, double... values) {
        int width = type.equals("SCALAR") ? 1 : type.equals("MAT4") ? 16 : type.charAt(3) - '0';
        accessor("{'bufferView':" + view(bytes(componentType, values), 0) + ",'componentType':" + componentType
                + ",'count':" + values.length / width + ",'type':'" + type + "'"
                + (normalized ? ",'normalized':true" : "") + "}");
        return this;
    }

    GltfText floats(String type, double... values) {
        return numbers(FLOAT, type, false, values);
    }

    static byte[] bytes(int componentType, double... values) {
        ByteBuffer out = ByteBuffer.allocate(4 * values.length).order(ByteOrder.LITTLE_ENDIAN);
        for (double value : values) {
            switch (componentType) {
                case BYTE, UNSIGNED_BYTE -> out.put((byte) value);
                case SHORT, UNSIGNED_SHORT -> out.putShort((short) value);
                case UNSIGNED_INT -> out.putInt((int) (long) value);
                default -> out.putFloat((float) value);
            }
        }
        byte[] bytes = new byte[out.position()];
        out.flip().get(bytes);
        return bytes;
    }

    /**
     * The document.
     *
     * @param uri what is put behind the length of the buffer
     */
    String json(String uri) {
        Map<String, String> all = new LinkedHashMap<>(members);
        if (buffer.size() > 0) {
            all.put("buffers", "[{\"byteLength\":" + buffer.size() + uri + "}]");
            all.put("bufferViews", views.toString());
        }
        if (!accessors.isEmpty()) {
            all.put("accessors", accessors.toString());
        }
        StringBuilder out = new StringBuilder("{");
        all.forEach((name, value) -> out.append(out.length() > 1 ? ",\n" : "\n")
                .append('"')
                .append(name)
                .append("\":")
                .append(value));
        return out.append("\n}\n").toString();
    }

    /** The bytes of the buffer. */
    byte[] buffer() {
        return buffer.toByteArray();
    }

    /** The text file, with the buffer inside. */
    String text() {
        return json(",\"uri\":\"data:application/octet-stream;base64,"
                + Base64.getEncoder().encodeToString(buffer.toByteArray()) + "\"");
    }

    Path write(Path folder) throws IOException {
        return Files.writeString(folder.resolve("model.gltf"), text());
    }

    /** Writes text and buffer as two files. */
    Path writeSeparate(Path folder, String bufferName, String uri) throws IOException {
        Files.write(folder.resolve(bufferName), buffer.toByteArray());
        return Files.writeString(folder.resolve("model.gltf"), json(",\"uri\":\"" + uri + "\""));
    }

    /** The binary file. */
    byte[] binary() {
        return binary(json(""), buffer.toByteArray());
    }

    /** A binary file of a document and a buffer. */
    static byte[] binary(String json, byte[] buffer) {
        byte[] text = padded(json.getBytes(StandardCharsets.UTF_8), ' ');
        byte[] data = padded(buffer, 0);
        ByteBuffer out = ByteBuffer.allocate(28 + text.length + data.length).order(ByteOrder.LITTLE_ENDIAN);
        out.putInt(0x46546c67).putInt(2).putInt(out.capacity());
        out.putInt(text.length).putInt(0x4e4f534a).put(text);
        out.putInt(data.length).putInt(0x004e4942).put(data);
        return out.array();
    }

    private static byte[] padded(byte[] bytes, int filler) {
        byte[] out = java.util.Arrays.copyOf(bytes, (bytes.length + 3) / 4 * 4);
        java.util.Arrays.fill(out, bytes.length, out.length, (byte) filler);
        return out;
    }
}
