package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.util.List;
import javax.vecmath.Color3f;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.light.SkySettings;
import org.daybreak.core.material.Texture;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.Node;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.Test;

/** Lights of scene files. */
class SceneLightsTest extends SceneReading {
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
        return SceneTexts.lightNode(load(emitter));
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
}
