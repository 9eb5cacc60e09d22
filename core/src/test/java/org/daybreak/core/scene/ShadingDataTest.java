package org.daybreak.core.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Cylinder;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.BitmapTexture;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.CheckerboardTexture;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.Mask;
import org.daybreak.core.material.Microfacet;
import org.daybreak.core.material.NormalMap;
import org.daybreak.core.material.NullBsdf;
import org.daybreak.core.material.RoughConductor;
import org.daybreak.core.material.Roughness;
import org.daybreak.core.material.Texture;
import org.daybreak.core.material.TextureImage;
import org.daybreak.core.material.TwoSided;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.junit.jupiter.api.Test;

/** What materials learn of a hit beyond position and normal, and what rays leave behind. */
class ShadingDataTest {
    private static final double[] IDENTITY = {1, 0, 0, 0, 1, 0};

    private final SurfacePoint hit = new SurfacePoint();

    /** Needs a frame along texture coordinates, and those too. */
    private static Bsdf brushed() {
        return RoughConductor.mirror(
                Microfacet.Kind.GGX,
                Roughness.of(
                        ConstantTexture.grey(0.1),
                        new CheckerboardTexture(ConstantTexture.grey(0.5), ConstantTexture.grey(0.4), IDENTITY)),
                ConstantTexture.grey(1));
    }

    private static Scene scene(Node... nodes) {
        SceneGraph graph = new SceneGraph();
        Matrix4d camera = new Matrix4d();
        camera.setIdentity();
        graph.setCamera(new CameraSettings(camera, 40));
        graph.setFilm(new FilmSettings(4, 4, ReconstructionFilter.BOX));
        for (Node node : nodes) {
            graph.root().add(node);
        }
        return SceneCompiler.compile(graph);
    }

    private static Matrix4d skewed() {
        return Transform.ofRows(2, 0.3, 0.1, 0.5, 0, 1.5, -0.2, -1, 0.4, 0, 0.8, 0.2)
                .toMatrix4d();
    }

    /** Finite differences of positions by texture coordinates agree with the derivatives and the frame that hits report. */
    @Test
    void framesLieAlongTextureCoordinates() {
        TriangleMesh mesh = new TriangleMesh(
                new float[] {-1, -1, 0, 1, -1, 0.3f, 1, 1, 0, -1, 1.5f, 0.2f},
                new int[] {0, 1, 2, 2, 3, 0},
                new float[] {-0.2f, 0, 1, 0.3f, 0, 1, 0, 0.1f, 1, 0, -0.3f, 1},
                new float[] {0, 0, 2, 0.1f, 1.5f, 3, -0.2f, 1});
        List<Shape> shapes = List.of(
                new Sphere(new Point3d(0, 0, 0), 0.9),
                new Disk(),
                new Cylinder(new Point3d(0, 0, -1), new Point3d(0, 0.2, 1), 0.7),
                new Rectangle(),
                mesh);
        for (Shape shape : shapes) {
            for (boolean instanced : new boolean[] {false, true}) {
                for (boolean flipped : new boolean[] {false, true}) {
                    checkFrames(shape, instanced, flipped);
                }
            }
        }
    }

    private void checkFrames(Shape shape, boolean instanced, boolean flipped) {
        ShapeNode node = new ShapeNode(shape, brushed());
        node.setFlipNormals(flipped);
        Node top = node;
        if (instanced) {
            Group group = new Group();
            group.add(node);
            top = new Instance(group);
        }
        top.setTransform(skewed());
        RayCaster caster = new RayCaster(scene(top));
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        SurfacePoint near = new SurfacePoint();
        String where = shape + (instanced ? ", instance" : "") + (flipped ? ", flipped" : "");
        int checked = 0;
        for (int i = 0; i < 2000; i++) {
            Vector3d d = new Vector3d(random.nextDouble() - 0.5, random.nextDouble() - 0.5, -0.5 - random.nextDouble());
            d.normalize();
            double ox = 0.5 - 3 * d.x + random.nextDouble() - 0.5;
            double oy = -1 - 3 * d.y + random.nextDouble() - 0.5;
            double oz = 0.2 - 3 * d.z;
            if (!caster.trace(ox, oy, oz, d.x, d.y, d.z, RayKind.CAMERA, hit)
                    || Math.abs(hit.geometricCosine(d.x, d.y, d.z)) < 0.1) {
                continue;
            }
            assertEquals(1, hit.sx * hit.sx + hit.sy * hit.sy + hit.sz * hit.sz, 1e-12, where);
            assertEquals(0, hit.localZ(hit.sx, hit.sy, hit.sz), 1e-12, where);
            assertEquals(hit.ny * hit.sz - hit.nz * hit.sy, hit.tx, 1e-12, where);
            assertTrue(hit.uAlongS > 0, where);
            // Coordinates that change faster than by 10 per unit are near a pole, where differences are not
            // derivatives.
            double h = 1e-5;
            for (int axis = 0; axis < 2; axis++) {
                if (!caster.trace(
                                ox + (axis == 0 ? h : 0),
                                oy + (axis == 1 ? h : 0),
                                oz,
                                d.x,
                                d.y,
                                d.z,
                                RayKind.CAMERA,
                                near)
                        || near.primitive != hit.primitive
                        || Math.abs(near.u - hit.u) > 1e-4
                        || Math.abs(near.v - hit.v) > 1e-4) {
                    continue;
                }
                double dx = near.x - hit.x;
                double dy = near.y - hit.y;
                double dz = near.z - hit.z;
                double du = near.u - hit.u;
                double dv = near.v - hit.v;
                double s = hit.uAlongS * du + hit.vAlongS * dv;
                double t = hit.vAlongT * dv;
                // Second order, and the bending of the frame.
                assertEquals(hit.localX(dx, dy, dz), s, 2e-3 * h, where);
                assertEquals(hit.localY(dx, dy, dz), t, 2e-3 * h, where);
                checked++;
            }
        }
        assertTrue(checked > 60, where + ": " + checked);
    }

    /** A square whose second coordinates are turned by 90° against the first: ∂p/∂u is x there and y here. */
    private static TriangleMesh square() {
        return new TriangleMesh(
                        new float[] {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0},
                        new int[] {0, 1, 2, 2, 3, 0},
                        null,
                        new float[] {0, 0, 2, 0, 2, 2, 0, 2})
                .withAttributes(new float[] {0, 1, 0, 0, 1, 0, 1, 1}, null);
    }

    private static Bsdf mapped(boolean secondUvs) {
        TextureImage image = TextureImage.fromFloats(1, 1, 3, new float[] {0.6f, 0.5f, 0.9f});
        Texture map = new BitmapTexture(
                image,
                BitmapTexture.Filter.NEAREST,
                BitmapTexture.Wrap.REPEAT,
                BitmapTexture.Wrap.REPEAT,
                IDENTITY,
                secondUvs);
        return new NormalMap(map, new Diffuse(ConstantTexture.grey(0.5)), false);
    }

    /** Frames lie along the coordinates that the normal map is on; anisotropic materials below it take those as well. */
    @Test
    void framesFollowTheCoordinatesOfTheMap() {
        TriangleMesh mesh = square();
        for (boolean second : new boolean[] {false, true}) {
            for (Bsdf material : new Bsdf[] {mapped(second), new TwoSided(brushed(), mapped(second))}) {
                RayCaster caster = new RayCaster(scene(new ShapeNode(mesh, material)));
                assertTrue(caster.trace(0.3, -0.2, 1, 0, 0, -1, RayKind.CAMERA, hit));
                assertEquals(second ? 0 : 1, hit.sx, 1e-6);
                assertEquals(second ? 1 : 0, hit.sy, 1e-6);
                assertEquals(second ? 2 : 1, hit.uAlongS, 1e-6);
                assertEquals(second ? 4 : 1, hit.uvArea(), 1e-6);
            }
        }
        RayCaster caster =
                new RayCaster(scene(new ShapeNode(mesh.withAttributes(null, null), mapped(true)), farMeshWithSecond()));
        assertTrue(caster.trace(0.3, -0.2, 1, 0, 0, -1, RayKind.CAMERA, hit));
        assertEquals(1, hit.sx, 1e-6);
    }

    private static Node farMeshWithSecond() {
        ShapeNode far = new ShapeNode(square(), mapped(true));
        far.setTransform(Transform.translate(0, 0, -9).toMatrix4d());
        return far;
    }

    /** Tangents of vertices turn the frame, and the derivatives in it stay those of the texture coordinates. */
    @Test
    void framesFollowTheTangentsOfVertices() {
        float[] tangents = {1, 0, 0, 1, 1, 0, 0, 2, 5, 1, 0, 0};
        for (boolean instanced : new boolean[] {false, true}) {
            for (int mirror : new int[] {1, -1}) {
                SurfacePoint plain = new SurfacePoint();
                trace(new ShapeNode(square(), mapped(false)), instanced, mirror, plain);
                trace(new ShapeNode(square().withTangents(tangents), mapped(false)), instanced, mirror, hit);
                // At (0.5, 0): a quarter of vertex 0, a quarter of vertex 1 and half of vertex 2, all of unit length;
                // without
                // the part along z.
                double diagonal = 0.25 / Math.sqrt(2);
                Vector3d expected = new Vector3d(mirror * (0.25 + diagonal), diagonal + 1 / Math.sqrt(29), 0);
                expected.normalize();
                assertEquals(expected.x, hit.sx, 1e-6);
                assertEquals(expected.y, hit.sy, 1e-6);
                assertEquals(1, hit.localX(hit.sx, hit.sy, hit.sz), 1e-12);
                assertEquals(hit.ny * hit.sz - hit.nz * hit.sy, hit.tx, 1e-12);
                assertEquals(plain.uvArea(), hit.uvArea(), 1e-6);
                assertEquals(plain.uAlongS * plain.sx, hit.uAlongS * hit.sx + hit.uAlongT * hit.tx, 1e-6);
                assertEquals(plain.uAlongS * plain.sy, hit.uAlongS * hit.sy + hit.uAlongT * hit.ty, 1e-6);
                assertEquals(
                        plain.vAlongS * plain.sy + plain.vAlongT * plain.ty,
                        hit.vAlongS * hit.sy + hit.vAlongT * hit.ty,
                        1e-6);
            }
        }
    }

    private void trace(ShapeNode node, boolean instanced, int mirror, SurfacePoint into) {
        Node top = node;
        if (instanced) {
            Group group = new Group();
            group.add(node);
            top = new Instance(group);
        }
        top.setTransform(Transform.scale(mirror, 1, 1).toMatrix4d());
        // A second mesh without tangents shares the level.
        RayCaster caster = new RayCaster(scene(farMeshWithSecond(), top));
        assertTrue(caster.trace(0.5 * mirror, 0, 1, 0, 0, -1, RayKind.CAMERA, into));
    }

    @Test
    void withoutTextureCoordinatesDerivativesAreZero() {
        TriangleMesh mesh =
                new TriangleMesh(new float[] {-1, -1, 0, 1, -1, 0, 1, 1, 0}, new int[] {0, 1, 2}, null, null);
        RayCaster caster = new RayCaster(scene(new ShapeNode(mesh, brushed())));
        hit.uAlongS = 5;
        assertTrue(caster.trace(0.5, 0, 1, 0, 0, -1, RayKind.CAMERA, hit));
        assertEquals(0, hit.uAlongS);
        assertEquals(1, hit.sx * hit.sx + hit.sy * hit.sy + hit.sz * hit.sz, 1e-12);
    }

    @Test
    void colorsAndSecondCoordinatesAreInterpolated() {
        float[] corners = {-1, -1, 0, 1, -1, 0, 1, 1, 0};
        TriangleMesh plain = new TriangleMesh(corners, new int[] {0, 1, 2}, null, new float[] {0, 0, 1, 0, 1, 1});
        TriangleMesh colored =
                plain.withAttributes(new float[] {5, 0, 6, 0, 6, 2}, new float[] {1, 0, 0, 0, 1, 0, 0, 0, 1});
        Bsdf grey = new Diffuse(ConstantTexture.grey(0.5));
        Node below = new ShapeNode(plain, grey);
        Matrix4d down = Transform.translate(0, 0, -3).toMatrix4d();
        below.setTransform(down);
        RayCaster caster = new RayCaster(scene(below, new ShapeNode(colored, grey)));
        assertTrue(caster.trace(0.5, -0.5, 1, 0, 0, -1, RayKind.CAMERA, hit));
        assertEquals(0.25, hit.colorR, 1e-6);
        assertEquals(0.5, hit.colorG, 1e-6);
        assertEquals(0.25, hit.colorB, 1e-6);
        assertEquals(5.75, hit.u2, 1e-6);
        assertEquals(0.5, hit.v2, 1e-6);
        assertTrue(caster.trace(0.5, -0.5, -1, 0, 0, -1, RayKind.CAMERA, hit));
        assertEquals(1, hit.colorR);
        assertEquals(1, hit.colorB);
        assertEquals(hit.u, hit.u2);
        assertEquals(hit.v, hit.v2);
    }

    /** Of three sheets one behind the other, the holes of the first and a null surface are left behind by the same query. */
    @Test
    void raysGoOnThroughHoles() {
        Bsdf grey = new Diffuse(ConstantTexture.grey(0.5));
        Bsdf mask = new Mask(new CheckerboardTexture(ConstantTexture.grey(0), ConstantTexture.grey(1), IDENTITY), grey);
        ShapeNode holes = new ShapeNode(new Rectangle(), mask);
        ShapeNode nothing = new ShapeNode(new Rectangle(), new NullBsdf());
        nothing.setTransform(Transform.translate(0, 0, -1).toMatrix4d());
        ShapeNode wall = new ShapeNode(new Rectangle(), grey);
        wall.setTransform(Transform.translate(0, 0, -2).toMatrix4d());
        ShapeNode veil = new ShapeNode(new Rectangle(), new Mask(ConstantTexture.grey(0.5), grey));
        veil.setTransform(Transform.translate(0, 0, -3).toMatrix4d());
        RayCaster caster = new RayCaster(scene(holes, nothing, wall, veil));
        assertTrue(caster.trace(-0.5, -0.5, 1, 0, 0, -1, RayKind.CAMERA, hit));
        assertEquals(2, hit.shape);
        assertEquals(3, caster.count(RayKind.CAMERA));
        assertTrue(caster.trace(0.5, -0.5, 1, 0, 0, -1, RayKind.CAMERA, hit));
        assertEquals(0, hit.shape);
        assertTrue(caster.trace(hit, 0, 0, -1, RayKind.SCATTERED, hit));
        assertEquals(2, hit.shape);
        // What lets only part of the light through is for its material to decide.
        assertTrue(caster.trace(hit, 0, 0, -1, RayKind.SCATTERED, hit));
        assertEquals(3, hit.shape);
        assertFalse(caster.trace(hit, 0, 0, -1, RayKind.SCATTERED, hit));
    }

    @Test
    void lightsAreMetEvenWhereTheirMaterialIsNothing() {
        ShapeNode light = new ShapeNode(new Rectangle(), new NullBsdf());
        light.setRadiance(ConstantTexture.grey(1));
        RayCaster caster = new RayCaster(scene(light));
        assertTrue(caster.trace(0, 0, 1, 0, 0, -1, RayKind.CAMERA, hit));
        assertEquals(1, caster.count(RayKind.CAMERA));
    }
}
