package org.daybreak.metropolis.manifold;

import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.Conductor;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.math.Transform;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.scene.ShapeNode;

/** Scenes of glass and mirrors for chains of delta lobes. */
final class SpecularScenes {
    static final int REFLECT = 0;
    static final int REFRACT = 1;
    static final ConstantTexture WHITE = ConstantTexture.grey(1);
    static final Bsdf MIRROR = Conductor.mirror(WHITE);
    static final Bsdf GLASS = new Dielectric(1.5, 1, WHITE, WHITE);
    static final Bsdf GREY = new Diffuse(ConstantTexture.grey(0.5));

    private SpecularScenes() {}

    static Scene scene(ShapeNode... nodes) {
        SceneGraph graph = new SceneGraph();
        Matrix4d camera = new Matrix4d();
        camera.setIdentity();
        graph.setCamera(new CameraSettings(camera, 40));
        graph.setFilm(new FilmSettings(4, 4, ReconstructionFilter.BOX));
        for (ShapeNode node : nodes) {
            graph.root().add(node);
        }
        return SceneCompiler.compile(graph);
    }

    /** A square of side 20 at a height, its front up or down. */
    static ShapeNode plane(double z, boolean up, Bsdf material) {
        ShapeNode node = new ShapeNode(new Rectangle(), material);
        node.setTransform(Transform.ofRows(10, 0, 0, 0, 0, up ? 10 : -10, 0, 0, 0, 0, up ? 1 : -1, z)
                .toMatrix4d());
        return node;
    }

    static ShapeNode sphere(double x, double y, double z, double radius, Bsdf material) {
        return new ShapeNode(new Sphere(new Point3d(x, y, z), radius), material);
    }

    /** A unit sphere of triangles with the normals of the sphere. */
    static ShapeNode smoothSphere(Bsdf material, Transform transform) {
        int rows = 12;
        int columns = 24;
        float[] positions = new float[3 * (rows + 1) * (columns + 1)];
        int[] triangles = new int[6 * rows * columns];
        for (int i = 0; i <= rows; i++) {
            for (int j = 0; j <= columns; j++) {
                double theta = Math.PI * i / rows;
                double phi = 2 * Math.PI * j / columns;
                int at = 3 * (i * (columns + 1) + j);
                positions[at] = (float) (Math.sin(theta) * Math.cos(phi));
                positions[at + 1] = (float) (Math.sin(theta) * Math.sin(phi));
                positions[at + 2] = (float) Math.cos(theta);
            }
        }
        int corner = 0;
        for (int i = 0; i < rows; i++) {
            for (int j = 0; j < columns; j++) {
                int a = i * (columns + 1) + j;
                int b = a + columns + 1;
                int[] quad = {a, b, b + 1, a, b + 1, a + 1};
                System.arraycopy(quad, 0, triangles, corner, 6);
                corner += 6;
            }
        }
        ShapeNode node = new ShapeNode(new TriangleMesh(positions, triangles, positions.clone(), null), material);
        node.setTransform(transform.toMatrix4d());
        return node;
    }

    /** A ball of glass, and two of mirror beside it. */
    static RayCaster balls() {
        return new RayCaster(
                scene(sphere(0, 0, 0, 1, GLASS), sphere(3, 0, -4, 2, MIRROR), sphere(0.5, 4, 0.2, 2, MIRROR)));
    }

    /** The same of triangles. */
    static RayCaster smoothBalls() {
        // Scaled unevenly, so that the normals are not those of the surface that the triangles stand for either.
        return new RayCaster(scene(
                smoothSphere(GLASS, Transform.scale(1, 1.2, 0.9)),
                smoothSphere(MIRROR, Transform.translate(3, 0, -4).multiply(Transform.scale(2, 2, 2))),
                smoothSphere(MIRROR, Transform.translate(0.5, 4, 0.2).multiply(Transform.scale(2, 2, -2)))));
    }
}
