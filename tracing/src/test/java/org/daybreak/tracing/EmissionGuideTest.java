package org.daybreak.tracing;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import javax.vecmath.Color3f;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.EmissionDensity;
import org.daybreak.core.light.EmissionSample;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/**
 * Samples of a guide against those of the lights themselves: what both carry into each part of the space of rays must agree. False
 * alarm 1e-4 per light.
 */
class EmissionGuideTest {
    private static final double SIGNIFICANCE = 1e-4;
    private static final int RAYS = 600_000;
    private static final int PARTS = 4;
    private static final Bsdf FLOOR = new Diffuse(ConstantTexture.grey(0.5));
    private static final Bsdf GLASS = new Dielectric(1.5, 1, ConstantTexture.grey(1), ConstantTexture.grey(1));

    /** A light with its name. */
    record Case(String name, SceneGraph graph) {
        @Override
        public String toString() {
            return name;
        }
    }

    static Stream<Case> lights() {
        List<Case> cases = new ArrayList<>();
        cases.add(new Case("sphere", emitter(new Sphere(new Point3d(0, 4, 0), 0.3), at(0, 0, 0))));
        Matrix4d down = new Matrix4d(0.5, 0, 0, 0, 0, 0, 1, 4, 0, -0.5, 0, 0, 0, 0, 0, 1);
        down.setElement(1, 2, -1);
        cases.add(new Case("rectangle", emitter(new Rectangle(), down)));
        cases.add(new Case("point", light(new LightSource.Point(new Color3f(3, 2, 1)), at(0.5, 4, 0.2))));
        Matrix4d spot = new Matrix4d(1, 0, 0, 0, 0, 0, -1, 4, 0, 1, 0, 0, 0, 0, 0, 1);
        cases.add(new Case("spot", light(new LightSource.Spot(new Color3f(9, 9, 9), 70, 60), spot)));
        cases.add(new Case("directional", light(new LightSource.Directional(new Color3f(1, 1, 1)), spot)));
        cases.add(
                new Case("environment", light(new LightSource.ConstantEnvironment(new Color3f(1, 2, 3)), at(0, 0, 0))));
        return cases.stream();
    }

    @ParameterizedTest
    @MethodSource("lights")
    void carriesWhatTheLightEmits(Case light) {
        Scene scene = compile(light.graph);
        EmissionGuide guide = new EmissionGuide(scene);
        RandomStream random = new RandomStream(7, StreamDomain.LIGHT_PATH, 0, 0);
        EmissionSample sample = new EmissionSample();
        Moments[] own = moments();
        Moments[] guided = moments();
        for (int i = 0; i < RAYS; i++) {
            add(own, scene.light(0).sampleEmission(u(random), u(random), u(random), u(random), sample), sample);
            add(guided, guide.sample(0, u(random), u(random), u(random), u(random), sample), sample);
        }
        double[] p = new double[own.length];
        for (int i = 0; i < p.length; i++) {
            boolean none = own[i].mean() == 0 && guided[i].mean() == 0;
            p[i] = none ? 1 : ZTest.twoSample(own[i], guided[i]);
        }
        ZTest.assertNoneRejected(light.name, p, SIGNIFICANCE);
    }

    @ParameterizedTest
    @MethodSource("lights")
    void knowsItsDensities(Case light) {
        Scene scene = compile(light.graph);
        EmissionGuide guide = new EmissionGuide(scene);
        RandomStream random = new RandomStream(8, StreamDomain.LIGHT_PATH, 0, 0);
        EmissionSample sample = new EmissionSample();
        EmissionDensity density = new EmissionDensity();
        SurfacePoint onRay = new SurfacePoint();
        for (int i = 0; i < 10_000; i++) {
            if (guide.sample(0, u(random), u(random), u(random), u(random), sample)) {
                onRay.x = sample.point.x + 3 * sample.dx;
                onRay.y = sample.point.y + 3 * sample.dy;
                onRay.z = sample.point.z + 3 * sample.dz;
                guide.density(0, sample.point, onRay, sample.dx, sample.dy, sample.dz, density);
                assertEquals(sample.densityPosition, density.position, 1e-9 * density.position);
                assertEquals(sample.densityDirection, density.direction, 1e-9 * density.direction);
            }
        }
    }

    @ParameterizedTest
    @MethodSource("lights")
    void meetsGlassMoreOften(Case light) {
        assertTrue(hits(compile(light.graph)) > 0.2, light.name);
    }

    @Test
    void leavesGlassAloneThatNothingReaches() {
        SceneGraph graph = light(new LightSource.Point(new Color3f(1, 1, 1)), at(0.5, 4, 0.2));
        Matrix4d cover = new Matrix4d(6, 0, 0, 0, 0, 0, 1, 2, 0, -6, 0, 0, 0, 0, 0, 1);
        graph.root().add(new ShapeNode(new Rectangle(), FLOOR)).setTransform(cover);
        Scene scene = compile(graph);
        EmissionGuide guide = new EmissionGuide(scene);
        RandomStream random = new RandomStream(9, StreamDomain.LIGHT_PATH, 0, 0);
        EmissionSample ordinary = new EmissionSample();
        EmissionSample guided = new EmissionSample();
        for (int i = 0; i < 1000; i++) {
            double u = u(random);
            double v = u(random);
            double s = u(random);
            double t = u(random);
            assertEquals(scene.light(0).sampleEmission(u, v, s, t, ordinary), guide.sample(0, u, v, s, t, guided));
            assertEquals(ordinary.dx, guided.dx);
            assertEquals(ordinary.dy, guided.dy);
        }
    }

    private static double hits(Scene scene) {
        EmissionGuide guide = new EmissionGuide(scene);
        RayCaster caster = new RayCaster(scene);
        RandomStream random = new RandomStream(10, StreamDomain.LIGHT_PATH, 0, 0);
        EmissionSample sample = new EmissionSample();
        SurfacePoint hit = new SurfacePoint();
        int hits = 0;
        for (int i = 0; i < 2000; i++) {
            if (guide.sample(0, u(random), u(random), u(random), u(random), sample)
                    && caster.trace(sample.point, sample.dx, sample.dy, sample.dz, RayKind.LIGHT, hit)
                    && !scene.bsdf(hit.shape).connectable()) {
                hits++;
            }
        }
        return hits / 2000.0;
    }

    /** Adds a ray to the part of ray space that it lies in: direction by octant, line by its passing near the glass. */
    private static void add(Moments[] parts, boolean sampled, EmissionSample s) {
        int part = -1;
        if (sampled) {
            int octant = (s.dx > 0 ? 1 : 0) + (s.dy > -0.7 ? 2 : 0) + (s.dz > 0 ? 4 : 0);
            double x = 1.5 - s.point.x;
            double y = 0.3 - s.point.y;
            double z = 0.4 - s.point.z;
            double along = x * s.dx + y * s.dy + z * s.dz;
            double squared = x * x + y * y + z * z - along * along;
            part = PARTS * octant + (squared < 0.12 ? 0 : squared < 0.5 ? 1 : squared < 4 ? 2 : 3);
        }
        for (int i = 0; i < parts.length; i++) {
            parts[i].add(i == part ? s.weight.luminance() : 0);
        }
    }

    private static Moments[] moments() {
        return Stream.generate(Moments::new).limit(8 * PARTS).toArray(Moments[]::new);
    }

    private static double u(RandomStream random) {
        return random.nextDouble();
    }

    private static SceneGraph emitter(Shape shape, Matrix4d transform) {
        SceneGraph graph = withGlass();
        ShapeNode node = new ShapeNode(shape, FLOOR).setRadiance(new ConstantTexture(5, 4, 3));
        node.setTransform(transform);
        graph.root().add(node);
        return graph;
    }

    private static SceneGraph light(LightSource source, Matrix4d transform) {
        SceneGraph graph = withGlass();
        LightNode node = new LightNode(source);
        node.setTransform(transform);
        graph.root().add(node);
        return graph;
    }

    /** A floor with two small glass spheres on it. */
    private static SceneGraph withGlass() {
        SceneGraph graph = new SceneGraph();
        Matrix4d floor = new Matrix4d(8, 0, 0, 0, 0, 0, 1, 0, 0, -8, 0, 0, 0, 0, 0, 1);
        graph.root().add(new ShapeNode(new Rectangle(), FLOOR)).setTransform(floor);
        graph.root().add(new ShapeNode(new Sphere(new Point3d(1.5, 0.3, 0.4), 0.3), GLASS));
        graph.root().add(new ShapeNode(new Sphere(new Point3d(-1, 0.2, 0.7), 0.2), GLASS));
        graph.setCamera(
                new CameraSettings(Transform.lookAt(0, 5, 5, 0, 0, 0, 0, 1, 0).toMatrix4d(), 45));
        graph.setFilm(new FilmSettings(16, 16, ReconstructionFilter.BOX));
        return graph;
    }

    private static Matrix4d at(double x, double y, double z) {
        Matrix4d matrix = new Matrix4d();
        matrix.setIdentity();
        matrix.setTranslation(new Vector3d(x, y, z));
        return matrix;
    }

    private static Scene compile(SceneGraph graph) {
        return SceneCompiler.compile(graph, new SceneCompiler.Options(1, null));
    }
}
