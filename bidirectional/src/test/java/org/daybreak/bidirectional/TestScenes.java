package org.daybreak.bidirectional;

import javax.vecmath.Color3f;
import javax.vecmath.Point3d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.Mask;
import org.daybreak.core.material.Microfacet;
import org.daybreak.core.material.RoughDielectric;
import org.daybreak.core.material.Roughness;
import org.daybreak.core.math.Transform;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.Group;
import org.daybreak.core.scene.Instance;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.scene.ShapeNode;

/**
 * Scenes for the tests of this module. Rooms are the inside of a sphere: between points of its wall the geometry term is
 * constant, and nothing touches it, so that no technique has a contribution without bound.
 */
final class TestScenes {
    private final SceneGraph graph = new SceneGraph();

    private TestScenes() {}

    /** A round room with a lamp of a disk and two diffuse balls. */
    static Scene room(int size) {
        return new TestScenes().hall().disk().balls(diffuse(0.6)).look(size, 0).compile();
    }

    /** As {@link #room}, through a thin lens. */
    static Scene roomThroughLens(int size) {
        return new TestScenes()
                .hall()
                .disk()
                .balls(diffuse(0.6))
                .look(size, 0.05)
                .compile();
    }

    /** As {@link #room}, through a lens that light paths often hit. */
    static Scene roomThroughWideLens(int size) {
        return new TestScenes()
                .hall()
                .disk()
                .balls(diffuse(0.6))
                .look(size, 0.4)
                .compile();
    }

    /** A room with a ball of clear glass and a veil through a wide lens. */
    static Scene glassThroughWideLens(int width, int height) {
        TestScenes scene = new TestScenes().hall().disk().balls(diffuse(0.6)).glassAndVeil();
        scene.look(width, 0.4);
        scene.graph.setFilm(new FilmSettings(width, height, ReconstructionFilter.BOX));
        return scene.compile();
    }

    /** A point light before a lens, out of its focus, and nothing else. */
    static Scene pointBeforeWideLens(int size) {
        TestScenes scene = new TestScenes();
        scene.graph
                .root()
                .add(new LightNode(new LightSource.Point(new Color3f(0.4f, 0.5f, 0.3f))))
                .setTransform(Transform.translate(0.1, -0.05, -0.9).toMatrix4d());
        return scene.look(size, 0.2).compile();
    }

    /** As {@link #room}, with parallel rays. */
    static Scene roomOfParallelRays(int size) {
        TestScenes scene = new TestScenes().hall().disk().balls(diffuse(0.6)).look(size, 0);
        scene.graph.setCamera(CameraSettings.orthographic(
                view().multiply(Transform.scale(0.8, 0.8, 1)).toMatrix4d()));
        return scene.compile();
    }

    /** A round room with balls of rough glass, one of them of a few facets with the normals of a sphere. */
    static Scene roughGlass(int size) {
        Bsdf glass = new RoughDielectric(
                Microfacet.Kind.GGX, Roughness.of(0.5), 1.5, 1, ConstantTexture.grey(1), ConstantTexture.grey(1));
        return new TestScenes().hall().disk().balls(glass).look(size, 0).compile();
    }

    /** A round room with a group of a facetted ball and a lamp, once as it is and once mirrored. */
    static Scene mirroredInstance(int size) {
        TestScenes scene = new TestScenes().hall();
        Group group = new Group();
        group.add(new ShapeNode(globe(9, 6), diffuse(0.7)))
                .setTransform(Transform.scale(0.4, 0.3, 0.4).toMatrix4d());
        ShapeNode lamp = group.add(new ShapeNode(new Disk(), diffuse(0.3)));
        lamp.setTransform(Transform.translate(0.1, 0.9, 0)
                .multiply(Transform.rotate(1, 0, 0.2, 80))
                .multiply(Transform.scale(0.3, 0.4, 1))
                .toMatrix4d());
        lamp.setRadiance(new ConstantTexture(2, 4, 5));
        for (int side = -1; side <= 1; side += 2) {
            scene.graph
                    .root()
                    .add(new Instance(group))
                    .setTransform(Transform.translate(0.5 * side, -0.2, -0.4)
                            .multiply(Transform.scale(side, 1, 1))
                            .toMatrix4d());
        }
        return scene.look(size, 0).compile();
    }

    /** A round room lit by lights without extent. */
    static Scene pointAndSpot(int size) {
        TestScenes scene = new TestScenes().hall().balls(diffuse(0.6));
        scene.graph
                .root()
                .add(new LightNode(new LightSource.Point(new Color3f(0.4f, 0.5f, 0.3f))))
                .setTransform(Transform.translate(-0.3, 0.7, 0.2).toMatrix4d());
        scene.graph
                .root()
                .add(new LightNode(new LightSource.Spot(new Color3f(2, 2, 1), 60, 30)))
                .setTransform(Transform.lookAt(0.4, 0.8, 0.4, 0, -0.6, -0.4, 0, 1, 0.1)
                        .toMatrix4d());
        return scene.look(size, 0).compile();
    }

    /** Balls before a half transparent wall under an environment and a directional light. */
    static Scene outdoors(int size) {
        TestScenes scene = new TestScenes().balls(diffuse(0.7));
        scene.add(
                new Disk(),
                Transform.translate(0, -1, -0.5)
                        .multiply(Transform.rotate(1, 0, 0, -90))
                        .multiply(Transform.scale(2, 2, 1)),
                diffuse(0.5));
        scene.add(
                new Rectangle(),
                Transform.translate(-0.1, 0, 0.6).multiply(Transform.scale(0.5, 0.4, 1)),
                new Mask(ConstantTexture.grey(0.4), diffuse(0.8)));
        scene.graph.root().add(new LightNode(new LightSource.ConstantEnvironment(new Color3f(0.4f, 0.5f, 0.8f))));
        scene.graph
                .root()
                .add(new LightNode(new LightSource.Directional(new Color3f(1.5f, 1.2f, 1))))
                .setTransform(Transform.rotate(1, 0.2, 0, 60).toMatrix4d());
        return scene.look(size, 0).compile();
    }

    /** A room with a ball of clear glass, a veil, and lights of all kinds. */
    static Scene everything(int width, int height) {
        TestScenes scene = new TestScenes().hall().disk().balls(diffuse(0.6)).glassAndVeil();
        scene.graph
                .root()
                .add(new LightNode(new LightSource.Point(new Color3f(0.4f, 0.5f, 0.3f))))
                .setTransform(Transform.translate(-0.3, 0.7, 0.2).toMatrix4d());
        scene.graph.root().add(new LightNode(new LightSource.ConstantEnvironment(new Color3f(0.4f, 0.5f, 0.8f))));
        scene.look(width, 0);
        scene.graph.setFilm(new FilmSettings(width, height, ReconstructionFilter.BOX));
        return scene.compile();
    }

    private TestScenes hall() {
        add(new Sphere(new Point3d(0, 0, 0), 1.6), Transform.identity(), diffuse(0.5))
                .setFlipNormals(true);
        return this;
    }

    private TestScenes disk() {
        add(
                        new Disk(),
                        Transform.translate(0.1, 0.5, -0.9)
                                .multiply(Transform.rotate(1, 0.1, 0, 55))
                                .multiply(Transform.scale(0.5, 0.45, 1)),
                        diffuse(0.4))
                .setRadiance(new ConstantTexture(3, 4, 5));
        return this;
    }

    private TestScenes glassAndVeil() {
        add(
                new Sphere(new Point3d(0, -0.6, -0.1), 0.25),
                Transform.identity(),
                new Dielectric(1.5, 1, ConstantTexture.grey(1), ConstantTexture.grey(1)));
        add(
                new Rectangle(),
                Transform.translate(-0.1, 0, 0.5).multiply(Transform.scale(0.5, 0.4, 1)),
                new Mask(ConstantTexture.grey(0.4), diffuse(0.8)));
        return this;
    }

    private TestScenes balls(Bsdf material) {
        add(new Sphere(new Point3d(0.5, -0.2, -0.5), 0.4), Transform.identity(), material);
        add(globe(12, 8), Transform.translate(-0.5, -0.1, -0.5).multiply(Transform.scale(0.4, 0.45, 0.35)), material);
        return this;
    }

    private TestScenes look(int size, double apertureRadius) {
        graph.setCamera(new CameraSettings(view().toMatrix4d(), 60, CameraSettings.FovAxis.X, apertureRadius, 1.2));
        graph.setFilm(new FilmSettings(size, size, ReconstructionFilter.BOX));
        return this;
    }

    private static Transform view() {
        return Transform.lookAt(0.05, 0.1, 1.2, 0, -0.1, -0.4, 0.05, 1, 0);
    }

    private ShapeNode add(Shape shape, Transform transform, Bsdf material) {
        ShapeNode node = graph.root().add(new ShapeNode(shape, material));
        node.setTransform(transform.toMatrix4d());
        return node;
    }

    private Scene compile() {
        return SceneCompiler.compile(graph, new SceneCompiler.Options(1, null));
    }

    private static Bsdf diffuse(double reflectance) {
        return new Diffuse(ConstantTexture.grey(reflectance));
    }

    /** A unit sphere of few triangles, with the normals of the sphere. */
    private static TriangleMesh globe(int meridians, int parallels) {
        int vertices = meridians * (parallels + 1);
        float[] positions = new float[3 * vertices];
        int[] triangles = new int[6 * meridians * (parallels - 1)];
        int used = 0;
        for (int j = 0; j <= parallels; j++) {
            for (int i = 0; i < meridians; i++) {
                double theta = Math.PI * j / parallels;
                double phi = 2 * Math.PI * i / meridians;
                int here = j * meridians + i;
                positions[3 * here] = (float) (Math.sin(theta) * Math.sin(phi));
                positions[3 * here + 1] = (float) Math.cos(theta);
                positions[3 * here + 2] = (float) (Math.sin(theta) * Math.cos(phi));
                int right = j * meridians + (i + 1) % meridians;
                if (j > 0 && j < parallels) {
                    used = triangle(triangles, used, here - meridians, here, right);
                }
                if (j > 1) {
                    used = triangle(triangles, used, here - meridians, right, right - meridians);
                }
            }
        }
        return new TriangleMesh(positions, triangles, positions.clone(), null);
    }

    private static int triangle(int[] triangles, int at, int a, int b, int c) {
        triangles[at] = a;
        triangles[at + 1] = b;
        triangles[at + 2] = c;
        return at + 3;
    }
}
