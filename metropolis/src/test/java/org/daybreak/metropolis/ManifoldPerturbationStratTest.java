package org.daybreak.metropolis;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import javax.vecmath.Color3f;
import javax.vecmath.Point3d;
import org.daybreak.bidirectional.BidirectionalSettings;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.geometry.Cylinder;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.Conductor;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.Node;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.daybreak.metropolis.chains.ChainStatistics;
import org.daybreak.metropolis.chains.PatternSet;
import org.daybreak.metropolis.strategy.LightPath;
import org.daybreak.metropolis.strategy.ManifoldPerturbationStrat;
import org.daybreak.metropolis.strategy.MutationStrategy;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.Arguments;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * The manifold perturbation leaves the density of paths f*\/b as it is: of paths drawn from it, by bidirectional path tracing and
 * resampling, any function has the same mean before and after some steps. That needs no other strategy to make chains
 * ergodic, and no other estimate of the image. Paths that the strategy does not apply to are left out: it never leads to one.
 */
class ManifoldPerturbationStratTest {
    private static final ConstantTexture WHITE = ConstantTexture.grey(1);
    private static final Bsdf GLASS = new Dielectric(1.5, 1, WHITE, WHITE);
    private static final Bsdf MIRROR = Conductor.mirror(ConstantTexture.grey(0.9));
    private static final Bsdf GREY = new Diffuse(ConstantTexture.grey(0.6));

    private static ShapeNode shape(Shape shape, Bsdf material, Transform transform) {
        ShapeNode node = new ShapeNode(shape, material);
        node.setTransform(transform.toMatrix4d());
        return node;
    }

    /** A grey floor, the grey back and the side of a room; with a mirror on the other side if asked for. */
    private static List<Node> room(boolean mirror) {
        List<Node> nodes = new ArrayList<>();
        nodes.add(shape(new Rectangle(), GREY, Transform.scale(4, 4, 1)));
        nodes.add(shape(
                new Rectangle(),
                GREY,
                Transform.translate(0, 4, 2)
                        .multiply(Transform.rotate(1, 0, 0, 90))
                        .multiply(Transform.scale(4, 2, 1))));
        if (mirror) {
            nodes.add(shape(
                    new Rectangle(),
                    MIRROR,
                    Transform.translate(-3, 0, 2)
                            .multiply(Transform.rotate(0, 1, 0, 90))
                            .multiply(Transform.scale(2, 3, 1))));
        }
        return nodes;
    }

    private static Node ball() {
        return new ShapeNode(new Sphere(new Point3d(0, 0, 1), 0.8), GLASS);
    }

    private static Node lamp() {
        ShapeNode lamp = new ShapeNode(new Sphere(new Point3d(1, 0.5, 3.6), 0.3), GREY);
        lamp.setRadiance(ConstantTexture.grey(20));
        return lamp;
    }

    private static Scene scene(CameraSettings camera, List<Node> nodes) {
        SceneGraph graph = new SceneGraph();
        graph.setCamera(camera);
        graph.setFilm(new FilmSettings(16, 12, ReconstructionFilter.BOX));
        nodes.forEach(graph.root()::add);
        return SceneCompiler.compile(graph);
    }

    private static CameraSettings perspective() {
        return new CameraSettings(
                Transform.lookAt(1.5, -7, 3, 0, 0, 0.8, 0, 0, 1).toMatrix4d(), 45);
    }

    private static Scene scene(List<Node> room, Node... more) {
        List<Node> nodes = new ArrayList<>(room);
        nodes.addAll(Arrays.asList(more));
        return scene(perspective(), nodes);
    }

    /** The ball of glass as triangles with smooth normals. */
    private static Node smoothBall() {
        int rows = 16;
        int columns = 32;
        float[] positions = new float[3 * (rows + 1) * (columns + 1)];
        int[] triangles = new int[6 * rows * columns];
        int corner = 0;
        for (int i = 0; i <= rows; i++) {
            for (int j = 0; j <= columns; j++) {
                double theta = Math.PI * i / rows;
                double phi = 2 * Math.PI * j / columns;
                int vertex = i * (columns + 1) + j;
                positions[3 * vertex] = (float) (Math.sin(theta) * Math.cos(phi));
                positions[3 * vertex + 1] = (float) (Math.sin(theta) * Math.sin(phi));
                positions[3 * vertex + 2] = (float) Math.cos(theta);
                if (i < rows && j < columns) {
                    int below = vertex + columns + 1;
                    int[] quad = {vertex, below, below + 1, vertex, below + 1, vertex + 1};
                    System.arraycopy(quad, 0, triangles, corner, 6);
                    corner += 6;
                }
            }
        }
        TriangleMesh mesh = new TriangleMesh(positions, triangles, positions.clone(), null);
        return shape(mesh, GLASS, Transform.translate(0, 0, 1).multiply(Transform.scale(0.8, 0.8, 0.8)));
    }

    private static void check(String name, Scene scene, int count) {
        MutationStrategy strategy = new ManifoldPerturbationStrat(1, 0.1, 4, 0.1, 4);
        BidirectionalSettings settings = new BidirectionalSettings(
                        -1, -1, 7, 1, BidirectionalSettings.Roulette.NONE, 3, 1, false, true)
                .withMinDepth(2);
        MetropolisProcessor worker = new MetropolisProcessor(
                scene, scene.camera(), 1, settings, List.of(strategy), PatternSet.NONE, true, count);
        RandomStream random = new RandomStream(7, StreamDomain.SELF_CHECK, 0, 0);
        SplatBuffer splats = new SplatBuffer();
        ChainStatistics statistics = new ChainStatistics(1);
        List<double[]> starts = new ArrayList<>();
        Moments[] changes = new Moments[BINS];
        Arrays.setAll(changes, i -> new Moments());
        double[] before = new double[BINS];
        double[] after = new double[BINS];
        int applied = 0;
        for (int i = 0; i < count; i++) {
            starts.clear();
            worker.candidate(i, (number, x, y, weight) -> starts.add(new double[] {number, weight}));
            double sum = 0;
            for (double[] start : starts) {
                sum += start[1];
            }
            double left = random.nextDouble() * sum;
            Arrays.fill(before, 0);
            Arrays.fill(after, 0);
            for (double[] start : starts) {
                left -= start[1];
                if (left < 0) {
                    PathChain chain = (PathChain) worker.newChain(i);
                    worker.start(chain, i, (int) start[0]);
                    if (strategy.weight(chain.current) > 0) {
                        applied++;
                        features(chain.current, sum, before);
                        splats.clear();
                        worker.advance(chain, 12, splats, statistics);
                        features(chain.current, sum, after);
                    }
                    break;
                }
            }
            for (int k = 0; k < BINS; k++) {
                changes[k].add(after[k] - before[k]);
            }
        }
        double[] pValues = Arrays.stream(changes)
                .filter(m -> m.variance() > 0)
                .mapToDouble(m -> ZTest.oneSample(m, 0))
                .toArray();
        // False-alarm rate 1e-4 for each scene.
        ZTest.assertNoneRejected(name, pValues, 1e-4);
        String text = name + ": " + applied + " chains, accepted " + statistics.accepted(0);
        assertTrue(applied > 0.04 * count, text);
        // Of twelve steps of each chain.
        assertTrue(statistics.accepted(0) > 3L * applied, text);
        assertEquals(0, statistics.nonFinite, text);
    }

    /** Cells of the film, and ranges of coordinates of the first vertices from both ends. */
    private static final int BINS = 12 + 4 * 12;

    private static void features(LightPath path, double weight, double[] into) {
        int x = Math.min(3, Math.max(0, (int) (path.filmX() / 4)));
        int y = Math.min(2, Math.max(0, (int) (path.filmY() / 4)));
        into[4 * y + x] += weight;
        int k = path.edges();
        for (int i = 0; i < 4; i++) {
            int vertex = i < 2 ? i + 1 : k - i + 1;
            if (vertex > 0 && vertex < k) {
                SurfacePoint p = path.point(vertex);
                int at = 12 + 12 * i;
                into[at + bin(p.x, -1, 1)] += weight;
                into[at + 4 + bin(p.y, -1, 1)] += weight;
                into[at + 8 + bin(p.z, 0.3, 1.7)] += weight;
            }
        }
    }

    private static int bin(double value, double low, double high) {
        double middle = 0.5 * (low + high);
        return value < low ? 0 : value < middle ? 1 : value < high ? 2 : 3;
    }

    private static ShapeNode facing(Bsdf material, double y, double degrees) {
        return shape(
                new Rectangle(),
                material,
                Transform.translate(0, y, 2)
                        .multiply(Transform.rotate(1, 0, 0, degrees))
                        .multiply(Transform.scale(4, 4, 1)));
    }

    /** Scenes with light that glass or mirrors throw, by name. */
    private static Stream<Arguments> scenes() {
        LightNode point = new LightNode(new LightSource.Point(new Color3f(20, 20, 20)));
        point.setTransform(Transform.translate(1, 0.5, 3.6).toMatrix4d());
        LightNode sky = new LightNode(new LightSource.ConstantEnvironment(new Color3f(1, 1, 1)));
        LightNode sun = new LightNode(new LightSource.Directional(new Color3f(3, 3, 3)));
        sun.setTransform(Transform.lookAt(1, -1, 5, 0, 0, 0, 0, 1, 0).toMatrix4d());
        ShapeNode ring = new ShapeNode(new Cylinder(new Point3d(0, 0, 0.1), new Point3d(0, 0, 0.8), 1.2), MIRROR);
        ring.setFlipNormals(true);
        List<Node> parallel = new ArrayList<>(room(true));
        parallel.add(ball());
        parallel.add(lamp());
        CameraSettings orthographic = CameraSettings.orthographic(Transform.lookAt(1.5, -7, 3, 0, 0, 0.8, 0, 0, 1)
                .multiply(Transform.scale(3, 3, 1))
                .toMatrix4d());
        return Stream.of(
                Arguments.of("a lamp, a ball of glass and a mirror", scene(room(true), ball(), lamp())),
                Arguments.of("a ball of triangles with smooth normals", scene(room(true), smoothBall(), lamp())),
                Arguments.of("a point light", scene(room(true), ball(), point)),
                Arguments.of("a sky", scene(room(true), ball(), sky)),
                Arguments.of("parallel light", scene(room(true), ball(), sun)),
                Arguments.of("a ring of mirror", scene(room(false), ring, lamp())),
                Arguments.of(
                        "a pane before the camera",
                        scene(room(false), facing(GLASS, -4.2, 90), facing(GLASS, -4, -90), ball(), lamp())),
                Arguments.of("parallel rays to the camera", scene(orthographic, parallel)));
    }

    @ParameterizedTest
    @MethodSource("scenes")
    void densityStays(String name, Scene scene) {
        check(name, scene, 10_000);
    }

    @ParameterizedTest
    @MethodSource("scenes")
    @Tag("reference")
    void densityStaysInLongRuns(String name, Scene scene) {
        check(name, scene, 200_000);
    }
}
