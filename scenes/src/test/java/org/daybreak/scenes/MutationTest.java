package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.Map;
import java.util.SplittableRandom;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.mesh.CurveReader;
import org.daybreak.scenes.mesh.MeshFormatException;
import org.daybreak.scenes.mesh.ObjReader;
import org.daybreak.scenes.mesh.PlyReader;
import org.daybreak.scenes.mesh.SerializedReader;
import org.daybreak.scenes.mesh.SerializedReaderTest;
import org.daybreak.scenes.mesh.StlReader;
import org.daybreak.scenes.mesh.StlReaderTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Whatever is in a file: it is read, or it is refused in the documented way. Seeds are fixed. */
class MutationTest {
    private static final int MUTATIONS = 1000;
    private static final String SCENE = "<?xml version='1.0' encoding='utf-8'?>\n<scene version='3.0.0'>\n"
            + "<default name='n' value='8'/><integrator type='path'><integer name='max_depth' value='-1'/></integrator>\n"
            + "<sensor type='thinlens'><float name='fov' value='40'/><float name='aperture_radius' value='0.1'/>"
            + "<transform name='to_world'><lookat origin='0,0,5' target='0,0,0' up='0,1,0'/></transform>"
            + "<sampler type='independent'><integer name='sample_count' value='$n'/></sampler>"
            + "<film type='hdrfilm'><integer name='width' value='$n'/><rfilter type='gaussian'/></film></sensor>\n"
            + "<bsdf type='mask' id='m'><float name='opacity' value='0.5'/><bsdf type='roughconductor'>"
            + "<rgb name='eta' value='1,2,3'/><float name='alpha' value='.2'/></bsdf></bsdf>\n"
            + "<shape type='shapegroup' id='g'><shape type='sphere'><point name='center' x='1' y='2' z='3'/><ref id='m'/>"
            + "</shape></shape><shape type='instance'><ref id='g'/><transform name='to_world'><rotate y='1' angle='30'/>"
            + "<scale value='2'/><matrix value='1 0 0 0 1 0 0 0 1'/></transform></shape>\n"
            + "<shape type='ply'><string name='filename' value='t.ply'/><emitter type='area'/></shape>"
            + "<emitter type='spot'><spectrum name='intensity' value='3'/></emitter><!-- end -->\n</scene>\n";
    private static final String OLD_SCENE =
            "<scene version='0.5.0'><integrator type='bdpt'><integer name='maxDepth' value='5'/>"
                    + "</integrator><sensor type='perspective'><float name='focusDistance' value='2'/><transform name='toWorld'>"
                    + "<lookAt origin='0,0,5' target='0,0,0' up='0,1,0'/></transform><sampler type='halton'>"
                    + "<integer name='sampleCount' value='4'/></sampler><film type='ldrfilm'><integer name='width' value='8'/>"
                    + "<float name='gamma' value='2.2'/></film></sensor><bsdf type='twosided'>"
                    + "<bsdf type='diffuse'><spectrum name='reflectance' "
                    + "value='400:.1,500:.3,700:.2'/></bsdf><bsdf type='plastic'><srgb name='diffuseReflectance' value='#102030'/>"
                    + "</bsdf></bsdf><shape type='ply'><string name='filename' value='t.ply'/>"
                    + "<bsdf type='diffuse'><texture name='reflectance' type='checkerboard'><float name='uscale' value='3'/>"
                    + "</texture></bsdf></shape><emitter type='constant'><blackbody name='radiance' temperature='5000K' "
                    + "scale='1e-4'/></emitter></scene>";
    private static final String MTL = """
            newmtl a
            Kd 0.5 0.6 0.7
            Ks 0.1 0.1 0.1
            Ns 30
            d 0.5
            illum 2
            newmtl b
            Ke 1 2 3
            Ni 1.45
            Tf 1 1 0.9
            illum 7
            map_Kd -s 2 2 -o 0.1 none.png
            """;
    private static final String OBJ = """
            # cube corner
            v 0 0 0
            v 1 0 0.5
            v 1 1e0 0
            v -0 1 -1.25
            vt 0 0
            vt 1 .5
            vn 0 0 1
            s 1
            usemtl a
            f 1/1/1 2/2/1 3/1/1 4/2/1
            f -4 -2 \\
             -1
            """;
    private static final String PLY = """
            ply
            format ascii 1.0
            comment c
            element vertex 4
            property float x
            property float y
            property float z
            property uchar red
            element face 2
            property list uchar int vertex_indices
            property list short float w
            end_header
            0 0 0 1
            1 0 0 2
            1 1 0 3
            0 1 0.5 4
            4 0 1 2 3 0
            3 0 1 2 1 0.5
            """;

    @TempDir
    Path folder;

    private interface Reader {
        void read(Path file) throws IOException, SceneException;
    }

    /** Reads mutations of a text; every one must be read or refused, and some must be refused. */
    private void mutate(String name, byte[] original, long seed, Reader reader) throws IOException {
        Path file = folder.resolve(name);
        SplittableRandom random = new SplittableRandom(seed);
        int refused = 0;
        for (int i = 0; i < MUTATIONS; i++) {
            byte[] bytes = mutated(original, random);
            Files.write(file, bytes);
            String message = null;
            try {
                reader.read(file);
            } catch (SceneException | MeshFormatException e) {
                message = String.valueOf(e.getMessage());
            } catch (IOException | RuntimeException | StackOverflowError | OutOfMemoryError e) {
                throw new AssertionError("mutation " + i + ":\n" + new String(bytes, StandardCharsets.ISO_8859_1), e);
            }
            if (message != null) {
                assertFalse(message.isBlank() || message.contains("null") || message.contains("Exception"), message);
                refused++;
            }
        }
        assertTrue(refused > MUTATIONS / 4, name + ": only " + refused + " refused");
        assertTrue(refused < MUTATIONS, name + ": none was read");
    }

    private static byte[] mutated(byte[] original, SplittableRandom random) {
        byte[] bytes = original.clone();
        int edits = 1 + random.nextInt(3);
        for (int i = 0; i < edits && bytes.length > 1; i++) {
            int at = random.nextInt(bytes.length);
            int length = Math.min(1 + random.nextInt(20), bytes.length - at);
            switch (random.nextInt(5)) {
                case 0 -> bytes[at] = (byte) random.nextInt(256);
                case 1 -> bytes[at] = (byte) "0123456789-.e<>/'\"$& \n".charAt(random.nextInt(22));
                case 2 ->
                    bytes = joined(Arrays.copyOf(bytes, at), Arrays.copyOfRange(bytes, at + length, bytes.length));
                case 3 ->
                    bytes = joined(Arrays.copyOf(bytes, at + length), Arrays.copyOfRange(bytes, at, bytes.length));
                default -> {
                    if (random.nextInt(10) == 0) {
                        bytes = Arrays.copyOf(bytes, at);
                    }
                }
            }
        }
        return bytes;
    }

    private static byte[] joined(byte[] a, byte[] b) {
        byte[] all = Arrays.copyOf(a, a.length + b.length);
        System.arraycopy(b, 0, all, a.length, b.length);
        return all;
    }

    @Test
    void scenes() throws IOException {
        Files.writeString(folder.resolve("t.ply"), PLY);
        mutate("scene.xml", SCENE.getBytes(StandardCharsets.UTF_8), 1, file -> new SceneReader().load(file, Map.of()));
    }

    @Test
    void objFiles() throws IOException {
        mutate("t.obj", OBJ.getBytes(StandardCharsets.UTF_8), 2, file -> ObjReader.read(file, true));
    }

    @Test
    void asciiPlyFiles() throws IOException {
        mutate("t.ply", PLY.getBytes(StandardCharsets.UTF_8), 3, file -> PlyReader.read(file, false));
    }

    @Test
    void binaryPlyFiles() throws IOException {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        out.write(PLY.substring(0, PLY.indexOf("end_header\n") + 11)
                .replace("ascii", "binary_big_endian")
                .getBytes(StandardCharsets.UTF_8));
        DataOutputStream data = new DataOutputStream(out);
        for (int i = 0; i < 4; i++) {
            data.writeFloat(i);
            data.writeFloat(i * i);
            data.writeFloat(1);
            data.writeByte(i);
        }
        for (int face = 0; face < 2; face++) {
            data.writeByte(3);
            for (int v = 0; v < 3; v++) {
                data.writeInt((v + face) % 4);
            }
            data.writeShort(1);
            data.writeFloat(0.5f);
        }
        mutate("b.ply", out.toByteArray(), 4, file -> PlyReader.read(file, false));
    }

    @Test
    void asciiStlFiles() throws IOException {
        mutate(
                "t.stl",
                StlReaderTest.FACET.repeat(3).getBytes(StandardCharsets.UTF_8),
                5,
                file -> StlReader.read(file));
    }

    @Test
    void binaryStlFiles() throws IOException {
        mutate("b.stl", StlReaderTest.binary("solid or not", 3, 0), 6, file -> StlReader.read(file));
    }

    @Test
    void serializedFiles() throws IOException {
        mutate("t.serialized", SerializedReaderTest.file(4, 0x100b, 2), 7, file -> SerializedReader.read(file, 1));
        mutate("t.serialized", SerializedReaderTest.file(3, 0x2001, 2), 8, file -> SerializedReader.read(file, 0));
    }

    @Test
    void oldScenes() throws IOException {
        Files.writeString(folder.resolve("t.ply"), PLY);
        mutate(
                "scene.xml",
                OLD_SCENE.getBytes(StandardCharsets.UTF_8),
                9,
                file -> new SceneReader().load(file, Map.of()));
    }

    @Test
    void asciiPlyStrips() throws IOException {
        String strips = PLY.substring(0, PLY.indexOf("element face"))
                + "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                + "0 0 0 1 1 0 0 2 1 1 0 3 0 1 0.5 4\n8 0 1 2 3 -1 1 2 3\n";
        mutate("s.ply", strips.getBytes(StandardCharsets.UTF_8), 10, file -> PlyReader.read(file, false));
    }

    @Test
    void materialFiles() throws IOException {
        Files.writeString(
                folder.resolve("m.obj"),
                "mtllib m.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl a\nf 1 2 3\nusemtl b\nf 3 2 1\n");
        // Whatever is wrong in a material file is a warning at most.
        SplittableRandom random = new SplittableRandom(11);
        byte[] mtl = MTL.getBytes(StandardCharsets.UTF_8);
        for (int i = 0; i < MUTATIONS; i++) {
            Files.write(folder.resolve("m.mtl"), mutated(mtl, random));
            try {
                new SceneReader().load(folder.resolve("m.obj"), Map.of());
            } catch (SceneException e) {
                throw new AssertionError("mutation " + i, e);
            }
        }
    }

    @Test
    void objFilesWithMaterials() throws IOException {
        Files.writeString(folder.resolve("m.mtl"), MTL);
        String obj = "mtllib m.mtl\n" + OBJ.replace("f -4", "usemtl b\nf -4");
        mutate("m.obj", obj.getBytes(StandardCharsets.UTF_8), 12, file -> new SceneReader().load(file, Map.of()));
    }

    @Test
    void curveFiles() throws IOException {
        String text = "0 0 0 1\n1 0.5 0 1\n2 1e0 0 .5\n3 1 1 0\n\n0 0 0 1\n1 1 1 1\n2 1 0 1\n2 2 2 2\n";
        mutate("t.txt", text.getBytes(StandardCharsets.UTF_8), 13, file -> CurveReader.read(file));
    }
}
