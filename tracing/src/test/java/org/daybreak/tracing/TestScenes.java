package org.daybreak.tracing;

import javax.vecmath.Color3f;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.Conductor;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.Mask;
import org.daybreak.core.math.Transform;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.scene.ShapeNode;
import org.jspecify.annotations.Nullable;

/** Small scenes for the tests of this module. */
final class TestScenes {
    private TestScenes() {}

    /** The scene {@code cornell_spheres}: coloured walls, mirror and glass sphere, small ceiling light. */
    static Scene cornell(int width, int height) {
        SceneGraph graph = room(width, height, ReconstructionFilter.BOX);
        graph.root().add(new ShapeNode(new Sphere(new Point3d(-0.78, 0.56, -0.5), 0.56), Conductor.mirror(grey(0.95))));
        graph.root()
                .add(new ShapeNode(
                        new Sphere(new Point3d(0.78, 0.47, 0.12), 0.47), new Dielectric(1.5, 1, grey(1), grey(1))));
        return compile(graph);
    }

    /** The room of {@link #diffuseRoom} in the middle of a black image, of which it covers a quarter. */
    static Scene distantRoom(int width, int height) {
        SceneGraph graph = room(width, height, ReconstructionFilter.BOX);
        graph.root().add(new ShapeNode(new Sphere(new Point3d(-0.78, 0.56, -0.5), 0.56), diffuse(0.5)));
        look(graph, new Point3d(0, 1, 6), new Point3d(0, 0.985, 0), new Vector3d(0, 1, 0), 73, width, height);
        return compile(graph);
    }

    /** The room of {@link #cornell} with two diffuse spheres: all of it can be rendered by light tracing. */
    static Scene diffuseRoom(int width, int height, ReconstructionFilter filter) {
        SceneGraph graph = room(width, height, filter);
        graph.root().add(new ShapeNode(new Sphere(new Point3d(-0.78, 0.56, -0.5), 0.56), diffuse(0.5)));
        graph.root().add(new ShapeNode(new Sphere(new Point3d(0.78, 0.47, 0.12), 0.47), diffuse(0.8)));
        return compile(graph);
    }

    /** As {@link #diffuseRoom}, through a half transparent veil, lit by three more lights of different kinds. */
    static Scene veiledRoom(int width, int height) {
        SceneGraph graph = room(width, height, ReconstructionFilter.BOX);
        graph.root().add(new ShapeNode(new Sphere(new Point3d(-0.78, 0.56, -0.5), 0.56), diffuse(0.5)));
        Bsdf veil = new Mask(grey(0.4), diffuse(0.6));
        graph.root().add(rectangle(veil, null, 0.9, 0, 0, 0.3, 0, 0.9, 0, 1, 0, 0, 1, 0.7));
        // A veil under the ceiling light, so that occlusion queries and light subpaths pass through one.
        graph.root().add(rectangle(veil, null, 0.7, 0, 0, 0, 0, 0, -1, 1.5, 0, 0.7, 0, 0));
        graph.root()
                .add(new ShapeNode(new Sphere(new Point3d(1.2, 1.4, -0.8), 0.15), diffuse(0)))
                .setRadiance(new ConstantTexture(4, 6, 9));
        LightNode point = graph.root().add(new LightNode(new LightSource.Point(new Color3f(1, 0.5f, 0.4f))));
        Matrix4d at = new Matrix4d();
        at.setIdentity();
        at.setTranslation(new Vector3d(-1.2, 1.5, 0.4));
        point.setTransform(at);
        graph.root().add(new LightNode(new LightSource.ConstantEnvironment(new Color3f(0.2f, 0.3f, 0.5f))));
        return compile(graph);
    }

    /** A sphere of a reflectance in an environment of radiance 1. */
    static Scene furnaceSphere(double reflectance, int size) {
        SceneGraph graph = new SceneGraph();
        graph.root().add(new ShapeNode(new Sphere(new Point3d(0, 0, 0), 1), diffuse(reflectance)));
        graph.root().add(new LightNode(new LightSource.ConstantEnvironment(new Color3f(1, 1, 1))));
        look(graph, new Point3d(0, 0, 4), new Point3d(0, 0, 0), new Vector3d(0, 1, 0), 40, size, size);
        return compile(graph);
    }

    /** An environment of radiance (1, 2, 3) and nothing else. */
    static Scene sky(int width, int height) {
        SceneGraph graph = new SceneGraph();
        graph.root().add(new LightNode(new LightSource.ConstantEnvironment(new Color3f(1, 2, 3))));
        look(graph, new Point3d(1, 2, 3), new Point3d(0, 0, 0), new Vector3d(0, 1, 0), 70, width, height);
        return compile(graph);
    }

    /** A closed cube of walls that emit radiance 1 and reflect 0.5 diffusely, seen from inside. */
    static Scene furnaceBox(int size) {
        SceneGraph graph = new SceneGraph();
        Bsdf wall = diffuse(0.5);
        ConstantTexture one = grey(1);
        graph.root().add(rectangle(wall, one, 0, 0, 1, -1, 0, 1, 0, 0, -1, 0, 0, 0));
        graph.root().add(rectangle(wall, one, 0, 0, -1, 1, 0, 1, 0, 0, 1, 0, 0, 0));
        graph.root().add(rectangle(wall, one, -1, 0, 0, 0, 0, 0, 1, -1, 0, 1, 0, 0));
        graph.root().add(rectangle(wall, one, 1, 0, 0, 0, 0, 0, -1, 1, 0, 1, 0, 0));
        graph.root().add(rectangle(wall, one, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, -1));
        graph.root().add(rectangle(wall, one, -1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 1));
        look(graph, new Point3d(0.3, 0.2, 0.4), new Point3d(-1, -0.3, -0.8), new Vector3d(0, 1, 0), 80, size, size);
        return compile(graph);
    }

    /**
     * A point light of intensity 10 two units above a diffuse plane y = 0 of reflectance 0.5, seen from above.
     *
     * @param sheets materials of large sheets between light and plane
     */
    static Scene pointOverPlane(int size, Bsdf... sheets) {
        SceneGraph graph = new SceneGraph();
        for (int i = 0; i < sheets.length; i++) {
            graph.root().add(rectangle(sheets[i], null, 30, 0, 0, 0, 0, 0, 1, 0.5 * (i + 1), 0, -30, 0, 0));
        }
        graph.root().add(rectangle(diffuse(0.5), null, 30, 0, 0, 0, 0, 0, 1, 0, 0, -30, 0, 0));
        LightNode light = graph.root().add(new LightNode(new LightSource.Point(new Color3f(10, 10, 10))));
        Matrix4d up = new Matrix4d();
        up.setIdentity();
        up.setTranslation(new Vector3d(0, 2, 0));
        light.setTransform(up);
        look(graph, new Point3d(0, 6, 0), new Point3d(0, 0, 0), new Vector3d(0, 0, -1), 60, size, size);
        return compile(graph);
    }

    private static SceneGraph room(int width, int height, ReconstructionFilter filter) {
        SceneGraph graph = new SceneGraph();
        Bsdf white = new Diffuse(new ConstantTexture(0.74, 0.73, 0.7));
        Bsdf red = new Diffuse(new ConstantTexture(0.63, 0.06, 0.05));
        Bsdf blue = new Diffuse(new ConstantTexture(0.12, 0.22, 0.6));
        // x spans ±1.75, z ±1.45, y from 0 to 2.
        graph.root().add(rectangle(white, null, 1.75, 0, 0, 0, 0, 0, 1, 0, 0, -1.45, 0, 0));
        graph.root().add(rectangle(white, null, 1.75, 0, 0, 0, 0, 0, -1, 2, 0, 1.45, 0, 0));
        graph.root().add(rectangle(white, null, 1.75, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1, -1.45));
        graph.root().add(rectangle(red, null, 0, 0, 1, -1.75, 0, 1, 0, 1, -1.45, 0, 0, 0));
        graph.root().add(rectangle(blue, null, 0, 0, -1, 1.75, 0, 1, 0, 1, 1.45, 0, 0, 0));
        graph.root()
                .add(rectangle(
                        diffuse(0),
                        new ConstantTexture(17, 15.5, 12.5),
                        0.42,
                        0,
                        0,
                        0,
                        0,
                        0,
                        -1,
                        1.996,
                        0,
                        0.32,
                        0,
                        -0.05));
        look(graph, new Point3d(0, 1, 6), new Point3d(0, 0.985, 0), new Vector3d(0, 1, 0), 40.6, width, height, filter);
        return graph;
    }

    /** A rectangle under the first three rows of a matrix. */
    private static ShapeNode rectangle(Bsdf material, @Nullable ConstantTexture radiance, double... rows) {
        ShapeNode node = new ShapeNode(new Rectangle(), material).setRadiance(radiance);
        double[] m = java.util.Arrays.copyOf(rows, 16);
        m[15] = 1;
        node.setTransform(new Matrix4d(m));
        return node;
    }

    private static void look(
            SceneGraph graph, Point3d origin, Point3d target, Vector3d up, double fov, int width, int height) {
        look(graph, origin, target, up, fov, width, height, ReconstructionFilter.BOX);
    }

    private static void look(
            SceneGraph graph,
            Point3d origin,
            Point3d target,
            Vector3d up,
            double fov,
            int width,
            int height,
            ReconstructionFilter filter) {
        graph.setCamera(new CameraSettings(
                Transform.lookAt(origin.x, origin.y, origin.z, target.x, target.y, target.z, up.x, up.y, up.z)
                        .toMatrix4d(),
                fov));
        graph.setFilm(new FilmSettings(width, height, filter));
    }

    private static ConstantTexture grey(double value) {
        return ConstantTexture.grey(value);
    }

    private static Bsdf diffuse(double reflectance) {
        return new Diffuse(grey(reflectance));
    }

    private static Scene compile(SceneGraph graph) {
        return SceneCompiler.compile(graph, new SceneCompiler.Options(1, null));
    }
}
