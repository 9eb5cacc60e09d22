package org.daybreak.convergence;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.SplittableRandom;
import javax.vecmath.Color3f;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.geometry.Cube;
import org.daybreak.core.geometry.Cylinder;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.light.PhotometricProfile;
import org.daybreak.core.light.RadianceMap;
import org.daybreak.core.light.SkySettings;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.CheckerboardTexture;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.Mask;
import org.daybreak.core.material.Microfacet;
import org.daybreak.core.material.RoughConductor;
import org.daybreak.core.material.RoughPlastic;
import org.daybreak.core.material.TwoSided;
import org.daybreak.core.math.Transform;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.Group;
import org.daybreak.core.scene.Instance;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.Node;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.core.scene.ShapeNode;

/**
 * Scenes of random colours and places that both a path tracer and a light tracer can form: nothing that the camera sees
 * scatters in ideal directions only.
 */
public final class CrossScenes {
    private static final int SIZE = 24;

    private final SceneGraph graph = new SceneGraph();
    private final SplittableRandom random;

    private CrossScenes(long seed) {
        random = new SplittableRandom(seed);
    }

    /** All scenes by name. */
    public static Map<String, SceneGraph> all() {
        Map<String, SceneGraph> scenes = new LinkedHashMap<>();
        Transform ceiling = Transform.translate(0.2, 0.95, -0.1)
                .multiply(Transform.rotate(1, 0, 0, 90))
                .multiply(Transform.scale(0.35, 0.25, 1));
        Transform floating = Transform.translate(-0.3, 0.45, -0.2)
                .multiply(Transform.rotate(1, 2, 0.5, 37))
                .multiply(Transform.scale(0.18, 0.25, 0.15));
        Transform mirrored = floating.multiply(Transform.scale(-1, 1, 1));
        Shape tube = new Cylinder(new Point3d(0, -1, 0), new Point3d(0, 1, 0), 0.5);
        Shape ball = new Sphere(new Point3d(0, 0, 0), 1);
        scenes.put("rectangle", new CrossScenes(1).room().emitter(new Rectangle(), ceiling, false).graph);
        scenes.put("mirrored rectangle", new CrossScenes(2).room().emitter(new Rectangle(), mirrored, false).graph);
        scenes.put("chequered rectangle", new CrossScenes(3).room().chequeredEmitter(ceiling).graph);
        scenes.put("disk", new CrossScenes(4).room().emitter(new Disk(), ceiling, false).graph);
        scenes.put(
                "sphere",
                new CrossScenes(5)
                        .room()
                        .emitter(
                                ball,
                                Transform.translate(-0.3, 0.5, -0.2).multiply(Transform.scale(0.2, 0.2, 0.2)),
                                false)
                        .graph);
        scenes.put("ellipsoid", new CrossScenes(6).room().emitter(ball, floating, false).graph);
        scenes.put("flipped sphere", new CrossScenes(7).flippedSphere().graph);
        scenes.put("cylinder", new CrossScenes(8).room().emitter(tube, floating, false).graph);
        scenes.put("mirrored cylinder", new CrossScenes(9).room().emitter(tube, mirrored, false).graph);
        scenes.put("cube", new CrossScenes(10).room().emitter(new Cube(), floating, false).graph);
        scenes.put("mesh", new CrossScenes(11).room().emitter(globe(8, 5), floating, false).graph);
        scenes.put("mirrored mesh", new CrossScenes(12).room().emitter(globe(8, 5), mirrored, false).graph);
        scenes.put("flipped meshes", new CrossScenes(13).room().sheets().graph);
        scenes.put("point", new CrossScenes(14).room().point().graph);
        scenes.put("spot", new CrossScenes(15).room().spot().graph);
        scenes.put(
                "constant environment",
                new CrossScenes(16).garden(new LightSource.ConstantEnvironment(new Color3f(0.8f, 1, 1.3f))).graph);
        scenes.put("image environment", new CrossScenes(17).garden(sky()).graph);
        scenes.put(
                "directional",
                new CrossScenes(26).garden(new LightSource.Directional(new Color3f(2, 1.5f, 1)), 210).graph);
        scenes.put(
                "all kinds",
                new CrossScenes(18)
                        .room()
                        .emitter(new Disk(), ceiling, false)
                        .emitter(ball, floating, false)
                        .point()
                        .spot()
                        .graph);
        scenes.put(
                "shading normals",
                new CrossScenes(19)
                        .room()
                        .emitter(new Rectangle(), ceiling, false)
                        .globes()
                        .graph);
        scenes.put(
                "rough materials",
                new CrossScenes(20)
                        .room()
                        .emitter(new Rectangle(), ceiling, false)
                        .roughThings()
                        .graph);
        scenes.put(
                "veils",
                new CrossScenes(21)
                        .room()
                        .emitter(new Rectangle(), ceiling, false)
                        .veils()
                        .graph);
        scenes.put(
                "instances",
                new CrossScenes(22)
                        .room()
                        .emitter(new Rectangle(), ceiling, false)
                        .instances()
                        .graph);
        scenes.put("light in glass", new CrossScenes(23).lightInGlass().graph);
        scenes.put("inside of a glass sphere", new CrossScenes(24).insideOfGlass().graph);
        scenes.put(
                "thin lens",
                new CrossScenes(25).room().emitter(new Disk(), ceiling, false).thinLens().graph);
        scenes.put(
                "orthographic camera",
                new CrossScenes(27)
                        .garden(sky())
                        .camera(CameraSettings.orthographic(Transform.lookAt(0.2, 0.4, 2.2, 0, -0.6, 0, 0.05, 1, 0.1)
                                .multiply(Transform.scale(1.5, 1.5, 1))
                                .toMatrix4d()))
                        .graph);
        scenes.put(
                "environment camera",
                new CrossScenes(28)
                        .garden(sky())
                        .camera(CameraSettings.environment(Transform.lookAt(0.1, -0.2, 0.9, 0, -0.6, 0, 0.05, 1, 0.1)
                                .toMatrix4d()))
                        .graph);
        SkySettings evening = new SkySettings(
                SkySettings.Kind.HOSEK_WILKIE, 4, new Color3f(0.2f, 0.2f, 0.2f), new Vector3d(0.5, 0.4, 0.5));
        Matrix4d upright = Transform.rotate(1, 0, 0, -90).toMatrix4d();
        scenes.put("sky", new CrossScenes(30).sky(new LightSource.Sky(evening, 10), upright).graph);
        scenes.put("sun", new CrossScenes(31).sky(new LightSource.Sun(evening, 8, 0.02), upright).graph);
        scenes.put("luminaire", new CrossScenes(32).room().lamp(luminaire()).graph);
        scenes.put(
                "slide",
                new CrossScenes(33)
                        .room()
                        .lamp(new LightSource.Spot(
                                new Color3f(2, 2, 2),
                                60,
                                50,
                                new CheckerboardTexture(
                                        new ConstantTexture(1, 0.2, 0.1),
                                        new ConstantTexture(0.1, 0.5, 1),
                                        new double[] {2, 0, 0, 0, 2, 0})))
                        .graph);
        Matrix4d askew = Transform.lookAt(0.1, 0.15, 0.95, -0.05, -0.15, -0.6, 0.05, 1, 0.1)
                .toMatrix4d();
        scenes.put(
                "shifted film of flat pixels",
                new CrossScenes(29)
                        .room()
                        .emitter(new Disk(), ceiling, false)
                        .camera(new CameraSettings(
                                askew,
                                CameraSettings.Projection.PERSPECTIVE,
                                75,
                                CameraSettings.FovAxis.Y,
                                0,
                                1,
                                0.2,
                                -0.1,
                                1.5))
                        .graph);
        return scenes;
    }

    private CrossScenes sky(LightSource sky, Matrix4d toWorld) {
        garden(sky);
        Node light = graph.root().children().stream()
                .filter(LightNode.class::isInstance)
                .findFirst()
                .orElseThrow();
        light.setTransform(toWorld);
        return this;
    }

    /** A lamp that hangs in the room and shines down. */
    private CrossScenes lamp(LightSource lamp) {
        graph.root()
                .add(new LightNode(lamp))
                .setTransform(Transform.lookAt(-0.2, 0.7, 0.3, 0, -0.6, -0.2, 0, 1, 0.1)
                        .toMatrix4d());
        return this;
    }

    private static LightSource luminaire() {
        double[] candela = {800, 900, 300, 50, 0, 800, 600, 400, 50, 0, 800, 500, 100, 20, 0};
        return new LightSource.Photometric(
                new PhotometricProfile(new double[] {0, 30, 60, 80, 90}, new double[] {0, 45, 90}, candela),
                new Color3f(1, 0.9f, 0.8f));
    }

    private CrossScenes camera(CameraSettings camera) {
        graph.setCamera(camera);
        return this;
    }

    /** A closed box with two things in it, seen from within. */
    private CrossScenes room() {
        box(1, 1);
        add(new Sphere(new Point3d(0.35, -0.65, -0.3), 0.35), Transform.identity(), diffuse());
        add(
                new Cube(),
                Transform.translate(-0.5, -0.7, 0.1)
                        .multiply(Transform.rotate(0, 1, 0, random.nextDouble(90)))
                        .multiply(Transform.scale(0.2, 0.3, 0.2)),
                diffuse());
        look(0.1, 0.15, 0.95, -0.05, -0.15, -0.6, 75, 0);
        return this;
    }

    private void box(double half, double height) {
        for (int axis = 0; axis < 3; axis++) {
            for (int side = -1; side <= 1; side += 2) {
                Transform turn = axis == 0
                        ? Transform.rotate(0, 1, 0, -90.0 * side)
                        : axis == 1
                                ? Transform.rotate(1, 0, 0, 90.0 * side)
                                : Transform.rotate(0, 1, 0, side > 0 ? 180 : 0);
                double distance = axis == 1 ? height : half;
                Transform move = Transform.translate(
                        axis == 0 ? side * distance : 0,
                        axis == 1 ? side * distance : 0,
                        axis == 2 ? side * distance : 0);
                double high = axis == 1 ? half : height;
                add(new Rectangle(), move.multiply(turn).multiply(Transform.scale(half, high, 1)), diffuse());
            }
        }
    }

    /** Things on a large disk under the open sky. */
    private CrossScenes garden(LightSource sky) {
        return garden(sky, 77);
    }

    private CrossScenes garden(LightSource sky, double degrees) {
        add(
                new Disk(),
                Transform.translate(0, -1, 0)
                        .multiply(Transform.rotate(1, 0, 0, -90))
                        .multiply(Transform.scale(2, 2, 1)),
                diffuse());
        add(new Sphere(new Point3d(0.35, -0.65, -0.3), 0.35), Transform.identity(), diffuse());
        add(globe(10, 6), Transform.translate(-0.4, -0.6, 0).multiply(Transform.scale(0.3, 0.4, 0.3)), diffuse());
        graph.root()
                .add(new LightNode(sky))
                .setTransform(Transform.rotate(0.2, 1, 0.1, degrees).toMatrix4d());
        look(0.2, -0.2, 2.2, 0, -0.7, 0, 60, 0);
        return this;
    }

    private static LightSource sky() {
        int width = 16;
        int height = 8;
        float[] rgb = new float[3 * width * height];
        SplittableRandom random = new SplittableRandom(99);
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = (float) (0.2 + random.nextDouble());
        }
        // A bright patch above the horizon.
        for (int c = 0; c < 3; c++) {
            rgb[3 * (2 * width + 5) + c] = 20 - 5 * c;
        }
        return new LightSource.ImageEnvironment(new RadianceMap(width, height, rgb), 0.5);
    }

    private CrossScenes emitter(Shape shape, Transform transform, boolean flip) {
        ShapeNode node = add(shape, transform, diffuse());
        node.setFlipNormals(flip);
        node.setRadiance(color(4, 9));
        return this;
    }

    /** Four sheets of triangles that hang in the room, with and without mirroring and exchange of their sides. */
    private CrossScenes sheets() {
        for (int i = 0; i < 4; i++) {
            emitter(
                    sheet(),
                    Transform.translate(i % 2 - 0.5, 0.5, i < 2 ? -0.6 : 0.4)
                            .multiply(Transform.rotate(1, 0.3 * i, 0, 70))
                            .multiply(Transform.scale(i % 2 == 0 ? -0.2 : 0.2, 0.15, 1)),
                    i / 2 == 0);
        }
        return this;
    }

    private CrossScenes chequeredEmitter(Transform transform) {
        double[] threeFields = {3, 0, 0.2, 0, 3, 0.4};
        add(new Rectangle(), transform, diffuse())
                .setRadiance(new CheckerboardTexture(color(5, 9), color(0.1, 1), threeFields));
        return this;
    }

    /** A sphere that emits inwards, and things in it. */
    private CrossScenes flippedSphere() {
        ShapeNode outer = add(new Sphere(new Point3d(0, 0, 0), 1.6), Transform.identity(), diffuse());
        outer.setFlipNormals(true);
        outer.setRadiance(color(0.3, 1));
        add(new Sphere(new Point3d(0.35, -0.3, -0.3), 0.4), Transform.identity(), diffuse());
        look(0.1, 0.15, 1.1, 0, -0.1, -0.6, 75, 0);
        return this;
    }

    private CrossScenes point() {
        graph.root()
                .add(new LightNode(new LightSource.Point(intensity())))
                .setTransform(Transform.translate(0.3, 0.5, 0.1).toMatrix4d());
        return this;
    }

    private CrossScenes spot() {
        graph.root()
                .add(new LightNode(new LightSource.Spot(intensity(), 50, 20)))
                .setTransform(Transform.lookAt(-0.2, 0.7, 0.3, 0.2, -0.6, -0.2, 0, 1, 0.1)
                        .toMatrix4d());
        return this;
    }

    /** Spheres of few triangles with the normals of round ones: shading and geometry disagree by up to 30 degrees. */
    private CrossScenes globes() {
        add(globe(6, 4), Transform.translate(0.45, 0.1, -0.4).multiply(Transform.scale(0.3, 0.3, 0.3)), diffuse());
        add(globe(7, 4), Transform.translate(-0.45, 0, -0.5).multiply(Transform.scale(-0.3, 0.4, 0.25)), diffuse());
        return this;
    }

    private CrossScenes roughThings() {
        Spectrum eta = new Spectrum(0.2, 0.92, 1.1);
        Spectrum k = new Spectrum(3.9, 2.45, 2.14);
        Bsdf metal = new RoughConductor(Microfacet.Kind.GGX, 0.35, eta, k, ConstantTexture.grey(1));
        Bsdf plastic =
                new RoughPlastic(Microfacet.Kind.BECKMANN, 0.4, 1.5, 1, color(0.2, 0.8), ConstantTexture.grey(1), true);
        add(new Sphere(new Point3d(0.5, 0.1, -0.4), 0.3), Transform.identity(), metal);
        add(globe(24, 14), Transform.translate(-0.45, 0.2, -0.5).multiply(Transform.scale(0.3, 0.3, 0.3)), plastic);
        return this;
    }

    /** Half-transparent sheets before the camera and under the light, and a sheet with two sides. */
    private CrossScenes veils() {
        Bsdf veil = new Mask(color(0.3, 0.7), diffuse());
        add(
                new Rectangle(),
                Transform.translate(0.1, 0.7, 0)
                        .multiply(Transform.rotate(1, 0, 0, 80))
                        .multiply(Transform.scale(0.6, 0.5, 1)),
                veil);
        add(
                new Disk(),
                Transform.translate(-0.2, -0.1, 0.2)
                        .multiply(Transform.rotate(0, 1, 0, 20))
                        .multiply(Transform.scale(0.4, 0.4, 1)),
                veil);
        Bsdf sheet = new TwoSided(diffuse(), diffuse());
        add(
                new Rectangle(),
                Transform.translate(0.5, 0.2, -0.2)
                        .multiply(Transform.rotate(0, 1, 0.3, 70))
                        .multiply(Transform.scale(0.3, 0.3, 1)),
                sheet);
        return this;
    }

    /** A group with an emitter in it, placed twice, once mirrored. */
    private CrossScenes instances() {
        Group prototype = new Group();
        ShapeNode mesh = prototype.add(new ShapeNode(globe(6, 4), diffuse()));
        mesh.setTransform(Transform.scale(1, 0.6, 1).toMatrix4d());
        ShapeNode lamp = prototype.add(new ShapeNode(new Cube(), diffuse()));
        lamp.setTransform(Transform.translate(0, 0.9, 0)
                .multiply(Transform.scale(0.2, 0.2, 0.4))
                .toMatrix4d());
        lamp.setRadiance(color(2, 6));
        graph.root()
                .add(new Instance(prototype))
                .setTransform(Transform.translate(0.5, 0.1, -0.4)
                        .multiply(Transform.scale(0.25, 0.25, 0.25))
                        .toMatrix4d());
        graph.root()
                .add(new Instance(prototype))
                .setTransform(Transform.translate(-0.5, 0.2, -0.5)
                        .multiply(Transform.rotate(0, 0, 1, 100))
                        .multiply(Transform.scale(-0.3, 0.25, 0.25))
                        .toMatrix4d());
        return this;
    }

    /** A lamp in a glass ball above the camera, which looks down at the floor and does not see it. */
    private CrossScenes lightInGlass() {
        box(1, 1);
        add(new Sphere(new Point3d(0, 0.6, 0), 0.35), Transform.identity(), glass());
        add(new Sphere(new Point3d(0.05, 0.6, 0), 0.2), Transform.identity(), new Diffuse(ConstantTexture.grey(0)))
                .setRadiance(color(3, 6));
        look(0.1, 0.1, 0.7, -0.1, -1, -0.1, 60, 0);
        return this;
    }

    /**
     * Camera, lamp and a disk within a glass ball in a lit room. Radiance in the glass is n² times that outside; the disk, all
     * that the camera sees, is lit from within, through the glass, and by reflection within it.
     */
    private CrossScenes insideOfGlass() {
        box(2, 2);
        add(new Sphere(new Point3d(0, 0, 0), 1.3), Transform.identity(), glass());
        add(new Disk(), Transform.translate(0, -0.5, 0).multiply(Transform.rotate(1, 0, 0, -90)), diffuse());
        add(new Sphere(new Point3d(-0.2, 0.7, -0.2), 0.2), Transform.identity(), diffuse())
                .setRadiance(color(1, 2));
        add(new Rectangle(), Transform.translate(0, 1.95, 0).multiply(Transform.rotate(1, 0, 0, 90)), diffuse())
                .setRadiance(color(2, 4));
        look(0.3, 0.5, 0.3, 0.05, -0.5, 0.05, 50, 0);
        return this;
    }

    private CrossScenes thinLens() {
        look(0.1, 0.15, 0.85, -0.05, -0.15, -0.6, 70, 0.06);
        return this;
    }

    private ShapeNode add(Shape shape, Transform transform, Bsdf material) {
        ShapeNode node = graph.root().add(new ShapeNode(shape, material));
        node.setTransform(transform.toMatrix4d());
        return node;
    }

    private void look(
            double x, double y, double z, double atX, double atY, double atZ, double fov, double apertureRadius) {
        Transform camera = Transform.lookAt(x, y, z, atX, atY, atZ, 0.05, 1, 0.1);
        graph.setCamera(new CameraSettings(camera.toMatrix4d(), fov, CameraSettings.FovAxis.X, apertureRadius, 1.2));
        graph.setFilm(new FilmSettings(SIZE, SIZE, ReconstructionFilter.BOX));
    }

    private ConstantTexture color(double from, double to) {
        return new ConstantTexture(
                random.nextDouble(from, to), random.nextDouble(from, to), random.nextDouble(from, to));
    }

    private Color3f intensity() {
        return new Color3f((float) random.nextDouble(0.5, 2), (float) random.nextDouble(0.5, 2), (float)
                random.nextDouble(0.5, 2));
    }

    private Bsdf diffuse() {
        return new Diffuse(color(0.1, 0.8));
    }

    private static Bsdf glass() {
        return new Dielectric(1.5, 1, ConstantTexture.grey(1), ConstantTexture.grey(1));
    }

    /** The square [-1, 1]² of two triangles with vertex normals that lean. */
    private static TriangleMesh sheet() {
        float[] positions = {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0};
        float[] normals = {0.3f, 0, 1, 0, 0.3f, 1, -0.2f, 0, 1, 0, -0.3f, 1};
        return new TriangleMesh(positions, new int[] {0, 1, 2, 0, 2, 3}, normals, null);
    }

    /** A unit sphere of few triangles, with the normals of the sphere. */
    static TriangleMesh globe(int meridians, int parallels) {
        int vertices = meridians * (parallels - 1) + 2;
        float[] positions = new float[3 * vertices];
        for (int j = 1; j < parallels; j++) {
            for (int i = 0; i < meridians; i++) {
                double theta = Math.PI * j / parallels;
                double phi = 2 * Math.PI * i / meridians;
                int at = 3 * ((j - 1) * meridians + i);
                positions[at] = (float) (Math.sin(theta) * Math.sin(phi));
                positions[at + 1] = (float) Math.cos(theta);
                positions[at + 2] = (float) (Math.sin(theta) * Math.cos(phi));
            }
        }
        int north = vertices - 2;
        int south = vertices - 1;
        positions[3 * north + 1] = 1;
        positions[3 * south + 1] = -1;
        int[] triangles = new int[6 * meridians * (parallels - 1)];
        int at = 0;
        for (int i = 0; i < meridians; i++) {
            int next = (i + 1) % meridians;
            at = triangle(triangles, at, north, i, next);
            for (int j = 0; j < parallels - 2; j++) {
                int row = j * meridians;
                int below = row + meridians;
                at = triangle(triangles, at, row + i, below + i, below + next);
                at = triangle(triangles, at, row + i, below + next, row + next);
            }
            int last = (parallels - 2) * meridians;
            at = triangle(triangles, at, south, last + next, last + i);
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
