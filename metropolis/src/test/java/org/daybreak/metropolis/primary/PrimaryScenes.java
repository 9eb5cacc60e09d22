package org.daybreak.metropolis.primary;

import javax.vecmath.Color3f;
import javax.vecmath.Point3d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.math.Transform;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.scene.ShapeNode;

/** Scenes for the tests of this package. */
final class PrimaryScenes {
    private final SceneGraph graph = new SceneGraph();

    private PrimaryScenes() {}

    /** The inside of a sphere with a lamp, a point light, a diffuse ball and one of glass, on a film of 9×6 pixels. */
    static Scene room() {
        return new PrimaryScenes().furnish().look(0);
    }

    /** The same through a thin lens. */
    static Scene roomThroughLens() {
        return new PrimaryScenes().furnish().look(0.05);
    }

    /** A diffuse ball and one of glass under a sky and a sun. */
    static Scene outdoors() {
        PrimaryScenes scene = new PrimaryScenes().balls();
        scene.add(
                new Disk(),
                Transform.translate(0, -0.7, -0.5)
                        .multiply(Transform.rotate(1, 0, 0, -90))
                        .multiply(Transform.scale(2, 2, 1)),
                diffuse(0.5));
        scene.graph.root().add(new LightNode(new LightSource.ConstantEnvironment(new Color3f(0.4f, 0.5f, 0.8f))));
        scene.graph
                .root()
                .add(new LightNode(new LightSource.Directional(new Color3f(1.5f, 1.2f, 1))))
                .setTransform(Transform.rotate(1, 0.2, 0, 60).toMatrix4d());
        return scene.look(0);
    }

    /** A ball and no light. */
    static Scene dark() {
        return new PrimaryScenes().balls().look(0);
    }

    private PrimaryScenes furnish() {
        balls();
        add(new Sphere(new Point3d(0, 0, 0), 1.6), Transform.identity(), diffuse(0.5))
                .setFlipNormals(true);
        add(
                        new Disk(),
                        Transform.translate(0.1, 0.6, -0.9)
                                .multiply(Transform.rotate(1, 0.1, 0, 55))
                                .multiply(Transform.scale(0.5, 0.45, 1)),
                        diffuse(0.4))
                .setRadiance(new ConstantTexture(3, 4, 5));
        graph.root()
                .add(new LightNode(new LightSource.Point(new Color3f(0.4f, 0.5f, 0.3f))))
                .setTransform(Transform.translate(-0.3, 0.7, 0.2).toMatrix4d());
        return this;
    }

    private PrimaryScenes balls() {
        add(new Sphere(new Point3d(0.5, -0.2, -0.5), 0.4), Transform.identity(), diffuse(0.7));
        add(
                new Sphere(new Point3d(-0.4, -0.3, -0.2), 0.35),
                Transform.identity(),
                new Dielectric(1.5, 1, ConstantTexture.grey(1), ConstantTexture.grey(1)));
        return this;
    }

    private static Bsdf diffuse(double reflectance) {
        return new Diffuse(ConstantTexture.grey(reflectance));
    }

    private ShapeNode add(Shape shape, Transform transform, Bsdf material) {
        ShapeNode node = graph.root().add(new ShapeNode(shape, material));
        node.setTransform(transform.toMatrix4d());
        return node;
    }

    private Scene look(double aperture) {
        Transform view = Transform.lookAt(0, 0, 1.3, 0, -0.1, -1, 0, 1, 0);
        graph.setCamera(new CameraSettings(view.toMatrix4d(), 60, CameraSettings.FovAxis.X, aperture, 1.6));
        graph.setFilm(new FilmSettings(9, 6, ReconstructionFilter.BOX));
        return SceneCompiler.compile(graph, new SceneCompiler.Options(1, null));
    }
}
