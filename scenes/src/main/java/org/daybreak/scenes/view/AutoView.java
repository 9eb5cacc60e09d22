package org.daybreak.scenes.view;

import java.util.IdentityHashMap;
import javax.vecmath.Matrix4d;
import javax.vecmath.Vector3d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.light.RadianceMap;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.TwoSided;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Transform;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.CameraSettings.FovAxis;
import org.daybreak.core.scene.Group;
import org.daybreak.core.scene.Instance;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.Node;
import org.daybreak.core.scene.SceneGraph;
import org.jspecify.annotations.Nullable;

/**
 * Gives a scene the view and the light that its file leaves out.
 *
 * <p>The camera looks down at the model from its front, 35° to the right and 20° above, from where the model just fits with a
 * margin of a tenth. Light comes from everywhere (radiance {@value #AMBIENT}) and from a soft lamp at infinity, 18° in
 * radius, from above and the left of the camera: on a surface that faces the lamp, three times as much as from
 * everywhere. A white surface (albedo 0.8) stays below 1.
 */
public final class AutoView {
    /** Which axis of a model points up; its front is what the world sees from +z if that is y, else from −y. */
    public enum UpAxis {
        /** y is up and z points to the viewer: glTF, OBJ, scanned meshes. */
        Y,
        /** z is up and y points away from the viewer: STL and other files of construction programs. */
        Z
    }

    /**
     * What was added to a scene.
     *
     * @param camera the camera, with a film; null if the scene has one
     * @param light the light; null if the scene has one
     */
    public record Additions(
            @Nullable CameraSettings camera, @Nullable LightNode light) {
        /** Nothing. */
        public static final Additions NONE = new Additions(null, null);
    }

    /** Reflectance of the material of models that name none. */
    public static final double NEUTRAL_ALBEDO = 0.6;

    private static final int WIDTH = 960;
    private static final int HEIGHT = 720;
    private static final double FIELD_OF_VIEW = 35;
    private static final double AZIMUTH = Math.toRadians(35);
    private static final double ELEVATION = Math.toRadians(20);

    /** Part of the half image that the model may fill. */
    private static final double FILL = 0.9;

    private static final double AMBIENT = 0.35;
    /** Irradiance in W/m² of the lamp on a surface that faces it. */
    private static final double LAMP_IRRADIANCE = 2;

    private static final double LAMP_RADIUS = Math.toRadians(18);
    /** Half the width of the ring in which the lamp fades out. */
    private static final double LAMP_EDGE = Math.toRadians(4);

    private static final int MAP_ROWS = 181;

    private AutoView() {}

    /** The material of models that name none: diffuse on both sides, albedo 0.6. */
    public static Bsdf neutralMaterial() {
        Bsdf grey = new Diffuse(ConstantTexture.grey(NEUTRAL_ALBEDO));
        return new TwoSided(grey, grey);
    }

    /**
     * Adds what the scene lacks of film (960×720), camera and light. What is there stays as it is. Shapes that emit do not
     * count as light: in models they are displays and lamps that glow, and would leave the rest dark.
     *
     * @param graph the scene
     * @param up which axis of the model points up; matters only if there is no camera
     * @return what was added
     * @throws IllegalArgumentException if there is no camera and nothing to look at, a group contains itself, or a
     *     transform is singular or not finite
     */
    public static Additions complete(SceneGraph graph, UpAxis up) {
        FilmSettings film = graph.film();
        if (film == null) {
            film = new FilmSettings(WIDTH, HEIGHT, ReconstructionFilter.GAUSSIAN);
            graph.setFilm(film);
        }
        CameraSettings given = graph.camera();
        CameraSettings camera = given == null ? fit(graph.root(), up, (double) film.width() / film.height()) : given;
        graph.setCamera(camera);
        LightNode light = hasLight(graph.root(), new IdentityHashMap<>()) ? null : light(camera.toWorld());
        if (light != null) {
            graph.root().add(light);
        }
        return new Additions(given == null ? camera : null, light);
    }

    /**
     * A camera that shows all of a group, as the class says.
     *
     * @param aspect width of the image over its height
     * @throws IllegalArgumentException if the group holds no geometry, a group contains itself, or a transform is singular
     *     or not finite
     */
    public static CameraSettings fit(Group root, UpAxis up, double aspect) {
        Bounds.Builder builder = new Bounds.Builder();
        ScenePoints.visit(root, builder::include);
        Bounds box = builder.build();
        if (box.isEmpty()) {
            throw new IllegalArgumentException("the scene is empty: there is nothing to look at");
        }
        double cx = box.centerX();
        double cy = box.centerY();
        double cz = box.centerZ();
        // A single point is seen from a distance at which directions still have digits.
        double place = Math.max(Math.abs(cx), Math.max(Math.abs(cy), Math.abs(cz)));
        double radius = Math.max(box.boundingSphereRadius(), place == 0 ? Double.MIN_NORMAL : 1e-6 * place);
        double side = Math.cos(ELEVATION) * Math.sin(AZIMUTH);
        double front = Math.cos(ELEVATION) * Math.cos(AZIMUTH);
        double above = Math.sin(ELEVATION);
        boolean y = up == UpAxis.Y;
        double dx = side;
        double dy = y ? above : -front;
        double dz = y ? front : above;
        // Camera axes about the centre of the box: how far back must the camera go until each point is in the image?
        Transform toView = Transform.lookAt(
                        cx, cy, cz, cx - radius * dx, cy - radius * dy, cz - radius * dz, 0, y ? 1 : 0, y ? 0 : 1)
                .inverse();
        double tan = Math.tan(Math.toRadians(FIELD_OF_VIEW / 2)) * FILL;
        double tanX = tan * Math.max(1, aspect);
        double tanY = tan * Math.max(1, 1 / aspect);
        double[] p = new double[3];
        double[] distance = {0};
        ScenePoints.visit(root, (x1, y1, z1) -> {
            toView.applyPoint(x1, y1, z1, p);
            distance[0] = Math.max(distance[0], Math.max(Math.abs(p[0]) / tanX, Math.abs(p[1]) / tanY) - p[2]);
        });
        // Never so near that the perspective of a thing seen end-on takes over.
        double d = Math.max(distance[0], 1.5 * radius);
        Transform toWorld =
                Transform.lookAt(cx + d * dx, cy + d * dy, cz + d * dz, cx, cy, cz, 0, y ? 1 : 0, y ? 0 : 1);
        return new CameraSettings(toWorld.toMatrix4d(), FIELD_OF_VIEW, FovAxis.SMALLER, 0, d);
    }

    /**
     * The light that the class describes, as an environment: it takes no place and casts soft shadows.
     *
     * @param camera camera-to-world transform
     */
    public static LightNode light(Matrix4d camera) {
        float[] rgb = new float[3 * 2 * MAP_ROWS];
        double[] profile = new double[MAP_ROWS];
        double irradiance = 0;
        for (int row = 0; row < MAP_ROWS; row++) {
            double theta = Math.PI * row / (MAP_ROWS - 1);
            double t = Math.max(0, Math.min(1, (LAMP_RADIUS + LAMP_EDGE - theta) / (2 * LAMP_EDGE)));
            profile[row] = t * t * (3 - 2 * t);
            irradiance += 2 * Math.PI * Math.PI / (MAP_ROWS - 1) * profile[row] * Math.sin(theta) * Math.cos(theta);
        }
        for (int row = 0; row < MAP_ROWS; row++) {
            double radiance = AMBIENT + LAMP_IRRADIANCE / irradiance * profile[row];
            for (int i = 0; i < 6; i++) {
                rgb[6 * row + i] = (float) radiance;
            }
        }
        LightNode node = new LightNode(new LightSource.ImageEnvironment(new RadianceMap(2, MAP_ROWS, rgb), 1));
        node.setName("auto view light");
        node.setTransform(lampTransform(camera));
        return node;
    }

    /** A rotation that brings the lamp from +y, the zenith of its map, to the left, above and behind the camera. */
    private static Matrix4d lampTransform(Matrix4d camera) {
        Vector3d left = new Vector3d(camera.m00, camera.m10, camera.m20);
        Vector3d above = new Vector3d(camera.m01, camera.m11, camera.m21);
        Vector3d forward = new Vector3d(camera.m02, camera.m12, camera.m22);
        Vector3d lamp = new Vector3d();
        lamp.scaleAdd(0.55, left, lamp);
        lamp.scaleAdd(0.65, above, lamp);
        lamp.scaleAdd(-0.6, forward, lamp);
        lamp.normalize();
        Vector3d x = new Vector3d();
        x.cross(lamp, forward);
        x.normalize();
        Vector3d z = new Vector3d();
        z.cross(x, lamp);
        return new Matrix4d(x.x, lamp.x, z.x, 0, x.y, lamp.y, z.y, 0, x.z, lamp.z, z.z, 0, 0, 0, 0, 1);
    }

    private static boolean hasLight(Group group, IdentityHashMap<Group, Boolean> visited) {
        if (visited.put(group, Boolean.TRUE) != null) {
            return false;
        }
        for (Node child : group.children()) {
            if (child instanceof LightNode
                    || (child instanceof Group inner && hasLight(inner, visited))
                    || (child instanceof Instance instance && hasLight(instance.prototype(), visited))) {
                return true;
            }
        }
        return false;
    }
}
