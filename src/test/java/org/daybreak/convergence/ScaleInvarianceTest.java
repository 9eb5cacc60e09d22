package org.daybreak.convergence;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import javax.vecmath.Matrix4d;
import javax.vecmath.Vector3d;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.testing.ZTest;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * A scene that is larger or smaller as a whole gives the same picture: there is no absolute length in the program. Radiance
 * stays; there are no point lights in these scenes, whose intensity would have to grow with the square.
 */
class ScaleInvarianceTest {
    private static final int SAMPLES = 4;
    private static final long SEED = 3;

    /** Powers of two change exponents only: every length, area and density scales exactly, so nothing else changes. */
    @ParameterizedTest
    @CsvSource({
        "cornell_spheres, path, -13",
        "cornell_spheres, path, 13",
        "cornell_spheres, light, -13",
        "cornell_spheres, light, 13",
        "cornell_spheres, raytracer, 13",
        "gold_ring, path, -13",
        "gold_ring, path, 13",
        "door_ajar, path, -13",
        "door_ajar, path, 13",
        "cornell_spheres, bidirectional, -13",
        "cornell_spheres, bidirectional, 13",
        "gold_ring, bidirectional, -13",
        "door_ajar, bidirectional, 13",
        "veach_room, bidirectional, 13",
    })
    void powersOfTwoDoNotChangeABit(String name, String rendererId, int exponent) throws SceneException {
        Renderer renderer = Rendering.renderer(rendererId);
        FilmImage expected = Rendering.render(renderer, scaled(name, 1), SEED, SAMPLES);
        FilmImage actual = Rendering.render(renderer, scaled(name, Math.scalb(1.0, exponent)), SEED, SAMPLES);
        for (String channel : Runs.CHANNELS) {
            assertArrayEquals(expected.channel(channel), actual.channel(channel), channel);
        }
    }

    /**
     * Other factors round coordinates differently, by a relative 6e-8. That moves points by as much, and now and then a
     * ray goes past an edge that it met, or a sharply curved mirror throws it elsewhere: a few samples change altogether,
     * the others hardly.
     */
    @ParameterizedTest
    @CsvSource({
        "cornell_spheres, path, 1e-4, 0.005",
        "cornell_spheres, path, 1e4, 0.005",
        "cornell_spheres, light, 1e-4, 0.005",
        "cornell_spheres, light, 1e4, 0.005",
        "gold_ring, path, 1e-4, 0.005",
        "gold_ring, path, 1e4, 0.005",
        "door_ajar, path, 1e-4, 0.005",
        "door_ajar, path, 1e4, 0.005",
    })
    void otherFactorsChangeNextToNothing(String name, String rendererId, double factor, double changed)
            throws SceneException {
        Renderer renderer = Rendering.renderer(rendererId);
        FilmImage expected = Rendering.render(renderer, scaled(name, 1), SEED, SAMPLES);
        FilmImage actual = Rendering.render(renderer, scaled(name, factor), SEED, SAMPLES);
        int different = 0;
        float[] before = expected.channel("G");
        float[] after = actual.channel("G");
        for (int i = 0; i < before.length; i++) {
            different += Math.abs(after[i] - before[i]) > 1e-3 * before[i] ? 1 : 0;
        }
        assertTrue(different <= changed * before.length, different + " of " + before.length + " pixels changed");
    }

    /** Other seeds, so that the images are independent: t-tests per tile, false-alarm rate 1e-4 for each scene. */
    @ParameterizedTest
    @CsvSource({
        "cornell_spheres, path, 1e-4",
        "cornell_spheres, path, 1e4",
        "cornell_spheres, bidirectional, 1e-4",
        "cornell_spheres, bidirectional, 1e4",
    })
    void meansAreEqual(String name, String rendererId, double factor) throws SceneException {
        Renderer renderer = Rendering.renderer(rendererId);
        Runs expected = Runs.of(renderer, scaled(name, 1), 100, 16, 8);
        Runs actual = Runs.of(renderer, scaled(name, factor), 200, 16, 8);
        double[] pValues = ZTest.tilesOfRuns(expected.tiles("G", 12), actual.tiles("G", 12));
        ZTest.assertNoneRejected(name + " times " + factor, pValues, 1e-4);
    }

    private static Scene scaled(String name, double factor) throws SceneException {
        SceneGraph graph = ShippedScenes.read(name + "/scene.xml").graph();
        Matrix4d transform = graph.root().transform();
        Matrix4d scale = new Matrix4d();
        scale.set(factor);
        scale.mul(transform);
        graph.root().setTransform(scale);
        CameraSettings camera = graph.camera();
        assertNotNull(camera);
        assertEquals(0, camera.apertureRadius());
        Matrix4d toWorld = camera.toWorld();
        toWorld.setTranslation(new Vector3d(toWorld.m03 * factor, toWorld.m13 * factor, toWorld.m23 * factor));
        graph.setCamera(new CameraSettings(toWorld, camera.fieldOfViewDegrees()));
        graph.setFilm(new FilmSettings(64, 36, ReconstructionFilter.BOX));
        Scene scene = SceneCompiler.compile(graph);
        double size = scene.bounds().boundingSphereRadius() / factor;
        assertTrue(size > 1 && size < 50, () -> "the scene is scaled: " + size);
        return scene;
    }
}
