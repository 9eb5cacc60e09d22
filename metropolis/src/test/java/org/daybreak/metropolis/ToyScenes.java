package org.daybreak.metropolis;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.function.Consumer;
import javax.vecmath.Color3f;
import javax.vecmath.Point3d;
import org.daybreak.core.accel.PrimitiveSet;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.light.RadianceMap;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.Conductor;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.Mask;
import org.daybreak.core.material.NormalMap;
import org.daybreak.core.material.Plastic;
import org.daybreak.core.material.TwoSided;
import org.daybreak.core.math.Transform;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.core.testing.TestMesh;

/**
 * Small scenes with few things each, whose path space can be tabulated. Rooms are the inside of a sphere, between points of which the
 * geometry term is constant, and nothing touches it: no sample of bidirectional path tracing is much brighter than the others.
 */
final class ToyScenes {
    /** Width and height of the film in pixels. */
    static final int SIZE = 12;

    /**
     * A scene.
     *
     * @param shortest smallest number of edges of the paths that are of interest: where shorter ones are left out there is more of others
     */
    private record Toy(int shortest, Consumer<ToyScenes> content) {}

    private static final Map<String, Toy> SCENES = new LinkedHashMap<>();

    static {
        SCENES.put(
                "area light",
                new Toy(1, s -> s.hall().lamp().balls(diffuse(0.6)).look(0)));
        SCENES.put(
                "point and spot light",
                new Toy(2, s -> s.hall().points().balls(diffuse(0.6)).look(0)));
        SCENES.put("environments", new Toy(1, s -> s.skies().balls(diffuse(0.7)).look(0)));
        SCENES.put(
                "mirror and glass",
                new Toy(4, s -> s.hall().lamp().glassAndMirror().look(0)));
        SCENES.put(
                "glass under a point light",
                new Toy(3, s -> s.hall().points().glassAndMirror().look(0)));
        SCENES.put("plastic", new Toy(3, s -> s.hall().lamp().balls(plastic()).look(0)));
        SCENES.put("masks", new Toy(2, s -> s.hall().lamp().masks().look(0)));
        SCENES.put(
                "masked lamp",
                new Toy(1, s -> s.hall().maskedLamp().balls(plastic()).look(0)));
        SCENES.put("thin lens", new Toy(3, s -> s.hall().lamp().glassAndMirror().look(0.1)));
        SCENES.put("parallel rays", new Toy(1, s -> s.skies().glassAndMirror().parallel()));
        SCENES.put("shading normals", new Toy(3, s -> s.hall().lamp().facets().look(0)));
        SCENES.put("normal maps", new Toy(3, s -> s.hall().lamp().normalMaps().look(0)));
        SCENES.put(
                "shining glass", new Toy(1, s -> s.hall().lamp().shiningGlass().look(0)));
    }

    private final SceneGraph graph = new SceneGraph();

    private ToyScenes() {}

    /** Names of all scenes. */
    static Iterable<String> names() {
        return SCENES.keySet();
    }

    /** Smallest number of edges of the paths that count in a scene. */
    static int shortest(String name) {
        return SCENES.get(name).shortest;
    }

    /** The scene of a name. */
    static Scene scene(String name) {
        return scene(name, SIZE, SIZE);
    }

    /** The scene of a name with a film of another size. */
    static Scene scene(String name, int width, int height) {
        ToyScenes scene = new ToyScenes();
        SCENES.get(name).content.accept(scene);
        scene.graph.setFilm(new FilmSettings(width, height, ReconstructionFilter.BOX));
        return SceneCompiler.compile(scene.graph, new SceneCompiler.Options(1, null));
    }

    private ToyScenes hall() {
        add(new Sphere(new Point3d(0, 0, 0), 1.6), Transform.identity(), diffuse(0.5))
                .setFlipNormals(true);
        return this;
    }

    private ToyScenes lamp() {
        add(new Disk(), lampPlace(), diffuse(0.4)).setRadiance(new ConstantTexture(3, 4, 5));
        return this;
    }

    /** A lamp that some of the light passes straight through. */
    private ToyScenes maskedLamp() {
        add(new Disk(), lampPlace(), new Mask(ConstantTexture.grey(0.4), new TwoSided(diffuse(0.4), diffuse(0.6))))
                .setRadiance(new ConstantTexture(3, 4, 5));
        return this;
    }

    private static Transform lampPlace() {
        return Transform.translate(0.1, 0.5, -0.9)
                .multiply(Transform.rotate(1, 0.1, 0, 55))
                .multiply(Transform.scale(0.5, 0.45, 1));
    }

    private ToyScenes points() {
        light(new LightSource.Point(new Color3f(0.4f, 0.5f, 0.3f)), Transform.translate(-0.1, 0.7, 0.2));
        light(
                new LightSource.Spot(new Color3f(2, 2, 1), 60, 30),
                Transform.lookAt(0.2, 0.8, 0.4, 0, -0.6, -0.4, 0, 1, 0.1));
        return this;
    }

    /** Two environments, a light that is one direction, a floor and a lamp. */
    private ToyScenes skies() {
        float[] rgb = new float[3 * 8 * 4];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = 0.2f + 0.1f * (i % 7);
        }
        light(new LightSource.ConstantEnvironment(new Color3f(0.4f, 0.5f, 0.8f)), Transform.identity());
        light(new LightSource.ImageEnvironment(new RadianceMap(8, 4, rgb), 0.5), Transform.rotate(0.2, 1, 0.1, 77));
        light(new LightSource.Directional(new Color3f(1.5f, 1.2f, 1)), Transform.rotate(1, 0.2, 0, 60));
        add(
                new Disk(),
                Transform.translate(0, -0.8, -0.5)
                        .multiply(Transform.rotate(1, 0, 0, -90))
                        .multiply(Transform.scale(1.2, 1.2, 1)),
                diffuse(0.5));
        return lamp();
    }

    private ToyScenes balls(Bsdf material) {
        add(new Sphere(new Point3d(0.5, -0.2, -0.5), 0.4), Transform.identity(), material);
        add(new Sphere(new Point3d(-0.5, -0.1, -0.5), 0.35), Transform.identity(), material);
        return this;
    }

    private ToyScenes glassAndMirror() {
        add(new Sphere(new Point3d(0.4, -0.1, -0.3), 0.5), Transform.identity(), glass());
        add(new Sphere(new Point3d(-0.5, -0.1, -0.5), 0.45), Transform.identity(), mirror());
        return this;
    }

    private ToyScenes shiningGlass() {
        add(new Sphere(new Point3d(0.4, -0.1, -0.3), 0.5), Transform.identity(), glass())
                .setRadiance(new ConstantTexture(0.5, 0.6, 0.7));
        add(new Sphere(new Point3d(-0.5, -0.1, -0.5), 0.45), Transform.identity(), mirror())
                .setRadiance(new ConstantTexture(0.8, 0.7, 0.5));
        return this;
    }

    private ToyScenes masks() {
        add(
                new Rectangle(),
                Transform.translate(-0.4, 0, -0.1)
                        .multiply(Transform.rotate(0.1, 1, 0.1, 15))
                        .multiply(Transform.scale(0.4, 0.5, 1)),
                new Mask(ConstantTexture.grey(0.4), new TwoSided(plastic(), diffuse(0.8))));
        add(
                new Sphere(new Point3d(0.4, -0.1, -0.3), 0.4),
                Transform.identity(),
                new Mask(ConstantTexture.grey(0.7), glass()));
        return this;
    }

    /** Balls of few facets with the normals of spheres. */
    private ToyScenes facets() {
        PrimitiveSet sphere = TestMesh.sphere(7, 10).placed(1, 0, 0, 0);
        TriangleMesh mesh = new TriangleMesh(
                sphere.positions(), sphere.triangles(), sphere.positions().clone(), null);
        add(mesh, Transform.translate(0.5, -0.1, -0.3).multiply(Transform.scale(0.45, 0.5, 0.45)), glass());
        add(mesh, Transform.translate(-0.5, -0.1, -0.5).multiply(Transform.scale(0.4, 0.4, 0.45)), plastic());
        return this;
    }

    private ToyScenes normalMaps() {
        add(
                new Sphere(new Point3d(0.5, -0.1, -0.4), 0.45),
                Transform.identity(),
                new NormalMap(new ConstantTexture(0.65, 0.4, 0.9), mirror(), true));
        add(
                new Sphere(new Point3d(-0.5, -0.1, -0.5), 0.4),
                Transform.identity(),
                new NormalMap(new ConstantTexture(0.6, 0.42, 0.9), plastic(), false));
        return this;
    }

    private void look(double apertureRadius) {
        graph.setCamera(new CameraSettings(view().toMatrix4d(), 60, CameraSettings.FovAxis.X, apertureRadius, 1.2));
    }

    private void parallel() {
        graph.setCamera(CameraSettings.orthographic(
                view().multiply(Transform.scale(0.9, 0.9, 1)).toMatrix4d()));
    }

    private static Transform view() {
        return Transform.lookAt(0.05, 0.1, 1.2, 0, -0.1, -0.4, 0.05, 1, 0);
    }

    private void light(LightSource source, Transform place) {
        graph.root().add(new LightNode(source)).setTransform(place.toMatrix4d());
    }

    private ShapeNode add(Shape shape, Transform place, Bsdf material) {
        ShapeNode node = graph.root().add(new ShapeNode(shape, material));
        node.setTransform(place.toMatrix4d());
        return node;
    }

    private static Bsdf diffuse(double reflectance) {
        return new Diffuse(ConstantTexture.grey(reflectance));
    }

    private static Bsdf plastic() {
        return new Plastic(1.9, 1, ConstantTexture.grey(0.5), ConstantTexture.grey(1), true);
    }

    private static Bsdf mirror() {
        return Conductor.mirror(ConstantTexture.grey(0.8));
    }

    private static Bsdf glass() {
        return new Dielectric(1.5, 1, ConstantTexture.grey(1), ConstantTexture.grey(1));
    }
}
