package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Base64;
import java.util.List;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A converted scene renders to the same bits as the scene or model that it was made from. */
class SceneConversionTest {
    private static final Path ROOT = Path.of(System.getProperty("daybreak.root"));
    private static final String SIZE = "20x15";

    @TempDir
    private Path folder;

    /** The scenes that are shipped, and those of the tests with one of each material, light, camera and filter. */
    static List<Path> scenes() throws IOException {
        List<Path> scenes = new ArrayList<>();
        for (String place : new String[] {"scenes", "src/test/resources/agreement"}) {
            try (Stream<Path> files = Files.walk(ROOT.resolve(place))) {
                files.filter(file -> file.toString().endsWith(".xml"))
                        .filter(
                                file -> !file.toString()
                                        .matches(
                                                ".*[/\\\\](src[/\\\\]main|target|pom\\.xml|stages[/\\\\]|\\w*FuzzTestInputs).*"))
                        .sorted()
                        .forEach(scenes::add);
            }
        }
        return scenes;
    }

    @Test
    void allScenesAreFound() throws IOException {
        assertTrue(scenes().size() >= 65, () -> "found only what is below " + ROOT);
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void scenesKeepTheirBits(Path scene) throws IOException {
        assertSame(scene);
    }

    /** Converts, compares, and converts the result once more. */
    private Path assertSame(Path input, String... defines) throws IOException {
        Path output = folder.resolve("a").resolve("scene.xml");
        Files.createDirectories(output.getParent());
        run("convert", List.of(input, "-o", output), defines);
        assertEquals(summary(input, defines), summary(output));
        assertArrayEquals(image(input, "before.pfm", defines), image(output, "after.pfm"));
        Path again = folder.resolve("b").resolve("scene.xml");
        Files.createDirectories(again.getParent());
        run("convert", List.of(output, again));
        assertEquals(Files.readString(output), Files.readString(again));
        assertEquals(attachments(output), attachments(again));
        assertFalse(Files.readString(output).contains(folder.toString()), "names the machine's folders");
        return output;
    }

    private static void run(String command, List<?> args, String... defines) {
        List<Object> all = new ArrayList<>(List.of(command));
        all.addAll(args);
        for (String define : defines) {
            all.add("-D");
            all.add(define);
        }
        Cli.Result result = Cli.run(all.toArray());
        assertEquals(0, result.code(), result.err());
    }

    private byte[] image(Path scene, String name, String... defines) throws IOException {
        Path file = folder.resolve(name);
        run("render", List.of(scene, "--size", SIZE, "--spp", "2", "--seed", "5", "-o", file), defines);
        return Files.readAllBytes(file);
    }

    /** What the program says about a scene, without names. */
    private static String summary(Path scene, String... defines) {
        List<Object> args = new ArrayList<>(List.of("info", scene));
        for (String define : defines) {
            args.add("-D");
            args.add(define);
        }
        Cli.Result result = Cli.run(args.toArray());
        assertEquals(0, result.code(), result.err());
        return result.out();
    }

    private static List<String> attachments(Path scene) throws IOException {
        Path files = scene.resolveSibling("scene_files");
        return Files.exists(files) ? Cli.files(files) : List.of();
    }

    private static byte[] png() throws IOException {
        BufferedImage image = new BufferedImage(4, 4, BufferedImage.TYPE_INT_RGB);
        for (int i = 0; i < 16; i++) {
            image.setRGB(i % 4, i / 4, 0x401030 + 0x0f0b07 * i);
        }
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ImageIO.write(image, "png", out);
        return out.toByteArray();
    }

    private Path write(String name, String text) throws IOException {
        Path file = folder.resolve("in").resolve(name);
        Files.createDirectories(file.getParent());
        return Files.writeString(file, text);
    }

    /** A square of four vertices with all attributes, in a buffer with its indices at the end. */
    private static String gltf(String nodes) throws IOException {
        ByteBuffer buffer = ByteBuffer.allocate(256).order(ByteOrder.LITTLE_ENDIAN);
        float[] all = {
            -1,
            -1,
            0,
            1,
            -1,
            0,
            1,
            1,
            0,
            -1,
            1,
            0.5f, // positions
            0,
            0,
            1,
            0,
            0.1f,
            1,
            0,
            0,
            1,
            0.1f,
            0,
            1, // normals
            0,
            0,
            2,
            0,
            2,
            2,
            0,
            2,
            0.5f,
            0,
            0,
            1,
            1,
            0.5f,
            0.5f,
            0.5f, // two sets of coordinates
            1,
            0,
            0,
            0,
            1,
            0,
            0,
            0,
            1,
            0.9f,
            0.8f,
            0.3f // colours
        };
        for (float value : all) {
            buffer.putFloat(value);
        }
        buffer.put(new byte[] {0, 1, 2, 2, 3, 0});
        int used = buffer.position();
        String data = Base64.getEncoder().encodeToString(java.util.Arrays.copyOf(buffer.array(), used));
        String image = Base64.getEncoder().encodeToString(png());
        StringBuilder accessors = new StringBuilder();
        String[] types = {"VEC3", "VEC3", "VEC2", "VEC2", "VEC3"};
        int offset = 0;
        for (String type : types) {
            accessors
                    .append("{'bufferView':0,'byteOffset':")
                    .append(offset)
                    .append(",'componentType':5126,'count':4,'type':'")
                    .append(type)
                    .append("'},");
            offset += 16 * (type.charAt(3) - '0');
        }
        return ("{'asset':{'version':'2.0'},'buffers':[{'byteLength':" + used
                        + ",'uri':'data:application/octet-stream;base64," + data + "'}],"
                        + "'bufferViews':[{'buffer':0,'byteLength':" + offset + "},{'buffer':0,'byteOffset':" + offset
                        + ",'byteLength':6}],'accessors':[" + accessors
                        + "{'bufferView':1,'componentType':5121,'count':6,'type':'SCALAR'}],"
                        + "'images':[{'uri':'data:image/png;base64," + image + "'}],'textures':[{'source':0}],"
                        + "'materials':[{'name':'cloth','pbrMetallicRoughness':{'baseColorTexture':{'index':0},"
                        + "'metallicRoughnessTexture':{'index':0,'texCoord':1},'roughnessFactor':0.7}},"
                        + "{'emissiveFactor':[0.3,0.2,0.1],'alphaMode':'MASK','pbrMetallicRoughness':"
                        + "{'baseColorTexture':{'index':0,'texCoord':1}}}],"
                        + "'meshes':[{'primitives':[{'attributes':{'POSITION':0,'NORMAL':1,'TEXCOORD_0':2,'TEXCOORD_1':3,"
                        + "'COLOR_0':4},'indices':5,'material':0}]},{'primitives':[{'attributes':{'POSITION':0,"
                        + "'TEXCOORD_1':3},'indices':5,'material':1}]},{'primitives':[{'attributes':{'POSITION':0},'indices':5}]}],"
                        + nodes + "}")
                .replace('\'', '"');
    }

    /** Shared, mirrored and flat meshes, embedded images, emission, and the camera and light of models. */
    @Test
    void gltfKeepsItsBits() throws IOException {
        String nodes = "'nodes':[{'mesh':0},{'mesh':0,'translation':[2.1,0.3,-0.7],'rotation':[0,0.6,0,0.8],"
                + "'scale':[-1,1,1]},{'mesh':1,'scale':[-0.5,0.7,1],'translation':[0,0,1.3]},"
                + "{'mesh':2,'translation':[-2,0,0]}],'scenes':[{'nodes':[0,1,2,3]}]";
        Path scene = assertSame(write("model.gltf", gltf(nodes)));
        String text = Files.readString(scene);
        assertTrue(text.contains("<shape type=\"shapegroup\" id=\"shapegroup\">"), text);
        assertEquals(2, text.split("<ref id=\"shapegroup\"/>", -1).length - 1, text);
        List<String> files = attachments(scene);
        // One image, one light, and the mesh with and without its attributes and with coordinates alone.
        assertEquals(1, files.stream().filter(f -> f.endsWith(".png")).count(), files::toString);
        assertEquals(1, files.stream().filter(f -> f.endsWith(".exr")).count(), files::toString);
        assertEquals(3, files.stream().filter(f -> f.endsWith(".ply")).count(), files::toString);
    }

    /** With a camera and a light of its own, a glTF file gets neither. */
    @Test
    void gltfWithCameraAndLight() throws IOException {
        String nodes = "'cameras':[{'type':'perspective','perspective':{'yfov':0.7,'znear':0.1,'aspectRatio':1.333}}],"
                + "'extensionsUsed':['KHR_lights_punctual'],'extensions':{'KHR_lights_punctual':{'lights':"
                + "[{'type':'spot','intensity':30,'spot':{'innerConeAngle':0.2,'outerConeAngle':0.6}}]}},"
                + "'nodes':[{'mesh':0},{'camera':0,'translation':[0,0,5],'children':[2]},"
                + "{'extensions':{'KHR_lights_punctual':{'light':0}}}],'scenes':[{'nodes':[0,1]}]";
        Path scene = assertSame(write("model.gltf", gltf(nodes)));
        assertTrue(Files.readString(scene).contains("<emitter type=\"spot\">"));
        assertEquals(
                0, attachments(scene).stream().filter(f -> f.endsWith(".exr")).count());
    }

    @Test
    void objWithMaterialsKeepsItsBits() throws IOException {
        write("lib/m.mtl", """
                newmtl a $dear & <wooden> one
                map_Kd -s 2 3 1 -o 0.1 0.2 wood.png
                newmtl glass
                Ni 1.45
                d 0.1
                illum 4
                newmtl leaf
                Tr 0.25
                newmtl lamp
                Ke 5 4 3
                newmtl paint
                Kd .2 .3 .4
                Ks .04 .04 .04
                Ns 100
                """);
        Files.write(folder.resolve("in/lib/wood.png"), png());
        StringBuilder obj = new StringBuilder("mtllib lib/m.mtl\n");
        String[] names = {"", "a $dear & <wooden> one", "glass", "leaf", "lamp", "paint", "paint"};
        for (int i = 0; i < names.length; i++) {
            for (int k = 0; k < 4; k++) {
                obj.append("v ")
                        .append(i + k % 2)
                        .append(' ')
                        .append(k < 2 ? 0.3 * i : 0.3 * i + 1)
                        .append(' ')
                        .append(0.11 * (i * k % 3))
                        .append("\nvt ")
                        .append(k % 2)
                        .append(' ')
                        .append(k / 2)
                        .append('\n');
            }
            obj.append(i == 0 ? "" : "usemtl " + names[i] + "\n");
            int v = 4 * i + 1;
            obj.append(String.format("f %d/%d %d/%d %d/%d%n", v, v, v + 1, v + 1, v + 3, v + 3));
            obj.append(String.format("f %d/%d %d/%d %d/%d%n", v, v, v + 3, v + 3, v + 2, v + 2));
        }
        Path scene = assertSame(write("m.obj", obj.toString()));
        String text = Files.readString(scene);
        assertTrue(text.contains("id=\"a \\$dear &amp; &lt;wooden> one\""), text);
        assertTrue(attachments(scene).stream().anyMatch(f -> f.matches("wood-[0-9a-f]{12}\\.png")));
    }

    @Test
    void meshesAloneKeepTheirBits() throws IOException {
        assertSame(write("part.stl", """
                solid part
                facet normal 0 0 1
                outer loop
                vertex 0 0 0
                vertex 1 0 0
                vertex 0 1 0.5
                endloop
                endfacet
                facet normal 0 0 1
                outer loop
                vertex 1 0 0
                vertex 1 1 0
                vertex 0 1 0.5
                endloop
                endfacet
                endsolid part
                """));
        assertSame(write("colors.ply", """
                ply
                format ascii 1.0
                element vertex 4
                property float x
                property float y
                property float z
                property uchar red
                property uchar green
                property uchar blue
                element face 1
                property list uchar int vertex_indices
                end_header
                0 0 0 255 0 0
                1 0 0 0 255 0
                1 1 0.2 0 0 255
                0 1 0 120 130 140
                4 0 1 2 3
                """));
    }

    /** Names of Mitsuba 0.6, definitions, includes, aliases, spectra, and shapes that become meshes. */
    @Test
    void whatIsResolvedKeepsItsBits() throws IOException {
        Files.createDirectories(folder.resolve("in/more"));
        Files.write(folder.resolve("in/more/heights.png"), png());
        write("more/curve.txt", "0 0 0 0.1\n0.5 0.2 0 0.2\n1 0 0.3 0.1\n1.2 0.5 0 0.1\n");
        write("more/mesh.obj", "v 0 0 0\nv 1 0 0.2\nv 1 1 0\nv 0 1 0.1\nf 1 2 3\nf 1 3 4\n");
        write("part.xml", """
                <scene version="0.6.0">
                    <path value="more"/>
                    <bsdf type="roughplastic" id="shiny"><float name="alpha" value="0.2"/>
                        <spectrum name="diffuseReflectance" value="400:0.1, 550:0.7, 700:0.2"/></bsdf>
                    <alias id="shiny" as="other"/>
                    <texture type="checkerboard" id="squares"><srgb name="color0" value="#ff8000"/>
                        <float name="uscale" value="5"/></texture>
                    <shape type="shapegroup" id="pair">
                        <shape type="obj"><string name="filename" value="mesh.obj"/><ref id="other"/></shape>
                        <shape type="sphere"><float name="radius" value="$radius"/><ref id="shiny"/></shape>
                    </shape>
                    <shape type="instance"><ref id="pair"/><transform name="toWorld">
                        <rotate y="1" angle="31"/><scale x="2" y="1" z="-1"/></transform></shape>
                    <shape type="instance"><ref id="pair"/><transform name="toWorld">
                        <translate x="-1"/></transform></shape>
                    <shape type="obj"><string name="filename" value="mesh.obj"/><boolean name="faceNormals" value="true"/>
                        <boolean name="flipNormals" value="true"/>
                        <transform name="toWorld"><scale x="-1" y="2"/><translate y="1"/></transform>
                        <bsdf type="diffuse"><ref name="reflectance" id="squares"/></bsdf></shape>
                    <shape type="obj"><string name="filename" value="mesh.obj"/>
                        <transform name="toWorld"><scale x="1" y="3" z="0.5"/><rotate x="1" angle="40"/></transform>
                        <bsdf type="diffuse"><ref name="reflectance" id="squares"/></bsdf></shape>
                </scene>
                """);
        Path scene = write("scene.xml", """
                <scene version="3.0.0">
                    <default name="radius" value="0.1"/>
                    <default name="name" value="mesh.obj"/>
                    <include filename="part.xml"/>
                    <integrator type="path"><integer name="max_depth" value="4"/></integrator>
                    <sensor type="thinlens"><float name="fov" value="50"/><float name="aperture_radius" value="0.01"/>
                        <float name="focus_distance" value="4"/>
                        <transform name="to_world"><lookat origin="0.5, -1, 4" target="0, 0.5, 0" up="0, 1, 0"/></transform>
                        <film type="hdrfilm"><rfilter type="mitchell"/></film></sensor>
                    <emitter type="point"><point name="position" value="1, 2, 3"/>
                        <spectrum name="intensity" value="5"/></emitter>
                    <emitter type="directional"><vector name="direction" value="0.3, -1, -0.2"/>
                        <blackbody name="irradiance" temperature="5000K" scale="1e-5"/></emitter>
                    <shape type="heightfield"><string name="filename" value="heights.png"/>
                        <float name="scale" value="0.4"/></shape>
                    <shape type="bsplinecurve" id="hair"><string name="filename" value="more/curve.txt"/>
                        <bsdf type="twosided"><ref id="other"/></bsdf></shape>
                    <shape type="obj"><string name="filename" value="more/$name"/>
                        <transform name="to_world"><translate z="1.5"/></transform>
                        <emitter type="area"><spectrum name="radiance" value="400:1, 700:2"/></emitter></shape>
                </scene>
                """);
        Path converted = assertSame(scene, "radius=0.3");
        String text = Files.readString(converted);
        assertTrue(text.contains("<float name=\"radius\" value=\"0.3\"/>"), text);
        assertFalse(text.contains("heightfield") || text.contains("bsplinecurve"), text);
        assertTrue(attachments(converted).stream().anyMatch(f -> f.startsWith("hair-")));
    }

    /** Integrators of Mitsuba 0.6 that are renderers by Markov chains. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "mlt'><boolean name='manifoldPerturbation' value='true'/><boolean name='lensPerturbation' value='false'/>"
                        + "<float name='lambda' value='40'/>",
                "pssmlt'><float name='pLarge' value='0.25'/><integer name='rrDepth' value='4'/>"
            })
    void markovChainsKeepTheirBits(String integrator) throws IOException {
        Path scene = write("scene.xml", """
                <scene version="0.6.0"><integrator type='%s<integer name="maxDepth" value="6"/>
                        <integer name="luminanceSamples" value="300"/><integer name="directSamples" value="2"/></integrator>
                    <sensor type="perspective"><transform name="toWorld"><lookAt origin="0,1,5" target="0,0,0" up="0,1,0"/></transform>
                        <sampler type="independent"><integer name="sampleCount" value="9"/></sampler></sensor>
                    <shape type="rectangle"><transform name="toWorld"><scale value="4"/><translate z="-1"/></transform></shape>
                    <shape type="sphere"><bsdf type="dielectric"/></shape>
                    <shape type="sphere"><point name="center" x="3" y="3" z="2"/><float name="radius" value="0.5"/>
                        <emitter type="area"><spectrum name="radiance" value="9"/></emitter></shape>
                </scene>
                """.formatted(integrator));
        String text = Files.readString(assertSame(scene));
        assertTrue(text.contains("<integrator type=\"" + integrator.replaceFirst("'.*", "") + "\""), text);
        assertTrue(text.contains("luminance_samples"), text);
    }

    @Test
    void wrongRequests() throws IOException {
        Path scene = TestScenes.write(folder, TestScenes.usual());
        Path target = folder.resolve("out.xml");
        assertFails(2, "converts to xml only", scene, folder.resolve("out.png"));
        assertFails(2, "give the file to write once", scene);
        assertFails(2, "give the file to write once", scene, target, "-o", target);
        assertFails(2, "are for images", scene, target, "--exposure", "1");
        assertFails(2, "is no scene or model", folder.resolve("a.png"), target);
        assertFails(2, "-D is for scenes", folder.resolve("a.png"), folder.resolve("b.png"), "-D", "a=1");
        assertFails(3, "no attribute uses the definition 'a'", scene, target, "-D", "a=1");
        assertFails(3, "none.glb", folder.resolve("none.glb"), target);
        assertFails(4, "there is no directory", scene, folder.resolve("no").resolve("out.xml"));
        assertEquals(List.of("tiny.xml"), Cli.files(folder));
    }

    /** An error in the middle of writing leaves the older scene as it was, and nothing else. */
    @Test
    void errorsLeaveTheOlderSceneIntact() throws IOException {
        Path model = write("part.ply", """
                ply
                format ascii 1.0
                element vertex 3
                property float x
                property float y
                property float z
                element face 1
                property list uchar int vertex_indices
                end_header
                0 0 0
                1 0 0
                0 1 0
                3 0 1 2
                """);
        Path target = Files.writeString(folder.resolve("out.xml"), "older");
        Files.writeString(folder.resolve("out_files"), "in the way");
        assertFails(4, "cannot be written", model, target);
        assertEquals("older", Files.readString(target));
        assertEquals(List.of("in", "out.xml", "out_files"), Cli.files(folder));
        Files.delete(folder.resolve("out_files"));
        run("convert", List.of(model, target));
        assertEquals(List.of("in", "out.xml", "out_files"), Cli.files(folder));
        assertTrue(Files.readString(target, StandardCharsets.UTF_8).startsWith("<?xml"));
    }

    private static void assertFails(int code, String message, Object... args) {
        Object[] all = new Object[args.length + 1];
        all[0] = "convert";
        System.arraycopy(args, 0, all, 1, args.length);
        Cli.Result result = Cli.run(all);
        assertEquals(code, result.code(), result.err());
        assertEquals(1, result.messages().size(), result.err());
        assertTrue(result.err().contains(message), result.err());
    }
}
