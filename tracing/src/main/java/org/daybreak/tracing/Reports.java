package org.daybreak.tracing;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.function.ToLongBiFunction;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.scene.RayKind;

/** What renderers have in common before and after the work. */
public final class Reports {
    private Reports() {}

    /**
     * Checks that a film belongs to a camera.
     *
     * @throws ParameterException if their sizes differ
     */
    public static void checkFilm(Camera camera, Film film) {
        FilmSettings settings = film.settings();
        if (camera.width() != settings.width() || camera.height() != settings.height()) {
            throw new ParameterException("the camera is made for " + camera.width() + "x" + camera.height()
                    + " pixels but the film has " + settings.width() + "x" + settings.height());
        }
    }

    /** True if somebody asked for the end of the render: by the token, or by interrupting the calling thread. */
    public static boolean cancelled(RenderContext context) {
        return context.cancellation().isCancelled() || Thread.currentThread().isInterrupted();
    }

    /** Wall-clock seconds by phase. */
    public static Map<String, Double> phases(double preparedAt, double end) {
        Map<String, Double> seconds = new LinkedHashMap<>();
        seconds.put("prepare", preparedAt);
        seconds.put("render", end - preparedAt);
        return seconds;
    }

    /** Sums over workers of the rays traced, by the name of their kind. */
    public static <W> Map<String, Long> raysByKind(List<W> workers, ToLongBiFunction<W, RayKind> count) {
        Map<String, Long> rays = new LinkedHashMap<>();
        for (RayKind kind : RayKind.values()) {
            long sum = 0;
            for (W worker : workers) {
                sum += count.applyAsLong(worker, kind);
            }
            rays.put(kind.name().toLowerCase(Locale.ROOT), sum);
        }
        return rays;
    }
}
