package org.daybreak.benchmarks.intersection;

import java.util.Objects;
import java.util.SplittableRandom;
import java.util.concurrent.TimeUnit;
import javax.vecmath.Point3d;
import org.daybreak.core.accel.HitRefinement;
import org.daybreak.core.accel.PrimitiveSet;
import org.daybreak.core.accel.Ray;
import org.daybreak.core.accel.SelfCheck;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Cylinder;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.math.Transform;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.Group;
import org.daybreak.core.scene.Instance;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.scene.ShapeNode;
import org.jspecify.annotations.Nullable;
import org.openjdk.jmh.annotations.Benchmark;
import org.openjdk.jmh.annotations.BenchmarkMode;
import org.openjdk.jmh.annotations.Fork;
import org.openjdk.jmh.annotations.Measurement;
import org.openjdk.jmh.annotations.Mode;
import org.openjdk.jmh.annotations.OperationsPerInvocation;
import org.openjdk.jmh.annotations.OutputTimeUnit;
import org.openjdk.jmh.annotations.Param;
import org.openjdk.jmh.annotations.Scope;
import org.openjdk.jmh.annotations.Setup;
import org.openjdk.jmh.annotations.State;
import org.openjdk.jmh.annotations.Warmup;

/** Time to turn the answer of an intersector into a surface point, without the traversal; for rays in all directions. */
@State(Scope.Thread)
@BenchmarkMode(Mode.AverageTime)
@OutputTimeUnit(TimeUnit.NANOSECONDS)
@Warmup(iterations = 3, time = 500, timeUnit = TimeUnit.MILLISECONDS)
@Measurement(iterations = 5, time = 500, timeUnit = TimeUnit.MILLISECONDS)
@Fork(1)
public class ResolveBenchmark {
    private static final int HITS = 4096;

    /** What is hit; {@code instances} are of a mesh with vertex normals. */
    @Param({"rectangles", "smoothMesh", "spheres", "disks", "cylinders", "instances"})
    public String shapes = "";

    private final Ray[] hits = new Ray[HITS];
    private final HitRefinement refinement = new HitRefinement();
    private final SurfacePoint point = new SurfacePoint();
    private @Nullable Scene scene;

    /** Finds the hits. */
    @Setup
    public void trace() {
        Scene compiled = SceneCompiler.compile(graph(shapes));
        scene = compiled;
        SplittableRandom random = new SplittableRandom(11);
        for (int i = 0; i < HITS; i++) {
            Ray ray = new Ray();
            do {
                SelfCheck.aim(ray, random, Double.POSITIVE_INFINITY);
            } while (!compiled.intersector().intersect(ray));
            hits[i] = ray;
        }
    }

    /** Resolves all hits one after the other. */
    @Benchmark
    @OperationsPerInvocation(HITS)
    public double resolve() {
        Scene compiled = Objects.requireNonNull(scene);
        double sum = 0;
        for (Ray ray : hits) {
            compiled.resolve(ray, refinement, point);
            sum += point.x + point.nx + point.sx;
        }
        return sum;
    }

    private static SceneGraph graph(String shapes) {
        SplittableRandom random = new SplittableRandom(12);
        SceneGraph graph = new SceneGraph();
        graph.setCamera(
                new CameraSettings(Transform.lookAt(0, 0, 4, 0, 0, 0, 0, 1, 0).toMatrix4d(), 40));
        graph.setFilm(new FilmSettings(16, 16, ReconstructionFilter.BOX));
        Group mesh = new Group();
        mesh.add(node(smoothMesh()));
        for (int i = 0; i < 12; i++) {
            Transform place = Transform.translate(
                            random.nextDouble(-0.7, 0.7), random.nextDouble(-0.7, 0.7), random.nextDouble(-0.7, 0.7))
                    .multiply(Transform.rotate(1, 2, 3, random.nextDouble(360)))
                    .multiply(Transform.scale(0.3, 0.2, 0.4));
            switch (shapes) {
                case "instances" -> graph.root().add(new Instance(mesh)).setTransform(place.toMatrix4d());
                case "smoothMesh" -> graph.root().add(node(smoothMesh())).setTransform(place.toMatrix4d());
                case "rectangles" -> graph.root().add(node(new Rectangle())).setTransform(place.toMatrix4d());
                case "spheres" ->
                    graph.root().add(node(new Sphere(new Point3d(), 1))).setTransform(place.toMatrix4d());
                case "disks" -> graph.root().add(node(new Disk())).setTransform(place.toMatrix4d());
                case "cylinders" ->
                    graph.root()
                            .add(node(new Cylinder(new Point3d(0, 0, -1), new Point3d(0, 0, 1), 1)))
                            .setTransform(place.toMatrix4d());
                default -> throw new IllegalArgumentException("unknown shapes: " + shapes);
            }
        }
        return graph;
    }

    private static ShapeNode node(Shape shape) {
        return new ShapeNode(shape, new Diffuse(ConstantTexture.grey(0.5)));
    }

    /** Random triangles with a normal at each vertex. */
    private static TriangleMesh smoothMesh() {
        PrimitiveSet set = SelfCheck.scene(200);
        return new TriangleMesh(set.positions(), set.triangles(), set.positions(), null);
    }
}
