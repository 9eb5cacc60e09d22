package org.daybreak.benchmarks.forest;

import java.util.SplittableRandom;
import javax.vecmath.Color3f;
import javax.vecmath.Point3d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Cone;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.TwoSided;
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
 * A forest of one plant: what it takes to describe and compile. The plant is a stem with instances of one leaf, the forest
 * instances of the plant.
 *
 * <pre>{@code
 * java -Xmx1g -cp benchmarks/target/benchmarks.jar org.daybreak.benchmarks.forest.ForestMemory 200 50 1000
 * java -Xmx4g -cp benchmarks/target/benchmarks.jar org.daybreak.benchmarks.forest.ForestMemory 200 50 100000
 * }</pre>
 */
public final class ForestMemory {
    private ForestMemory() {}

    /** Arguments: leaves of a plant, triangles of a leaf, plants. Prints one line. */
    public static void main(String[] args) {
        int leaves = Integer.parseInt(args[0]);
        int triangles = Integer.parseInt(args[1]);
        int plants = Integer.parseInt(args[2]);
        long start = System.nanoTime();
        SceneGraph graph = forest(leaves, triangles, plants);
        long described = System.nanoTime();
        long graphBytes = heap();
        long before = System.nanoTime();
        Scene scene = SceneCompiler.compile(graph);
        long compiled = System.nanoTime();
        System.out.printf(
                "%.3g triangles visible in %d plants; graph %.1f MB in %.2f s; with the scene %.1f MB, compiled in"
                        + " %.2f s; most heap %.0f MB; %s%n",
                (double) leaves * triangles * plants,
                plants,
                graphBytes * 1e-6,
                (described - start) * 1e-9,
                heap() * 1e-6,
                (compiled - before) * 1e-9,
                Runtime.getRuntime().maxMemory() * 1e-6,
                scene.intersector().describe());
    }

    private static long heap() {
        System.gc();
        return Runtime.getRuntime().totalMemory() - Runtime.getRuntime().freeMemory();
    }

    private static SceneGraph forest(int leaves, int triangles, int plants) {
        SplittableRandom random = new SplittableRandom(1);
        Group leaf = new Group();
        Diffuse green = new Diffuse(new ConstantTexture(0.2, 0.5, 0.1));
        leaf.add(new ShapeNode(blade(triangles), new TwoSided(green, green)));
        Group plant = new Group();
        plant.add(new ShapeNode(
                new Cone(new Point3d(), new Point3d(0, 5, 0), 0.15, 0.02), new Diffuse(ConstantTexture.grey(0.3))));
        for (int i = 0; i < leaves; i++) {
            plant.add(new Instance(leaf))
                    .setTransform(Transform.translate(0, 0.5 + 4.5 * i / leaves, 0)
                            .multiply(Transform.rotate(0, 1, 0, 137.5 * i))
                            .multiply(Transform.rotate(0, 0, 1, 20 + 20 * random.nextDouble()))
                            .toMatrix4d());
        }
        SceneGraph graph = new SceneGraph();
        double side = 3 * Math.sqrt(plants);
        for (int i = 0; i < plants; i++) {
            graph.root()
                    .add(new Instance(plant))
                    .setTransform(Transform.translate(side * random.nextDouble(), 0, side * random.nextDouble())
                            .multiply(Transform.rotate(0, 1, 0, 360 * random.nextDouble()))
                            .toMatrix4d());
        }
        graph.root().add(new LightNode(new LightSource.ConstantEnvironment(new Color3f(1, 1, 1))));
        graph.setCamera(new CameraSettings(
                Transform.lookAt(-10, 12, -10, side / 4, 0, side / 4, 0, 1, 0).toMatrix4d(), 40));
        graph.setFilm(new FilmSettings(64, 48, ReconstructionFilter.BOX));
        return graph;
    }

    /** A bent strip of triangles, pointed at both ends. */
    private static TriangleMesh blade(int triangles) {
        float[] positions = new float[3 * (triangles + 2)];
        int[] corners = new int[3 * triangles];
        for (int i = 0; i < triangles + 2; i++) {
            int pair = i / 2;
            double along = pair / (0.5 * triangles + 1);
            double width = 0.2 * Math.sin(Math.PI * (0.02 + 0.96 * along));
            positions[3 * i] = (float) along;
            positions[3 * i + 1] = (float) (i % 2 == 0 ? width : -width);
            positions[3 * i + 2] = (float) (0.2 * along * along);
        }
        for (int i = 0; i < corners.length; i++) {
            corners[i] = i / 3 + i % 3;
        }
        return new TriangleMesh(positions, corners, null, null);
    }
}
