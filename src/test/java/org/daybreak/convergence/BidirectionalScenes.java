package org.daybreak.convergence;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import javax.vecmath.Color3f;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Cube;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.light.RadianceMap;
import org.daybreak.core.light.SkySettings;
import org.daybreak.core.material.Blend;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.CheckerboardTexture;
import org.daybreak.core.material.Conductor;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.GroimpPhong;
import org.daybreak.core.material.Leaf;
import org.daybreak.core.material.Mask;
import org.daybreak.core.material.Microfacet;
import org.daybreak.core.material.NormalMap;
import org.daybreak.core.material.NullBsdf;
import org.daybreak.core.material.Plastic;
import org.daybreak.core.material.Principled;
import org.daybreak.core.material.PrincipledThin;
import org.daybreak.core.material.RoughConductor;
import org.daybreak.core.material.RoughDielectric;
import org.daybreak.core.material.RoughPlastic;
import org.daybreak.core.material.Roughness;
import org.daybreak.core.material.Texture;
import org.daybreak.core.material.ThinDielectric;
import org.daybreak.core.material.TwoSided;
import org.daybreak.core.math.Transform;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.Group;
import org.daybreak.core.scene.Instance;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.scene.ShapeNode;

/**
 * Scenes that path tracing and bidirectional path tracing can form, beside those that light tracing can form as well, {@link
 * CrossScenes}: with ideal mirrors and glass before the camera, all materials, and next to nothing but a sky.
 */
public final class BidirectionalScenes {
    private static final int SIZE = 24;

    private final SceneGraph graph = new SceneGraph();
    private final SplittableRandom random;

    private BidirectionalScenes(long seed) {
        random = new SplittableRandom(seed);
    }

    /** These and those of {@link CrossScenes} by name. */
    public static Map<String, SceneGraph> withCrossScenes() {
        Map<String, SceneGraph> scenes = new LinkedHashMap<>(CrossScenes.all());
        scenes.putAll(all());
        return scenes;
    }

    /** All scenes by name. */
    public static Map<String, SceneGraph> all() {
        Map<String, SceneGraph> scenes = new LinkedHashMap<>();
        scenes.put(
                "empty scene under a panorama",
                new BidirectionalScenes(1).panorama().view(0).graph);
        scenes.put(
                "empty scene under a panorama, thin lens",
                new BidirectionalScenes(2).panorama().view(0.2).graph);
        scenes.put(
                "empty scene under a panorama, environment camera",
                new BidirectionalScenes(3)
                        .panorama()
                        .camera(CameraSettings.environment(
                                Transform.rotate(1, 2, 3, 40).toMatrix4d()))
                        .graph);
        scenes.put(
                "empty scene under a sky, parallel rays",
                new BidirectionalScenes(4).heaven().parallel().graph);
        scenes.put(
                "glass and metal under a panorama",
                new BidirectionalScenes(5).panorama().balls().view(0).graph);
        scenes.put(
                "glass and metal under a panorama, parallel rays",
                new BidirectionalScenes(6).panorama().balls().parallel().graph);
        scenes.put(
                "lamp, glass and metal, thin lens",
                new BidirectionalScenes(7).hall().lamp().balls().view(0.08).graph);
        scenes.put(
                "lamp, glass and metal, parallel rays",
                new BidirectionalScenes(8).hall().lamp().balls().parallel().graph);
        scenes.put(
                "within glass",
                new BidirectionalScenes(9).hall().lamp().withinGlass().view(0).graph);
        scenes.put("masks", new BidirectionalScenes(10).hall().lamp().masks().view(0).graph);
        scenes.put(
                "lights of every kind",
                new BidirectionalScenes(11).everyLight().balls().view(0).graph);
        scenes.put(
                "lights of every kind, rough",
                new BidirectionalScenes(13).everyLight().roughBalls().view(0).graph);
        scenes.put(
                "mirrored instances of glass",
                new BidirectionalScenes(12).hall().instances().view(0).graph);
        for (int i = 0; i < 4; i++) {
            scenes.put(
                    "materials " + (i + 1),
                    new BidirectionalScenes(20 + i).hall().lamp().materials(i).view(0).graph);
        }
        scenes.put(
                "shining glass",
                new BidirectionalScenes(14).hall().lamp().shiningGlass().view(0).graph);
        return scenes;
    }

    /** Surfaces that shine by themselves and scatter by delta lobes alone, partly seen through each other. */
    private BidirectionalScenes shiningGlass() {
        add(new Sphere(new Point3d(0.4, -0.1, -0.2), 0.4), Transform.identity(), glass())
                .setRadiance(color(0.5, 1));
        add(new Sphere(new Point3d(0.1, -0.2, -0.9), 0.45), Transform.identity(), glass())
                .setRadiance(color(1, 2));
        add(
                        new Sphere(new Point3d(-0.6, -0.1, -0.5), 0.4),
                        Transform.identity(),
                        Conductor.mirror(ConstantTexture.grey(0.8)))
                .setRadiance(color(0.2, 0.4));
        return this;
    }

    private BidirectionalScenes hall() {
        add(new Sphere(new Point3d(0, 0, 0), 2), Transform.identity(), diffuse())
                .setFlipNormals(true);
        return this;
    }

    private BidirectionalScenes lamp() {
        add(
                        new Disk(),
                        Transform.translate(0.3, 1.3, 0)
                                .multiply(Transform.rotate(1, 0.1, 0, 90))
                                .multiply(Transform.scale(0.7, 0.6, 1)),
                        diffuse())
                .setRadiance(color(3, 6));
        return this;
    }

    private BidirectionalScenes panorama() {
        float[] rgb = new float[3 * 16 * 8];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) random.nextDouble(0.2, 1.2);
        }
        rgb[3 * (2 * 16 + 5)] = 4;
        light(new LightSource.ImageEnvironment(new RadianceMap(16, 8, rgb), 0.5))
                .setTransform(Transform.rotate(0.2, 1, 0.1, 77).toMatrix4d());
        return this;
    }

    /** A sky and its sun, which covers a few degrees. */
    private BidirectionalScenes heaven() {
        SkySettings morning = new SkySettings(
                SkySettings.Kind.HOSEK_WILKIE, 3, new Color3f(0.2f, 0.2f, 0.2f), new Vector3d(0.1, 0.15, 1));
        Transform upright = Transform.rotate(1, 0.1, 0, 170);
        light(new LightSource.Sky(morning, 10)).setTransform(upright.toMatrix4d());
        light(new LightSource.Sun(morning, 10, 0.02)).setTransform(upright.toMatrix4d());
        return this;
    }

    private BidirectionalScenes everyLight() {
        Transform fromAbove = Transform.lookAt(-0.4, 1, 0.5, 0, -0.3, -0.3, 0, 1, 0.1);
        light(new LightSource.Point(new Color3f(0.8f, 0.3f, 0.3f)))
                .setTransform(Transform.translate(0.2, 0.8, 0.3).toMatrix4d());
        light(new LightSource.Spot(new Color3f(0.5f, 1.5f, 0.5f), 50, 20)).setTransform(fromAbove.toMatrix4d());
        light(new LightSource.Directional(new Color3f(0.4f, 0.4f, 0.9f))).setTransform(fromAbove.toMatrix4d());
        light(new LightSource.ConstantEnvironment(new Color3f(0.1f, 0.2f, 0.1f)));
        add(
                new Disk(),
                Transform.translate(0, -1, -0.3)
                        .multiply(Transform.rotate(1, 0, 0, -90))
                        .multiply(Transform.scale(1.5, 1.5, 1)),
                diffuse());
        add(new Cube(), Transform.translate(0, 0.9, -0.6).multiply(Transform.scale(0.2, 0.1, 0.2)), new NullBsdf())
                .setRadiance(color(1, 3));
        add(new Sphere(new Point3d(-1, 0.4, -0.5), 0.2), Transform.identity(), diffuse())
                .setRadiance(new CheckerboardTexture(color(2, 4), color(0.1, 1), new double[] {4, 0, 0, 0, 4, 0}));
        return panorama().heaven();
    }

    private BidirectionalScenes balls() {
        add(new Sphere(new Point3d(0.5, -0.2, -0.4), 0.4), Transform.identity(), glass());
        add(new Sphere(new Point3d(-0.5, -0.2, -0.5), 0.4), Transform.identity(), Conductor.mirror(color(0.6, 0.9)));
        add(
                CrossScenes.globe(10, 6),
                Transform.translate(0, 0.5, -0.6).multiply(Transform.scale(0.3, 0.3, -0.3)),
                diffuse());
        return this;
    }

    /** Nothing ideal, so that eye paths can find all that points and directions light. */
    private BidirectionalScenes roughBalls() {
        add(new Sphere(new Point3d(0.5, -0.2, -0.4), 0.4), Transform.identity(), rough(0.3));
        add(
                new Sphere(new Point3d(-0.5, -0.2, -0.5), 0.4),
                Transform.identity(),
                new RoughPlastic(Microfacet.Kind.GGX, 0.3, 1.5, 1, color(0.2, 0.8), color(0.5, 1), false));
        return this;
    }

    /** The camera in a cube of glass, and things in and out of it. */
    private BidirectionalScenes withinGlass() {
        add(new Cube(), Transform.scale(0.9, 0.9, 1.35), glass());
        add(new Sphere(new Point3d(0.3, -0.2, -0.3), 0.25), Transform.identity(), diffuse());
        add(new Sphere(new Point3d(-0.3, 0.1, -0.2), 0.2), Transform.identity(), diffuse())
                .setRadiance(color(0.5, 2));
        return this;
    }

    /** Sheets with holes, half transparent ones, of glass, and lights behind and on them. */
    private BidirectionalScenes masks() {
        Texture fields = new CheckerboardTexture(
                ConstantTexture.grey(0), ConstantTexture.grey(1), new double[] {4, 0, 0, 0, 4, 0});
        List<Bsdf> sheets = List.of(
                new Mask(fields, new TwoSided(diffuse(), diffuse())),
                new Mask(ConstantTexture.grey(0.3), new TwoSided(diffuse(), diffuse())),
                new Mask(ConstantTexture.grey(0.6), glass()),
                new Mask(ConstantTexture.grey(0.5), new Mask(fields, Leaf.transmitter(color(0.3, 0.8)))),
                new Blend(ConstantTexture.grey(0.4), diffuse(), new NullBsdf()));
        for (int i = 0; i < sheets.size(); i++) {
            add(
                    new Rectangle(),
                    Transform.translate(0.4 * i - 0.8, 0.1 * i - 0.2, -0.1 * i)
                            .multiply(Transform.rotate(0.3 * i, 1, 0.1, 20 * i - 35))
                            .multiply(Transform.scale(0.35, 0.5, 1)),
                    sheets.get(i));
        }
        add(new Sphere(new Point3d(0.1, -0.8, -0.2), 0.25), Transform.identity(), new Mask(fields, diffuse()))
                .setRadiance(color(0.5, 1.5));
        return this;
    }

    private BidirectionalScenes instances() {
        Group prototype = new Group();
        prototype
                .add(new ShapeNode(CrossScenes.globe(12, 8), glass()))
                .setTransform(Transform.scale(0.4, 0.4, 0.4).toMatrix4d());
        ShapeNode lamp = prototype.add(new ShapeNode(CrossScenes.globe(8, 5), diffuse()));
        lamp.setTransform(Transform.translate(0.2, 0.9, 0.1)
                .multiply(Transform.scale(0.3, 0.2, 0.4))
                .toMatrix4d());
        lamp.setRadiance(color(2, 5));
        for (int side = -1; side <= 1; side += 2) {
            graph.root()
                    .add(new Instance(prototype))
                    .setTransform(Transform.translate(0.5 * side, -0.1, -0.3)
                            .multiply(Transform.rotate(0, 0.2, 1, 20))
                            .multiply(Transform.scale(side, 1, 0.8))
                            .toMatrix4d());
        }
        return this;
    }

    private BidirectionalScenes materials(int group) {
        List<Bsdf> materials = switch (group) {
            case 0 ->
                List.of(
                        new Plastic(1.5, 1, color(0.2, 0.8), color(0.5, 1), true),
                        new RoughPlastic(Microfacet.Kind.GGX, 0.3, 1.5, 1, color(0.2, 0.8), color(0.5, 1), false),
                        rough(0.4),
                        new RoughConductor(
                                Microfacet.Kind.BECKMANN,
                                Roughness.of(ConstantTexture.grey(0.2), ConstantTexture.grey(0.6)),
                                new Spectrum(0.2, 0.9, 1.4),
                                new Spectrum(3.9, 2.4, 1.6),
                                color(0.7, 1)));
            case 1 ->
                List.of(
                        new ThinDielectric(1.5, 1, color(0.5, 1), color(0.5, 1)),
                        new Leaf(color(0.1, 0.3), color(0.1, 0.5), color(0.1, 0.4), color(0.1, 0.4)),
                        phong(0.8, 0.6, 1),
                        phong(1, 0, 0.5));
            case 2 ->
                List.of(
                        principled(0.5, 0, 0, 0),
                        principled(0.4, 0.5, 1, 0),
                        principled(0.45, 0.3, 0.1, 0.8),
                        principledThin());
            default ->
                List.of(
                        new NormalMap(new ConstantTexture(0.6, 0.42, 0.9), diffuse(), true),
                        new NormalMap(new ConstantTexture(0.55, 0.45, 0.95), rough(0.5), false),
                        new Blend(ConstantTexture.grey(0.5), glass(), rough(0.3)),
                        new NormalMap(new ConstantTexture(0.55, 0.45, 0.95), Conductor.mirror(color(0.5, 0.9)), true));
        };
        for (int i = 0; i < 4; i++) {
            Transform at = Transform.translate(i % 2 - 0.5, i < 2 ? 0.35 : -0.5, -0.4);
            Shape shape = i % 2 == 0 ? new Sphere(new Point3d(0, 0, 0), 1) : CrossScenes.globe(14, 9);
            add(shape, at.multiply(Transform.scale(0.38, 0.38, 0.38)), materials.get(i));
        }
        return this;
    }

    private Bsdf rough(double alpha) {
        return new RoughDielectric(Microfacet.Kind.GGX, Roughness.of(alpha), 1.5, 1, color(0.7, 1), color(0.7, 1));
    }

    private Bsdf phong(double alpha, double transparency, double shininess) {
        return new GroimpPhong(
                new GroimpPhong.Parameters(
                        color(0.1, 0.4),
                        ConstantTexture.grey(alpha),
                        color(0.1, 0.3),
                        ConstantTexture.grey(0.5),
                        ConstantTexture.grey(transparency),
                        ConstantTexture.grey(shininess),
                        ConstantTexture.grey(0.3),
                        true),
                1.4,
                1);
    }

    private Bsdf principled(double roughness, double anisotropic, double metallic, double specTrans) {
        return new Principled(new Principled.Parameters(
                color(0.3, 0.8),
                ConstantTexture.grey(roughness),
                ConstantTexture.grey(anisotropic),
                ConstantTexture.grey(metallic),
                ConstantTexture.grey(specTrans),
                1.5,
                ConstantTexture.grey(0.5),
                ConstantTexture.grey(0.3),
                ConstantTexture.grey(0.5),
                ConstantTexture.grey(0.2),
                ConstantTexture.grey(0.5),
                ConstantTexture.grey(0.3)));
    }

    private Bsdf principledThin() {
        return new PrincipledThin(new PrincipledThin.Parameters(
                color(0.3, 0.8),
                ConstantTexture.grey(0.4),
                ConstantTexture.grey(0),
                ConstantTexture.grey(0.5),
                1.5,
                ConstantTexture.grey(0.5),
                ConstantTexture.grey(0.3),
                ConstantTexture.grey(0.5),
                ConstantTexture.grey(0.4),
                ConstantTexture.grey(0.6)));
    }

    private BidirectionalScenes view(double apertureRadius) {
        return camera(new CameraSettings(position().toMatrix4d(), 65, CameraSettings.FovAxis.X, apertureRadius, 1.3));
    }

    private BidirectionalScenes parallel() {
        return camera(CameraSettings.orthographic(
                position().multiply(Transform.scale(0.9, 0.9, 1)).toMatrix4d()));
    }

    private static Transform position() {
        return Transform.lookAt(0.05, 0.1, 1.25, 0, -0.1, -0.4, 0.05, 1, 0);
    }

    private BidirectionalScenes camera(CameraSettings camera) {
        graph.setCamera(camera);
        graph.setFilm(new FilmSettings(SIZE, SIZE, ReconstructionFilter.BOX));
        return this;
    }

    private LightNode light(LightSource source) {
        return graph.root().add(new LightNode(source));
    }

    private ShapeNode add(Shape shape, Transform transform, Bsdf material) {
        ShapeNode node = graph.root().add(new ShapeNode(shape, material));
        node.setTransform(transform.toMatrix4d());
        return node;
    }

    private ConstantTexture color(double from, double to) {
        return new ConstantTexture(
                random.nextDouble(from, to), random.nextDouble(from, to), random.nextDouble(from, to));
    }

    private Bsdf diffuse() {
        return new Diffuse(color(0.2, 0.8));
    }

    private static Bsdf glass() {
        return new Dielectric(1.5, 1, ConstantTexture.grey(1), ConstantTexture.grey(1));
    }
}
