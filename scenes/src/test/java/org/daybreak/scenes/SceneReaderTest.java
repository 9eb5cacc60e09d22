package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.params.provider.Arguments.arguments;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.vecmath.Color3f;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Cylinder;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.light.SkySettings;
import org.daybreak.core.material.Conductor;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.Mask;
import org.daybreak.core.material.Plastic;
import org.daybreak.core.material.RoughConductor;
import org.daybreak.core.material.RoughPlastic;
import org.daybreak.core.material.Texture;
import org.daybreak.core.material.TwoSided;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.Node;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.image.ImageLoader;
import org.daybreak.scenes.image.LoadedImage;
import org.daybreak.scenes.image.StandardImageLoader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

class SceneReaderTest {
    @TempDir
    Path folder;

    private SceneFile load(String content) throws IOException, SceneException {
        return SceneTexts.load(folder, SceneTexts.scene(content));
    }

    private ShapeNode shape(String content) throws IOException, SceneException {
        return SceneTexts.onlyShape(load(content));
    }

    /** Transforms and the matrices that Mitsuba 3.9.1 makes of them. */
    static Stream<Arguments> transforms() {
        return Stream.of(
                arguments(
                        "<translate x='1' y='2'/><rotate z='1' angle='30'/><scale value='2'/>",
                        "1.7320508 -1 0 -0.26794919 1 1.7320508 0 4.4641018 0 0 2 0 0 0 0 1"),
                arguments(
                        "<rotate x='0.6' y='0.8' angle='40'/><translate value='1,2,3'/>",
                        "0.85026842 0.11229867 0.51423007 1 0.11229867 0.91577601 -0.38567257 2"
                                + " -0.51423007 0.38567257 0.76604444 3 0 0 0 1"),
                arguments(
                        "<lookat origin='1,2,3' target='0,0.5,0' up='0,1,0'/>",
                        "-0.94868332 -0.13552618 -0.28571430 1 0 0.90350789 -0.42857143 2"
                                + " 0.31622776 -0.40657857 -0.85714287 3 0 0 0 1"),
                arguments(
                        "<scale x='2'/><lookat origin='1,2,3' target='0,0.5,0' up='0.1,1,0.3'/>",
                        "-1.8973666 -0.13552618 -0.28571430 1 0 0.90350789 -0.42857143 2"
                                + " 0.63245553 -0.40657857 -0.85714287 3 0 0 0 1"),
                arguments(
                        "<lookat origin='1,2,3' target='0,0.5,0'/>",
                        "-0.06593407 0.95604396 -0.28571430 1 0.90109890 -0.06593407 -0.42857143 2"
                                + " -0.42857143 -0.28571430 -0.85714287 3 0 0 0 1"),
                arguments("<matrix value='1 2 3 4 0 1 5 6 7 0 1 8 0 0 0 1'/>", "1 2 3 4 0 1 5 6 7 0 1 8 0 0 0 1"),
                arguments("<matrix value='1 2 3 0 1 5 7 0 1'/>", "1 2 3 0 0 1 5 0 7 0 1 0 0 0 0 1"),
                arguments(
                        "<rotate angle='30' value='0 1 0'/>", "0.8660254 0 0.5 0 0 1 0 0 -0.5 0 0.8660254 0 0 0 0 1"));
    }

    @ParameterizedTest
    @MethodSource("transforms")
    void transformsAreThoseOfMitsuba(String transform, String expected) throws IOException, SceneException {
        ShapeNode node =
                shape("<shape type='rectangle'><transform name='to_world'>" + transform + "</transform></shape>");
        Matrix4d m = node.transform();
        String[] words = expected.split(" ", -1);
        for (int i = 0; i < 16; i++) {
            // Mitsuba prints single precision.
            assertEquals(Double.parseDouble(words[i]), m.getElement(i / 4, i % 4), 2e-6, "element " + i + " of " + m);
        }
    }

    @Test
    void readsAnalyticShapes() throws IOException, SceneException {
        Sphere sphere = assertInstanceOf(
                Sphere.class,
                shape(
                                "<shape type='sphere'><point name='center' x='1' y='2' z='3'/><integer name='radius' value='4'/></shape>")
                        .shape());
        assertEquals(new Point3d(1, 2, 3), sphere.centre());
        assertEquals(4, sphere.radius());
        Cylinder cylinder = assertInstanceOf(
                Cylinder.class,
                shape(
                                "<shape type='cylinder'><vector name='p1' value='0 0 5'/><float name='radius' value='.5'/></shape>")
                        .shape());
        assertEquals(new Point3d(0, 0, 5), cylinder.to());
        assertEquals(0.5, cylinder.radius());
        for (String type : List.of("rectangle", "disk", "cube")) {
            ShapeNode node = shape("<shape type='" + type + "'><boolean name='flip_normals' value='TRUE'/></shape>");
            assertTrue(node.flipNormals());
            assertEquals(type, node.shape().getClass().getSimpleName().toLowerCase(Locale.ROOT));
        }
    }

    @Test
    void readsEveryMaterial() throws IOException, SceneException {
        assertInstanceOf(Diffuse.class, shape("<shape type='sphere'/>").material());
        assertInstanceOf(Conductor.class, material("<bsdf type='conductor'/>"));
        assertInstanceOf(Conductor.class, material("<bsdf type='conductor'><rgb name='eta' value='.1,.2,.3'/></bsdf>"));
        assertInstanceOf(RoughConductor.class, material("<bsdf type='roughconductor'/>"));
        assertInstanceOf(
                RoughConductor.class,
                material(
                        "<bsdf type='roughconductor'><float name='alpha_u' value='.3'/><float name='alpha_v' value='.3'/>"
                                + "<float name='eta' value='1.5'/><spectrum name='k' value='2'/></bsdf>"));
        assertInstanceOf(
                Dielectric.class,
                material("<bsdf type='dielectric'><string name='int_ior' value='Water Ice'/></bsdf>"));
        assertInstanceOf(Plastic.class, material("<bsdf type='plastic'/>"));
        assertInstanceOf(RoughPlastic.class, material("<bsdf type='roughplastic'/>"));
        assertInstanceOf(
                TwoSided.class, material("<bsdf type='twosided'><bsdf type='diffuse'/><bsdf type='plastic'/></bsdf>"));
        assertInstanceOf(
                Mask.class,
                material("<bsdf type='mask'><float name='opacity' value='.3'/><bsdf type='diffuse'/></bsdf>"));
    }

    private Object material(String bsdf) throws IOException, SceneException {
        return shape("<shape type='sphere'>" + bsdf + "</shape>").material();
    }

    private double[] albedo(String content) throws IOException, SceneException {
        Spectrum out = new Spectrum();
        shape("<shape type='sphere'>" + content + "</shape>").material().albedo(new SurfacePoint(), out);
        return new double[] {out.r, out.g, out.b};
    }

    @Test
    void readsColours() throws IOException, SceneException {
        assertArrayEquals(new double[] {0.5, 0.5, 0.5}, albedo("<bsdf type='diffuse'/>"), 1e-12);
        assertArrayEquals(new double[] {0, 0, 0}, albedo("<emitter type='area'/>"), 0, "an emitter without material");
        String diffuse = "<bsdf type='diffuse'><%s name='reflectance' value='%s'/></bsdf>";
        assertArrayEquals(new double[] {0.1, 0.2, 0.3}, albedo(String.format(diffuse, "rgb", "0.1, 0.2 0.3")), 1e-12);
        assertArrayEquals(new double[] {0.4, 0.4, 0.4}, albedo(String.format(diffuse, "rgb", "0.4")), 1e-12);
        assertArrayEquals(new double[] {0.4, 0.4, 0.4}, albedo(String.format(diffuse, "spectrum", "0.4")), 1e-12);
        assertArrayEquals(new double[] {0.4, 0.4, 0.4}, albedo(String.format(diffuse, "float", "0.4")), 1e-12);
        // IEC 61966-2-1: 128/255 is 0.21586 linear, 0.5 is 0.21404.
        assertArrayEquals(new double[] {1, 0.2158605, 0}, albedo(String.format(diffuse, "rgb", "#fF8000")), 1e-6);
        assertArrayEquals(new double[] {1, 0.2140411, 0}, albedo(String.format(diffuse, "srgb", "1 0.5 0")), 1e-6);
    }

    @Test
    void flatSpectraOfLightsAreIlluminantE() throws IOException, SceneException {
        // Values Mitsuba 3.9.1 (scalar_rgb) reports for the same emitter.
        LightSource.Point light = assertInstanceOf(
                LightSource.Point.class,
                light("<emitter type='point'><spectrum name='intensity' value='2'/></emitter>"));
        assertEquals(2.40959, light.intensity().x, 1e-5);
        assertEquals(1.89658, light.intensity().y, 1e-5);
        assertEquals(1.81783, light.intensity().z, 1e-5);
    }

    private LightSource light(String emitter) throws IOException, SceneException {
        return lightNode(emitter).source();
    }

    private LightNode lightNode(String emitter) throws IOException, SceneException {
        return (LightNode) load(emitter).graph().root().children().get(1);
    }

    @Test
    void readsLights() throws IOException, SceneException {
        LightNode point = lightNode("<emitter type='point'><point name='position' value='1 2 3'/></emitter>");
        assertEquals(new LightSource.Point(new Color3f(1, 1, 1)), point.source());
        assertEquals(2, point.transform().m13);
        assertEquals(
                new LightSource.Spot(new Color3f(1, 2, 3), 20, 15),
                light("<emitter type='spot'><rgb name='intensity' value='1,2,3'/></emitter>"));
        assertEquals(
                new LightSource.ConstantEnvironment(new Color3f(4, 4, 4)),
                light("<emitter type='constant'><float name='radiance' value='4'/></emitter>"));
        ShapeNode area = shape("<shape type='disk'><ref id='e'/></shape><emitter type='area' id='e'>"
                + "<rgb name='radiance' value='3,2,1'/></emitter>");
        Spectrum radiance = new Spectrum();
        Texture texture = area.radiance();
        assertNotNull(texture);
        texture.mean(radiance);
        assertEquals(3, radiance.r);
        assertNull(shape("<shape type='disk'/>").radiance());
    }

    @Test
    void directionalLightsTravelAlongTheirDirection() throws IOException, SceneException {
        for (double[] d : new double[][] {{1, 2, -2}, {0, -3, 0}, {0, 0, -1}, {-4, 0, 0}}) {
            LightNode node = lightNode("<emitter type='directional'><rgb name='irradiance' value='3,2,1'/>"
                    + "<vector name='direction' value='" + d[0] + " " + d[1] + " " + d[2] + "'/></emitter>");
            assertEquals(new LightSource.Directional(new Color3f(3, 2, 1)), node.source());
            double length = Math.hypot(Math.hypot(d[0], d[1]), d[2]);
            assertEquals(d[0] / length, node.transform().m02, 1e-12);
            assertEquals(d[1] / length, node.transform().m12, 1e-12);
            assertEquals(d[2] / length, node.transform().m22, 1e-12);
        }
        LightNode turned = lightNode("<emitter type='directional'><transform name='to_world'>"
                + "<rotate y='1' angle='90'/></transform></emitter>");
        assertEquals(1, turned.transform().m02, 1e-12);
    }

    @Test
    void readsSkiesAsTwoLights() throws IOException, SceneException {
        String sky = "<emitter type='%s'><float name='turbidity' value='4'/>"
                + "<vector name='sun_direction' value='0 1 1'/><transform name='to_world'>"
                + "<rotate x='1' angle='-90'/></transform></emitter>";
        List<Node> both = load(String.format(sky, "sunsky")).graph().root().children();
        LightSource.Sky first = (LightSource.Sky) ((LightNode) both.get(1)).source();
        LightSource.Sun second = (LightSource.Sun) ((LightNode) both.get(2)).source();
        assertEquals(4, first.settings().turbidity());
        assertEquals(SkySettings.Kind.HOSEK_WILKIE, first.settings().kind());
        // World (0, 1, 1) is, for a sky whose zenith is +y, half way up.
        assertEquals(Math.sqrt(0.5), first.settings().sun().z, 1e-12);
        assertEquals(-Math.sqrt(0.5), first.settings().sun().y, 1e-12);
        assertEquals(0.5358, second.apertureDegrees());
        assertEquals(
                2, load(String.format(sky, "sky")).graph().root().children().size());
        assertInstanceOf(LightSource.Sun.class, light(String.format(sky, "sun")));
        LightSource.Sky preetham = (LightSource.Sky) light(
                "<emitter type='sky'><string name='model' value='preetham'/><float name='hour' value='12'/></emitter>");
        assertEquals(SkySettings.Kind.PREETHAM, preetham.settings().kind());
        assertTrue(preetham.settings().sun().z > 0.9);
    }

    @Test
    void readsLuminairesAndSlides() throws IOException, SceneException {
        Files.writeString(folder.resolve("lamp.ies"), "TILT=NONE\n1 -1 1 2 1 1 2 0 0 0 1 1 10\n0 90\n0\n500 100\n");
        LightSource.Photometric lamp = assertInstanceOf(
                LightSource.Photometric.class,
                light("<emitter type='point'><string name='ies' value='lamp.ies'/></emitter>"));
        assertEquals(500, lamp.profile().maximum());
        LightSource.Spot spot = assertInstanceOf(
                LightSource.Spot.class,
                light("<emitter type='spot'><texture type='checkerboard' name='texture'/></emitter>"));
        assertNotNull(spot.slide());
    }

    @Test
    void readsOtherCamerasAndFilters() throws IOException, SceneException {
        for (String[] row : new String[][] {
            {"orthographic", "<float name='pixel_aspect' value='2'/>", "lanczos", "ORTHOGRAPHIC", "LANCZOS"},
            {"environment", "", "blackmanharris", "ENVIRONMENT", "BLACKMAN_HARRIS"},
            {"spherical", "", "catmullrom", "ENVIRONMENT", "MITCHELL"},
            {"perspective", "<float name='principal_point_offset_x' value='0.2'/>", "tent", "PERSPECTIVE", "TENT"}
        }) {
            Path file = SceneTexts.write(
                    folder,
                    "camera.xml",
                    "<scene version='3.0.0'><sensor type='" + row[0] + "'>" + row[1]
                            + "<film type='hdrfilm'><boolean name='filter_sampling' value='true'/><rfilter type='"
                            + row[2]
                            + "'/></film></sensor></scene>");
            SceneFile scene = new SceneReader(new StandardImageLoader()).load(file, Map.of());
            CameraSettings camera = Objects.requireNonNull(scene.graph().camera());
            assertEquals(row[3], camera.projection().name());
            FilmSettings film = Objects.requireNonNull(scene.graph().film());
            assertEquals(row[4], film.filter().kind().name());
            assertTrue(film.filterSampling());
        }
    }

    @Test
    void readsImages() throws IOException, SceneException {
        writeImage("t.png", BufferedImage.TYPE_INT_RGB);
        ShapeNode node = shape("<shape type='rectangle'><bsdf type='diffuse'><texture type='bitmap' name='reflectance'>"
                + "<string name='filename' value='t.png'/><string name='filter_type' value='nearest'/>"
                + "<transform name='to_uv'><translate x='0.5'/></transform></texture></bsdf></shape>");
        SurfacePoint point = new SurfacePoint();
        point.u = 0.25;
        point.v = 0.25;
        Spectrum out = new Spectrum();
        node.material().albedo(point, out);
        // Half a picture to the right of the upper left pixel, at the top, as in Mitsuba, is green.
        assertArrayEquals(new double[] {0, 1, 0}, new double[] {out.r, out.g, out.b}, 1e-6);
        LightSource.ImageEnvironment env = assertInstanceOf(
                LightSource.ImageEnvironment.class,
                light(
                        "<emitter type='envmap'><string name='filename' value='t.png'/><float name='scale' value='3'/></emitter>"));
        assertEquals(3, env.scale());
        assertArrayEquals(
                new float[] {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}, env.image().rgb(), 1e-6f);
    }

    private void writeImage(String name, int type) throws IOException {
        BufferedImage image = new BufferedImage(2, 2, type);
        image.setRGB(0, 0, 0xffff0000);
        image.setRGB(1, 0, 0xff00ff00);
        image.setRGB(0, 1, 0xff0000ff);
        image.setRGB(1, 1, 0xffffffff);
        assertTrue(ImageIO.write(image, "png", folder.resolve(name).toFile()));
    }

    @Test
    void keepsStoredValuesOfGreyImages() throws IOException {
        for (int type : new int[] {BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_USHORT_GRAY}) {
            BufferedImage image = new BufferedImage(3, 1, type);
            int[] values =
                    type == BufferedImage.TYPE_BYTE_GRAY ? new int[] {0, 100, 255} : new int[] {0, 30_000, 65_535};
            image.getRaster().setPixels(0, 0, 3, 1, values);
            Path file = folder.resolve("grey" + type + ".png");
            assertTrue(ImageIO.write(image, "png", file.toFile()));
            LoadedImage loaded = new StandardImageLoader().load(file);
            assertEquals(1, loaded.channels());
            if (loaded instanceof LoadedImage.Bytes b) {
                assertArrayEquals(new byte[] {0, 100, (byte) 255}, b.samples());
            } else {
                LoadedImage.Floats f = assertInstanceOf(LoadedImage.Floats.class, loaded);
                assertTrue(f.encoded());
                assertArrayEquals(new float[] {0, 30_000 / 65_535f, 1}, f.samples());
            }
        }
    }

    @Test
    void asksTheGivenImageLoaderFirst() throws IOException, SceneException {
        ImageLoader floats = new ImageLoader() {
            @Override
            public Set<String> endings() {
                return Set.of("exr");
            }

            @Override
            public LoadedImage load(Path file) {
                return new LoadedImage.Floats(1, 1, 3, new float[] {5, 6, 7}, false);
            }
        };
        Files.write(folder.resolve("sky.exr"), new byte[] {1});
        Path file = SceneTexts.write(
                folder,
                "scene.xml",
                SceneTexts.scene("<emitter type='envmap'><string name='filename' value='sky.exr'/></emitter>"));
        SceneFile scene = new SceneReader(floats.or(new StandardImageLoader())).load(file, Map.of());
        LightNode node = (LightNode) scene.graph().root().children().get(1);
        assertArrayEquals(
                new float[] {5, 6, 7},
                ((LightSource.ImageEnvironment) node.source()).image().rgb());
    }

    @Test
    void readsCameraFilmAndRequests() throws IOException, SceneException {
        SceneFile file = SceneTexts.load(
                folder,
                "<scene version='3.0.0'>" + SceneTexts.LIGHT
                        + "<default name='spp' value='16'/><integrator type='ptracer'><integer name='max_depth' value='7'/>"
                        + "<integer name='rr_depth' value='9'/></integrator><sensor type='thinlens'>"
                        + "<float name='fov' value='30'/><string name='fov_axis' value='larger'/>"
                        + "<float name='aperture_radius' value='0.2'/><float name='focus_distance' value='5'/>"
                        + "<float name='near_clip' value='0.1'/>"
                        + "<sampler type='multijitter'><integer name='sample_count' value='$spp'/><integer name='seed' value='12'/></sampler>"
                        + "<film type='hdrfilm'><integer name='width' value='40'/><integer name='height' value='30'/>"
                        + "<integer name='crop_offset_y' value='10'/><integer name='crop_height' value='5'/>"
                        + "<rfilter type='gaussian'><float name='stddev' value='0.4'/></rfilter></film></sensor></scene>");
        CameraSettings camera = file.graph().camera();
        assertNotNull(camera);
        assertEquals(30, camera.fieldOfViewDegrees());
        assertEquals(CameraSettings.FovAxis.LARGER, camera.axis());
        assertEquals(0.2, camera.apertureRadius());
        assertEquals(5, camera.focusDistance());
        assertEquals(
                new FilmSettings(
                        40,
                        30,
                        new FilmSettings.Crop(0, 10, 40, 5),
                        new ReconstructionFilter(ReconstructionFilter.Kind.GAUSSIAN, 1.6, 0.4)),
                file.graph().film());
        assertEquals(Optional.of("light"), file.request().rendererId());
        assertEquals(Map.of("maxDepth", "7", "rrDepth", "9"), file.request().parameters());
        assertEquals(OptionalInt.of(16), file.request().samplesPerPixel());
        assertEquals(OptionalLong.of(12), file.request().seed());
        assertEquals(1, file.warnings().size());
        assertTrue(file.warnings().get(0).message().contains("near_clip"));
    }

    @Test
    void defaultsAreThoseOfMitsuba() throws IOException, SceneException {
        SceneFile file = SceneTexts.load(
                folder, "<scene version='3.0.0'>" + SceneTexts.LIGHT + "<sensor type='perspective'/></scene>");
        assertEquals(
                new FilmSettings(768, 576, ReconstructionFilter.GAUSSIAN),
                file.graph().film());
        CameraSettings camera = file.graph().camera();
        assertNotNull(camera);
        assertEquals(CameraSettings.FovAxis.DIAGONAL, camera.axis());
        // 50 mm; Mitsuba 3.9.1 says 38.1848 degrees across 768 of 768 x 576.
        double x = 2 * Math.toDegrees(Math.atan(0.8 * Math.tan(Math.toRadians(camera.fieldOfViewDegrees() / 2))));
        assertEquals(38.1848, x, 1e-4);
        assertEquals(Optional.empty(), file.request().rendererId());
        assertEquals(OptionalInt.empty(), file.request().samplesPerPixel());
        assertTrue(file.request().parameters().isEmpty());
    }

    @Test
    void readsFilters() throws IOException, SceneException {
        assertEquals(ReconstructionFilter.BOX, filter("<rfilter type='box'/>"));
        assertEquals(ReconstructionFilter.TENT, filter("<rfilter type='tent'/>"));
        assertEquals(ReconstructionFilter.GAUSSIAN, filter("<rfilter type='gaussian'/>"));
        assertEquals(ReconstructionFilter.MITCHELL, filter("<rfilter type='mitchell'/>"));
        assertEquals(
                new ReconstructionFilter(ReconstructionFilter.Kind.MITCHELL, 2, 0),
                filter("<rfilter type='catmullrom'/>"));
    }

    private ReconstructionFilter filter(String rfilter) throws IOException, SceneException {
        FilmSettings film = SceneTexts.load(
                        folder,
                        "<scene version='3.0.0'>" + SceneTexts.LIGHT
                                + "<sensor type='perspective'><film type='hdrfilm'>" + rfilter
                                + "</film></sensor></scene>")
                .graph()
                .film();
        assertNotNull(film);
        return film.filter();
    }

    @Test
    void definesGoBeforeDefaultsAndTheLongestNameIsTaken() throws IOException, SceneException {
        Path file = SceneTexts.write(
                folder,
                "scene.xml",
                SceneTexts.scene("<default name='r' value='1'/><default name='ra' value='2'/>"
                        + "<shape type='sphere'><float name='radius' value='$r$ra'/></shape>"
                        + "<bsdf type='diffuse' id='\\$x'/><shape type='sphere' id='s$rx'><ref id='\\$x'/></shape>"));
        List<ShapeNode> shapes = SceneTexts.shapes(
                new SceneReader().load(file, Map.of("r", "4")).graph().root());
        assertEquals(42, ((Sphere) shapes.get(0).shape()).radius());
        assertEquals("s4x", shapes.get(1).name());
    }

    @Test
    void includesFilesRelativeToTheIncludingFile() throws IOException, SceneException {
        SceneTexts.write(folder, "a/one.xml", "<scene version='3.0.0'><include filename='b/two.xml'/></scene>");
        SceneTexts.write(
                folder,
                "a/b/two.xml",
                "<shape version='3.0.0' type='obj'><string name='filename' value='m/$mesh'/><ref id='late'/></shape>");
        SceneTexts.write(folder, "a/b/m/t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        SceneFile file = load("<default name='mesh' value='t.obj'/><include filename='a/one.xml'/>"
                + "<bsdf type='plastic' id='late'/>");
        ShapeNode node = SceneTexts.onlyShape(file);
        assertInstanceOf(TriangleMesh.class, node.shape());
        assertInstanceOf(Plastic.class, node.material());
    }

    @Test
    void sharesMaterialsMeshesAndGroups() throws IOException, SceneException {
        SceneTexts.write(folder, "t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        SceneFile file = load("<bsdf type='diffuse' id='m'/><alias id='m' as='n'/>"
                + "<shape type='shapegroup' id='g'><shape type='obj'><string name='filename' value='t.obj'/><ref id='m'/></shape></shape>"
                + "<shape type='instance'><ref id='g'/><transform name='to_world'><translate x='5'/></transform></shape>"
                + "<shape type='instance'><ref id='g'/></shape>"
                + "<shape type='obj'><string name='filename' value='./t.obj'/><ref id='n'/></shape>");
        assertEquals(4, file.graph().root().children().size(), "light, two instances, shape");
        List<ShapeNode> shapes = SceneTexts.shapes(file.graph().root());
        assertEquals(3, shapes.size());
        assertSame(shapes.get(0), shapes.get(1));
        assertSame(shapes.get(0).shape(), shapes.get(2).shape());
        assertSame(shapes.get(0).material(), shapes.get(2).material());
        assertEquals(5, file.graph().root().children().get(1).transform().m03);
    }

    @Test
    void meshesFollowMitsubaInNormalsAndMirroring() throws IOException, SceneException {
        SceneTexts.write(folder, "plain.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nvt 0.25 0.75\nf 1/1 2/1 3/1 4/1\n");
        SceneTexts.write(folder, "own.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
        String mirror = "<transform name='to_world'><scale x='-1'/></transform>";
        String flip = "<boolean name='flip_normals' value='true'/>";
        String flat = "<boolean name='face_normals' value='true'/>";
        assertNotNull(mesh("plain.obj", "").normals());
        assertNull(mesh("plain.obj", flat).normals());
        assertNotNull(mesh("own.obj", "").normals());
        assertNull(mesh("own.obj", flat).normals());
        float[] flipped = mesh("plain.obj", "").uvs();
        assertNotNull(flipped);
        assertEquals(0.25f, flipped[1]);
        float[] kept = mesh("plain.obj", "<boolean name='flip_tex_coords' value='false'/>")
                .uvs();
        assertNotNull(kept);
        assertEquals(0.75f, kept[1]);
        // Without normals in use Mitsuba's front follows the winding in world space, which mirroring turns round.
        assertFalse(node("plain.obj", "").flipNormals());
        assertTrue(node("plain.obj", mirror).flipNormals());
        assertFalse(node("plain.obj", mirror + flip).flipNormals());
        assertTrue(node("own.obj", mirror + flat).flipNormals());
        assertFalse(node("own.obj", mirror).flipNormals());
    }

    @Test
    void computedNormalsAreThoseOfTheTransformedMesh() throws IOException, SceneException {
        SceneTexts.write(folder, "plain.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3 4\n");
        // vertex_normals of the same shape in Mitsuba 3.9.1; front by winding.
        float[] expected = {
            -0.12014041f,
            -0.3604212f,
            -0.92502046f,
            0,
            0,
            -1,
            -0.03369471f,
            -0.10108414f,
            -0.99430716f,
            -0.14744195f,
            -0.4423259f,
            -0.8846518f
        };
        float[] local = mesh("plain.obj", "<transform name='to_world'><scale x='3' y='-1' z='0.5'/></transform>")
                .normals();
        assertNotNull(local);
        for (int i = 0; i < local.length; i += 3) {
            // To world by the inverse transpose; the mirrored front is turned round by the node's flip.
            double x = -local[i] / 3;
            double y = local[i + 1];
            double z = -local[i + 2] / 0.5;
            double length = Math.sqrt(x * x + y * y + z * z);
            assertEquals(expected[i], x / length, 1e-6);
            assertEquals(expected[i + 1], y / length, 1e-6);
            assertEquals(expected[i + 2], z / length, 1e-6);
        }
    }

    private ShapeNode node(String file, String properties) throws IOException, SceneException {
        return shape("<shape type='obj'><string name='filename' value='" + file + "'/>" + properties + "</shape>");
    }

    private TriangleMesh mesh(String file, String properties) throws IOException, SceneException {
        return (TriangleMesh) node(file, properties).shape();
    }

    @Test
    void leavesOutTrianglesWithoutAreaAndSaysSo() throws IOException, SceneException {
        SceneTexts.write(folder, "t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 3\n");
        SceneFile file = load("<shape type='obj'><string name='filename' value='t.obj'/></shape>");
        assertEquals(1, ((TriangleMesh) SceneTexts.onlyShape(file).shape()).triangleCount());
        assertEquals(1, file.warnings().size());
        assertTrue(file.warnings().get(0).message().startsWith("2 triangles of zero area"));
    }

    @Test
    void warnsOfDarkness() throws IOException, SceneException {
        SceneFile file = SceneTexts.load(folder, "<scene version='3.0.0'>" + SceneTexts.SENSOR + "</scene>");
        assertEquals(1, file.warnings().size());
        assertTrue(file.warnings().get(0).toString().contains("scene.xml:1:1: the scene has no light"));
    }

    @Test
    void readsOtherEncodings() throws IOException, SceneException {
        String text = "<?xml version='1.0' encoding='%s'?>" + SceneTexts.scene("<shape type='sphere' id='Kugel ö'/>");
        Path file = folder.resolve("scene.xml");
        Files.write(file, String.format(text, "ISO-8859-1").getBytes(StandardCharsets.ISO_8859_1));
        assertEquals(
                "Kugel ö",
                SceneTexts.onlyShape(new SceneReader().load(file, Map.of())).name());
        Files.write(file, ("\ufeff" + String.format(text, "UTF-16")).getBytes(StandardCharsets.UTF_16LE));
        assertEquals(
                "Kugel ö",
                SceneTexts.onlyShape(new SceneReader().load(file, Map.of())).name());
        Files.write(file, ("\ufeff" + String.format(text, "UTF-8")).getBytes(StandardCharsets.UTF_8));
        assertEquals(
                "Kugel ö",
                SceneTexts.onlyShape(new SceneReader().load(file, Map.of())).name());
    }
}
