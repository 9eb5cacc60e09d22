package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.daybreak.core.color.SpectralColors;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.RoughPlastic;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.Node;
import org.daybreak.scenes.build.RenderSettingsRequest;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.description.SceneProblem;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Scenes of Mitsuba 0.6 mean the same as their translations by hand. */
class OldDialectTest {
    private static final String HEAD =
            "<scene version='0.6.0'><integrator type='bdpt'><integer name='maxDepth' value='7'/>"
                    + "<boolean name='lightImage' value='false'/><boolean name='sampleDirect' value='true'/>"
                    + "<boolean name='strictNormals' value='true'/></integrator><sensor type='perspective'>"
                    + "<float name='fov' value='30'/><string name='fovAxis' value='smaller'/><float name='focusDistance' value='9'/>"
                    + "<transform name='toWorld'><lookAt origin='0,0,5' target='0,0,0' up='0,1,0'/></transform>"
                    + "<sampler type='hammersley'><integer name='sampleCount' value='12'/></sampler>"
                    + "<film type='ldrfilm'><integer name='width' value='8'/><integer name='height' value='6'/>"
                    + "<string name='pixelFormat' value='rgb, rgba'/><float name='gamma' value='2.2'/></film></sensor>";

    @TempDir
    Path folder;

    private SceneFile load(String content) throws IOException, SceneException {
        return SceneTexts.load(folder, HEAD + content + "</scene>");
    }

    @Test
    void cameraFilmSamplerAndIntegrator() throws IOException, SceneException {
        SceneFile file = load("<emitter type='constant'/>");
        CameraSettings camera = file.graph().camera();
        assertNotNull(camera);
        assertEquals(CameraSettings.FovAxis.SMALLER, camera.axis());
        assertEquals(5, camera.toWorld().m23, 1e-12);
        assertNotNull(file.graph().film());
        assertEquals(6, file.graph().film().height());
        assertEquals(12, file.request().samplesPerPixel().getAsInt());
        assertEquals("bidirectional", file.request().rendererId().orElseThrow());
        assertEquals(
                Map.of(RenderSettingsRequest.MAX_DEPTH, "7", RenderSettingsRequest.CAUSTIC_MAP, "false"),
                file.request().parameters());
    }

    @Test
    void materialsAndTextures() throws IOException, SceneException {
        SceneFile file = load("<shape type='sphere'><bsdf type='roughplastic'><float name='intIOR' value='1.9'/>"
                + "<string name='distribution' value='phong'/><texture name='diffuseReflectance' type='checkerboard'>"
                + "<float name='uscale' value='10'/><float name='voffset' value='0.5'/></texture></bsdf></shape>"
                + "<emitter type='constant'><spectrum name='radiance' value='1, 2, 3'/></emitter>");
        assertInstanceOf(RoughPlastic.class, SceneTexts.onlyShape(file).material());
        LightSource.ConstantEnvironment light = (LightSource.ConstantEnvironment) light(file);
        assertEquals(2f, light.radiance().y);
        assertEquals(3f, light.radiance().z);
    }

    @Test
    void uscaleIsATransform() throws IOException, SceneException {
        String old = "<shape type='rectangle'><bsdf type='lambertian'><texture name='reflectance' type='checkerboard'>"
                + "<float name='uscale' value='3'/><float name='voffset' value='0.5'/></texture></bsdf></shape>";
        String translated = "<scene version='3.0.0'>" + SceneTexts.SENSOR + SceneTexts.LIGHT
                + "<shape type='rectangle'><bsdf type='diffuse'><texture name='reflectance' type='checkerboard'>"
                + "<transform name='to_uv'><scale x='3'/><translate y='0.5'/></transform></texture></bsdf></shape></scene>";
        SurfacePoint p = new SurfacePoint();
        Spectrum a = new Spectrum();
        Spectrum b = new Spectrum();
        var first = SceneTexts.onlyShape(load(old)).material();
        var second = SceneTexts.onlyShape(SceneTexts.load(folder, translated)).material();
        for (int i = 0; i < 100; i++) {
            p.u = 0.013 + 0.097 * i % 1;
            p.v = 0.017 + 0.053 * i % 1;
            first.albedo(p, a);
            second.albedo(p, b);
            assertEquals(b.r, a.r);
        }
    }

    /** Numbers are grey in RGB, also as light; wavelengths and black bodies are converted. */
    @Test
    void spectra() throws IOException, SceneException {
        LightSource.ConstantEnvironment flat = (LightSource.ConstantEnvironment)
                light(load("<emitter type='constant'><spectrum name='radiance' value='2'/></emitter>"));
        assertEquals(2f, flat.radiance().x);
        assertEquals(2f, flat.radiance().z);
        String list = "<emitter type='constant'><spectrum name='radiance' value='400:1, 500:3 700:2'/></emitter>";
        double[] expected = SpectralColors.emission(new double[] {400, 500, 700}, new double[] {1, 3, 2});
        for (SceneFile file : new SceneFile[] {
            load(list), SceneTexts.load(folder, "<scene version='3.0.0'>" + SceneTexts.SENSOR + list + "</scene>")
        }) {
            LightSource.ConstantEnvironment light = (LightSource.ConstantEnvironment) light(file);
            assertEquals(expected[0], light.radiance().x, 1e-6);
            assertEquals(expected[2], light.radiance().z, 1e-6);
        }
        LightSource.ConstantEnvironment body = (LightSource.ConstantEnvironment) light(load(
                "<emitter type='constant'><blackbody name='radiance' temperature='5000k' scale='1e-3'/></emitter>"));
        assertEquals(1e-3 * SpectralColors.blackbody(5000)[1], body.radiance().y, 1e-4);
        SceneTexts.write(folder, "s.spd", "# measured\n400 1\n500 3\n\n700 2\n");
        LightSource.ConstantEnvironment measured = (LightSource.ConstantEnvironment)
                light(load("<emitter type='constant'><spectrum name='radiance' filename='s.spd'/></emitter>"));
        assertEquals(expected[1], measured.radiance().y, 1e-6);
    }

    @Test
    void elementsOfTheOldestVersionsAndFilesWithoutVersion() throws IOException, SceneException {
        SceneFile file = SceneTexts.load(
                folder,
                "<scene><camera type='perspective'><boolean name='mapSmallerSide' value='true'/><float name='fov' value='30'/>"
                        + "<film type='pngfilm'><boolean name='alpha' value='false'/></film></camera>"
                        + "<luminaire type='constant'><rgb name='intensity' value='1'/></luminaire></scene>");
        assertEquals(1, file.warnings().size());
        assertTrue(file.warnings().get(0).message().contains("0.6.0 is assumed"));
    }

    @Test
    void whatCannotBeHadStaysAnErrorWithItsLine() throws IOException {
        var errors = SceneTexts.errors(
                folder,
                HEAD + "\n<bsdf type='irawan' id='a'/>\n<medium type='homogeneous' id='m'/>\n"
                        + "<shape type='spheer'/></scene>");
        assertTrue(errors.stream().anyMatch(e -> e.location().line() == 3), () -> errors.toString());
        String all = errors.toString();
        assertTrue(all.contains("'irawan' is not supported"), all);
        assertTrue(all.contains("<medium>: participating media are not supported"), all);
        assertTrue(all.contains("did you mean 'sphere'?"), all);
    }

    private static LightSource light(SceneFile file) {
        for (Node node : file.graph().root().children()) {
            if (node instanceof LightNode light) {
                return light.source();
            }
        }
        throw new AssertionError("no light");
    }

    @Test
    void otherIntegratorsOfGlobalLightBecomeThePathTracer() throws IOException, SceneException {
        SceneFile file = SceneTexts.load(folder, HEAD.replace("bdpt", "erpt") + "<emitter type='constant'/></scene>");
        assertEquals("path", file.request().rendererId().orElseThrow());
        assertTrue(
                file.warnings().stream().anyMatch(w -> w.message().contains("'erpt' is replaced by 'path'")),
                () -> file.warnings().toString());
    }

    private static String chains(String type, String properties) {
        return HEAD.replaceFirst(
                        "<integrator.*</integrator>", "<integrator type='" + type + "'>" + properties + "</integrator>")
                + "<emitter type='constant'/></scene>";
    }

    /** The strategies that Mitsuba 0.6 has by default, and no others. */
    @Test
    void pathSpaceMetropolisHasItsStrategies() throws IOException, SceneException {
        SceneFile plain = SceneTexts.load(folder, chains("mlt", ""));
        assertEquals(List.of(), plain.warnings());
        assertEquals("metropolis", plain.request().rendererId().orElseThrow());
        assertEquals(
                Map.of("lensSubpath", "0", "manifold", "0"), plain.request().parameters());
        assertEquals(12, plain.request().samplesPerPixel().getAsInt());
        SceneFile file = SceneTexts.load(
                folder,
                chains(
                        "mlt",
                        "<integer name='maxDepth' value='9'/><integer name='directSamples' value='-1'/>"
                                + "<integer name='luminanceSamples' value='5000'/><boolean name='twoStage' value='true'/>"
                                + "<boolean name='bidirectionalMutation' value='true'/>"
                                + "<boolean name='lensPerturbation' value='false'/>"
                                + "<boolean name='causticPerturbation' value='false'/>"
                                + "<boolean name='multiChainPerturbation' value='false'/>"
                                + "<boolean name='manifoldPerturbation' value='true'/>"
                                + "<integer name='workUnits' value='8'/>\n<float name='lambda' value='40'/>"));
        assertEquals(
                Map.of(
                        "maxDepth", "9",
                        "separateDirect", "false",
                        "bootstrapSamples", "5000",
                        "twoStage", "true",
                        "lensSubpath", "0",
                        "lens", "0",
                        "caustic", "0",
                        "multiChain", "0"),
                file.request().parameters());
        assertEquals(1, file.warnings().size(), () -> file.warnings().toString());
        assertEquals(2, file.warnings().get(0).location().line());
        assertTrue(file.warnings().get(0).message().startsWith("'lambda' has no effect"));
    }

    @Test
    void primarySampleSpaceMetropolisHasItsSteps() throws IOException, SceneException {
        SceneFile file = SceneTexts.load(
                folder,
                chains(
                        "pssmlt",
                        "<integer name='maxDepth' value='6'/><integer name='rrDepth' value='4'/>"
                                + "<integer name='directSamples' value='32'/><float name='pLarge' value='0.4'/>"
                                + "<boolean name='kelemenStyleWeights' value='false'/>"
                                + "<float name='mutationSizeHigh' value='0.05'/><integer name='timeout' value='10'/>"
                                + "<boolean name='bidirectional' value='false'/>"));
        assertEquals("pssmlt", file.request().rendererId().orElseThrow());
        assertEquals(
                Map.of(
                        "maxDepth", "6",
                        "rrDepth", "4",
                        "directSamples", "32",
                        "largeStep", "0.4",
                        "largestStep", "0.05"),
                file.request().parameters());
        assertEquals(
                List.of(
                        "'timeout' has no effect: give --time",
                        "'bidirectional' has no effect: samples are those of bidirectional path tracing"),
                file.warnings().stream().map(SceneProblem::message).toList());
    }
}
