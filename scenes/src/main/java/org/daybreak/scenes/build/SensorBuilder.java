package org.daybreak.scenes.build;

import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.vecmath.Matrix4d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.jspecify.annotations.Nullable;

/** Builds camera and film. */
final class SensorBuilder {
    private static final Pattern FOCAL_LENGTH = Pattern.compile("\\s*(\\d{1,9}(?:\\.\\d{1,9})?)\\s*(?:mm)?\\s*");

    /** Diagonal of an image of 36 mm × 24 mm. */
    private static final double FILM_DIAGONAL = Math.sqrt(36 * 36 + 24 * 24);

    private final BuildContext context;

    SensorBuilder(BuildContext context) {
        this.context = context;
    }

    /** Builds a sensor into a scene. */
    void build(ObjectDescription object, SceneGraph graph) {
        Properties p = context.properties(object);
        if (p == null) {
            return;
        }
        CameraSettings camera = camera(p);
        if (camera != null) {
            graph.setCamera(camera);
        }
        FilmSettings film = film(p.child(ObjectKind.FILM));
        if (film != null) {
            graph.setFilm(film);
        }
    }

    private @Nullable CameraSettings camera(Properties p) {
        warnAboutClipping(p);
        Matrix4d toWorld = p.transform("to_world");
        String type = p.object().type();
        if (type.equals("orthographic")) {
            CameraSettings plain = CameraSettings.orthographic(toWorld);
            return new CameraSettings(
                    toWorld,
                    plain.projection(),
                    plain.fieldOfViewDegrees(),
                    plain.axis(),
                    0,
                    1,
                    0,
                    0,
                    p.number("pixel_aspect"));
        }
        boolean valid = true;
        if (!Affine.isRigid(toWorld)) {
            context.error(p.location("to_world"), "the transform of a camera must not scale or shear");
            valid = false;
        }
        if (type.equals("environment") || type.equals("spherical")) {
            return valid ? CameraSettings.environment(toWorld) : null;
        }
        double fov;
        CameraSettings.FovAxis axis = CameraSettings.FovAxis.DIAGONAL;
        if (p.mentions("fov")) {
            if (p.mentions("focal_length")) {
                context.error(p.location("focal_length"), "either 'fov' or 'focal_length' can be given, not both");
                valid = false;
            }
            fov = p.number("fov", 45);
            axis = CameraSettings.FovAxis.valueOf(p.text("fov_axis").toUpperCase(Locale.ROOT));
        } else {
            if (p.mentions("fov_axis")) {
                context.error(p.location("fov_axis"), "'fov_axis' has no meaning without 'fov'");
                valid = false;
            }
            Matcher matcher = FOCAL_LENGTH.matcher(p.text("focal_length"));
            double millimetres = matcher.matches() ? Double.parseDouble(matcher.group(1)) : 0;
            if (!(millimetres > 0)) {
                context.error(
                        p.location("focal_length"),
                        "'focal_length' must be a positive length like 50mm but is '" + p.text("focal_length") + "'");
                return null;
            }
            fov = 2 * Math.toDegrees(Math.atan(FILM_DIAGONAL / (2 * millimetres)));
        }
        if (!valid) {
            return null;
        }
        boolean lens = type.equals("thinlens");
        double aperture = lens ? p.number("aperture_radius", 0) : 0;
        double focus = lens ? p.number("focus_distance", p.number("far_clip")) : 1;
        return new CameraSettings(
                toWorld,
                CameraSettings.Projection.PERSPECTIVE,
                fov,
                axis,
                aperture,
                focus,
                p.number("principal_point_offset_x"),
                p.number("principal_point_offset_y"),
                p.number("pixel_aspect"));
    }

    private void warnAboutClipping(Properties p) {
        for (String name : new String[] {"near_clip", "far_clip"}) {
            if (p.has(name) && p.number(name) != (name.equals("near_clip") ? 0.01 : 10_000)) {
                context.warning(p.location(name), "'" + name + "' does not clip anything here");
            }
        }
    }

    private @Nullable FilmSettings film(Properties.@Nullable Child child) {
        if (child == null) {
            return new FilmSettings(768, 576, ReconstructionFilter.GAUSSIAN);
        }
        Properties p = context.properties(child.object());
        if (p == null) {
            return null;
        }
        ReconstructionFilter filter = filter(p.child(ObjectKind.RFILTER));
        int width = p.integer("width");
        int height = p.integer("height");
        FilmSettings.Crop crop = new FilmSettings.Crop(
                p.integer("crop_offset_x"), p.integer("crop_offset_y"), (int) p.number("crop_width", width), (int)
                        p.number("crop_height", height));
        if (filter == null) {
            return null;
        }
        try {
            return new FilmSettings(width, height, crop, filter, p.truth("filter_sampling"));
        } catch (IllegalArgumentException e) {
            context.error(p.location(), String.valueOf(e.getMessage()));
            return null;
        }
    }

    private @Nullable ReconstructionFilter filter(Properties.@Nullable Child child) {
        if (child == null) {
            return ReconstructionFilter.GAUSSIAN;
        }
        Properties p = context.properties(child.object());
        if (p == null) {
            return null;
        }
        switch (child.object().type()) {
            case "box" -> {
                return ReconstructionFilter.BOX;
            }
            case "tent" -> {
                return new ReconstructionFilter(ReconstructionFilter.Kind.TENT, p.number("radius"), 0);
            }
            case "gaussian" -> {
                double deviation = p.number("stddev");
                return new ReconstructionFilter(ReconstructionFilter.Kind.GAUSSIAN, 4 * deviation, deviation);
            }
            case "catmullrom" -> {
                return ReconstructionFilter.CATMULL_ROM;
            }
            case "lanczos" -> {
                return new ReconstructionFilter(ReconstructionFilter.Kind.LANCZOS, p.integer("lobes"), 0);
            }
            case "blackmanharris" -> {
                return new ReconstructionFilter(ReconstructionFilter.Kind.BLACKMAN_HARRIS, p.number("radius"), 0);
            }
            case "mitchell" -> {
                double b = p.number("B");
                double c = p.number("C");
                if (Math.abs(c - (1 - b) / 2) > 1e-6) {
                    context.error(
                            p.location("C"),
                            "only B and C with C = (1 - B) / 2 are supported but B = " + b + ", C = " + c);
                    return null;
                }
                return new ReconstructionFilter(ReconstructionFilter.Kind.MITCHELL, 2, b);
            }
            default ->
                throw new IllegalStateException(
                        "no builder for " + child.object().label());
        }
    }
}
