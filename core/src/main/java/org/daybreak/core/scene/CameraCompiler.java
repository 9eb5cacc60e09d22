package org.daybreak.core.scene;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.camera.PerspectiveCamera;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.math.Transform;

/** Turns camera descriptions into cameras. */
final class CameraCompiler {
    private CameraCompiler() {}

    static Camera camera(CameraSettings settings, FilmSettings film) {
        int width = film.width();
        int height = film.height();
        double extent = switch (settings.axis()) {
            case X -> width;
            case Y -> height;
            case SMALLER -> Math.min(width, height);
            case LARGER -> Math.max(width, height);
            case DIAGONAL -> Math.hypot(width, height);
        };
        return new PerspectiveCamera(
                Transform.of(settings.toWorld()),
                PerspectiveCamera.tanHalfWidth(settings.fieldOfViewDegrees(), extent, width),
                width,
                height,
                settings.apertureRadius(),
                settings.focusDistance());
    }
}
