package org.daybreak.core.scene;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import org.daybreak.core.accel.HitRefinement;
import org.daybreak.core.accel.Ray;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Cone;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.math.Transform;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Instances of groups of instances show what copies of their content show, however they are unrolled. */
class NestedInstancesTest {
    private static final Diffuse GREY = new Diffuse(ConstantTexture.grey(0.5));

    private static Matrix4d placement(SplittableRandom random, double spread) {
        return Transform.translate(
                        spread * random.nextDouble(-1, 1),
                        spread * random.nextDouble(-1, 1),
                        spread * random.nextDouble(-1, 1))
                .multiply(Transform.rotate(1, random.nextDouble(), random.nextDouble(), 360 * random.nextDouble()))
                .multiply(Transform.scale(0.5 + random.nextDouble(), 1, random.nextBoolean() ? -1 : 1))
                .toMatrix4d();
    }

    private static Group leaf(int triangles) {
        float[] positions = new float[9 * triangles];
        int[] corners = new int[3 * triangles];
        SplittableRandom random = new SplittableRandom(5);
        for (int i = 0; i < positions.length; i++) {
            positions[i] = (float) random.nextDouble(-0.3, 0.3);
        }
        for (int i = 0; i < corners.length; i++) {
            corners[i] = i;
        }
        Group leaf = new Group();
        leaf.add(new ShapeNode(new TriangleMesh(positions, corners, null, null), GREY));
        leaf.add(new ShapeNode(new Cone(new Point3d(0, 0, 0), new Point3d(0, 0.4, 0), 0.1, 0.05), GREY));
        return leaf;
    }

    /** A scene of plants of leaves; with {@code copies} every leaf is a group of its own. */
    private static Scene scene(int triangles, int leaves, int plants, boolean copies, boolean lamps) {
        SplittableRandom random = new SplittableRandom(7);
        Matrix4d[] leafPlaces = new Matrix4d[leaves];
        for (int i = 0; i < leaves; i++) {
            leafPlaces[i] = placement(random, 1);
        }
        SceneGraph graph = new SceneGraph();
        Group shared = null;
        Group sharedLeaf = leaf(triangles);
        for (int p = 0; p < plants; p++) {
            Group plant = shared;
            if (plant == null || copies) {
                plant = new Group();
                for (Matrix4d place : leafPlaces) {
                    if (copies) {
                        plant.add(leaf(triangles)).setTransform(place);
                    } else {
                        plant.add(new Instance(sharedLeaf)).setTransform(place);
                    }
                }
                if (lamps) {
                    plant.add(new ShapeNode(new Sphere(new Point3d(0, 0.5, 0), 0.1), GREY))
                            .setRadiance(ConstantTexture.grey(1));
                }
                shared = plant;
            }
            Matrix4d place = placement(random, 3);
            if (copies) {
                graph.root().add(plant).setTransform(place);
            } else {
                graph.root().add(new Instance(plant)).setTransform(place);
            }
        }
        graph.setCamera(new CameraSettings(Transform.identity().toMatrix4d(), 40));
        graph.setFilm(new FilmSettings(4, 4, ReconstructionFilter.BOX));
        return SceneCompiler.compile(graph, new SceneCompiler.Options(1, "scalar"));
    }

    /** Few triangles are copied into the plant; many in few plants stay instances. */
    @ParameterizedTest
    @ValueSource(ints = {2, 400})
    void showTheSameAsCopies(int triangles) {
        Scene instanced = scene(triangles, 6, 8, false, true);
        Scene copied = scene(triangles, 6, 8, true, true);
        assertEquals(8, instanced.lightCount());
        assertEquals(8, copied.lightCount());
        SplittableRandom random = new SplittableRandom(3);
        HitRefinement refinement = new HitRefinement();
        SurfacePoint a = new SurfacePoint();
        SurfacePoint b = new SurfacePoint();
        Ray first = new Ray();
        Ray second = new Ray();
        int hits = 0;
        int differences = 0;
        for (int i = 0; i < 20_000; i++) {
            double ox = 8 * random.nextDouble(-1, 1);
            double oy = 8 * random.nextDouble(-1, 1);
            double oz = 8 * random.nextDouble(-1, 1);
            double dx = 3 * random.nextDouble(-1, 1) - ox;
            double dy = 3 * random.nextDouble(-1, 1) - oy;
            double dz = 3 * random.nextDouble(-1, 1) - oz;
            first.set(ox, oy, oz, dx, dy, dz, Double.POSITIVE_INFINITY);
            second.set(ox, oy, oz, dx, dy, dz, Double.POSITIVE_INFINITY);
            boolean hit = instanced.intersector().intersect(first);
            if (hit != copied.intersector().intersect(second)) {
                differences++;
            } else if (hit) {
                hits++;
                instanced.resolve(first, refinement, a);
                copied.resolve(second, refinement, b);
                boolean same = Math.abs(a.x - b.x) + Math.abs(a.y - b.y) + Math.abs(a.z - b.z) < 1e-4
                        && a.gx * b.gx + a.gy * b.gy + a.gz * b.gz > 1 - 1e-4
                        && (instanced.lightOf(a.shape) >= 0) == (copied.lightOf(b.shape) >= 0);
                differences += same ? 0 : 1;
            }
        }
        assertTrue(hits > 3000, hits + " hits");
        // Single precision in other coordinates may decide otherwise at the edges of triangles.
        assertTrue(differences < hits / 1000 + 3, differences + " of " + hits + " differ");
    }

    /** The plant becomes one level in a large forest, so that there are as many instances as plants. */
    @Test
    void aForestOfOnePlantHasOneInstanceForEachPlant() {
        Scene forest = scene(10, 50, 2000, false, false);
        assertTrue(
                forest.intersector().memoryBytes() < 2000 * 200,
                forest.intersector().memoryBytes() + " bytes for 2000 plants");
    }
}
