package org.daybreak.scenes.gltf;

import java.util.List;
import javax.vecmath.Matrix4d;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.jspecify.annotations.Nullable;

/** Cameras. glTF says nothing about the size of pictures: the shorter side gets {@value #SHORTER_SIDE} pixels. */
final class Cameras {
    private static final int SHORTER_SIDE = 720;
    private static final double DEFAULT_ASPECT = 4.0 / 3;
    private static final double LARGEST_ASPECT = 64;
    private static final List<String> TYPES = List.of("perspective", "orthographic");

    private final Container container;
    private final Report report;

    Cameras(Container container, Report report) {
        this.container = container;
        this.report = report;
    }

    /** The camera of a node, or null if it has none. */
    @Nullable
    ObjectDescription camera(JsonValue node, Matrix4d world) throws GltfException {
        JsonValue camera = container.resolve(node, "camera", "cameras");
        if (camera == null) {
            return null;
        }
        String type = camera.get("type").text();
        if (!TYPES.contains(type)) {
            camera.choice("type", "", TYPES);
        }
        JsonValue lens = camera.get(type);
        Matrix4d toWorld = Frames.rigid(world, node);
        ObjectBuilder builder = new ObjectBuilder(ObjectKind.SENSOR, type, report.location(camera));
        if (type.equals("perspective")) {
            double yfov = lens.get("yfov").number();
            if (!(yfov > 1e-5 && yfov < Math.PI - 1e-5)) {
                throw lens.get("yfov").error("must be greater than 0 and less than π but is " + yfov);
            }
            builder.number("fov", Math.toDegrees(yfov)).text("fov_axis", "y");
            builder.transform("to_world", toWorld);
            JsonValue aspect = lens.find("aspectRatio");
            film(builder, aspect == null ? DEFAULT_ASPECT : aspect.number(), aspect == null ? lens : aspect);
            return builder.build();
        }
        double xmag = magnification(lens, "xmag");
        double ymag = magnification(lens, "ymag");
        // The image is [-1, 1] wide in camera coordinates and as high as its aspect says.
        Matrix4d scale = new Matrix4d(xmag, 0, 0, 0, 0, xmag, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1);
        toWorld.mul(scale);
        builder.transform("to_world", toWorld);
        film(builder, xmag / ymag, lens);
        return builder.build();
    }

    private static double magnification(JsonValue lens, String name) throws GltfException {
        double value = Math.abs(lens.get(name).number());
        if (!(value > 1e-12 && value < 1e12)) {
            throw lens.get(name).error("must not be 0 but is " + value);
        }
        return value;
    }

    private void film(ObjectBuilder camera, double aspect, JsonValue where) throws GltfException {
        if (!(aspect >= 1 / LARGEST_ASPECT && aspect <= LARGEST_ASPECT)) {
            throw where.error("gives an image " + aspect + " times as wide as it is high");
        }
        ObjectBuilder film = new ObjectBuilder(ObjectKind.FILM, "hdrfilm", report.location(where));
        film.integer("width", Math.round(SHORTER_SIDE * Math.max(1, aspect)));
        film.integer("height", Math.round(SHORTER_SIDE * Math.max(1, 1 / aspect)));
        camera.nested(film.build());
    }
}
