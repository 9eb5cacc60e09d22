package org.daybreak.core.scene;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.EnvironmentCamera;
import org.daybreak.core.camera.OrthographicCamera;
import org.daybreak.core.camera.PerspectiveCamera;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.math.Transform;

/** Turns camera descriptions into cameras. */
final class CameraCompiler {
    private CameraCompiler() {}

    static Camera camera(CameraSettings settings, FilmSettings film) {
        int width = film.width();
        int height = film.height();
        Transform toWorld = Transform.of(settings.toWorld());
        return switch (settings.projection()) {
            case PERSPECTIVE -> perspective(settings, toWorld, width, height);
            case ORTHOGRAPHIC -> new OrthographicCamera(toWorld, width, height, settings.pixelAspect());
            case ENVIRONMENT -> new EnvironmentCamera(toWorld, width, height);
        };
    }

    private static Camera perspective(CameraSettings settings, Transform toWorld, int width, int height) {
        // In heights of a pixel.
        double across = width * settings.pixelAspect();
        double extent = switch (settings.axis()) {
            case X -> across;
            case Y -> height;
            case SMALLER -> Math.min(across, height);
            case LARGER -> Math.max(across, height);
            case DIAGONAL -> Math.hypot(across, height);
        };
        double perExtent = Math.tan(Math.toRadians(0.5 * settings.fieldOfViewDegrees())) / extent;
        return new PerspectiveCamera(
                toWorld,
                perExtent * across,
                perExtent * height,
                width,
                height,
                settings.apertureRadius(),
                settings.focusDistance(),
                settings.shiftX(),
                settings.shiftY());
    }
}
