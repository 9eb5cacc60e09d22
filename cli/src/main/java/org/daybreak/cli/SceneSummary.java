package org.daybreak.cli;

import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.TreeMap;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.Group;
import org.daybreak.core.scene.Instance;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.Node;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.scenes.SceneFile;
import org.daybreak.scenes.build.RenderSettingsRequest;

/** Counts what is in a scene. */
final class SceneSummary {
    private final IdentityHashMap<Bsdf, Boolean> materials = new IdentityHashMap<>();
    private final IdentityHashMap<Group, Long> trianglesShown = new IdentityHashMap<>();
    private final Map<String, Long> shapes = new TreeMap<>();
    private final Map<String, Long> lights = new TreeMap<>();
    private final Map<String, Long> materialKinds = new TreeMap<>();
    private long instances;
    private long trianglesStored;

    private SceneSummary() {}

    /** Names and values in the order in which they should be shown. */
    static Map<String, String> of(SceneFile file, Scene compiled) {
        SceneSummary summary = new SceneSummary();
        long shown = summary.visit(file.graph().root());
        for (Bsdf material : summary.materials.keySet()) {
            summary.materialKinds.merge(kind(material), 1L, Long::sum);
        }
        Map<String, String> lines = new LinkedHashMap<>();
        lines.put("shapes", counts(summary.shapes));
        lines.put("triangles", summary.trianglesStored + " stored, " + shown + " shown");
        lines.put("instances", Long.toString(summary.instances));
        lines.put("lights", counts(summary.lights) + "; " + compiled.lightCount() + " in the compiled scene");
        lines.put("materials", counts(summary.materialKinds));
        lines.put("bounds", bounds(compiled.bounds()));
        camera(file.graph().camera(), lines);
        film(compiled.film(), lines);
        request(file.request(), lines);
        lines.put("index", compiled.intersector().describe());
        // Prototypes have indices of their own, which a compiled scene does not show.
        lines.put(
                summary.instances == 0 ? "index memory" : "top-level index",
                String.format(Locale.ROOT, "%.3f MB", compiled.intersector().memoryBytes() * 1e-6));
        return lines;
    }

    /** Counts what is below a group, each group once, and returns the triangles that it shows with all its instances. */
    private long visit(Group group) {
        Long known = trianglesShown.get(group);
        if (known != null) {
            return known;
        }
        long shown = 0;
        for (Node child : group.children()) {
            if (child instanceof Group inner) {
                shown += visit(inner);
            } else if (child instanceof Instance instance) {
                instances++;
                shown += visit(instance.prototype());
            } else if (child instanceof ShapeNode shape) {
                shown += visit(shape);
            } else if (child instanceof LightNode light) {
                lights.merge(kind(light.source()), 1L, Long::sum);
            }
        }
        trianglesShown.put(group, shown);
        return shown;
    }

    private long visit(ShapeNode shape) {
        shapes.merge(kind(shape.shape()), 1L, Long::sum);
        materials.put(shape.material(), true);
        if (shape.radiance() != null) {
            lights.merge("Area", 1L, Long::sum);
        }
        if (shape.shape() instanceof TriangleMesh mesh) {
            trianglesStored += mesh.triangleCount();
            return mesh.triangleCount();
        }
        return 0;
    }

    private static void camera(@org.jspecify.annotations.Nullable CameraSettings camera, Map<String, String> lines) {
        if (camera != null && camera.projection() != CameraSettings.Projection.PERSPECTIVE) {
            lines.put("camera", camera.projection().name().toLowerCase(Locale.ROOT));
        } else if (camera != null) {
            String lens = camera.apertureRadius() == 0
                    ? "pinhole"
                    : "thin lens of radius " + camera.apertureRadius() + " focused at " + camera.focusDistance();
            lines.put(
                    "camera",
                    String.format(
                            Locale.ROOT,
                            "%s, field of view %.4g degrees (%s)",
                            lens,
                            camera.fieldOfViewDegrees(),
                            camera.axis().name().toLowerCase(Locale.ROOT)));
        }
    }

    private static void film(FilmSettings film, Map<String, String> lines) {
        lines.put(
                "film",
                film.width() + "x" + film.height() + ", crop " + film.crop() + ", filter "
                        + film.filter().kind().id() + " of radius "
                        + film.filter().radius());
    }

    private static void request(RenderSettingsRequest request, Map<String, String> lines) {
        StringBuilder text = new StringBuilder(request.rendererId().orElse("none named"));
        request.parameters()
                .forEach((name, value) ->
                        text.append(", ").append(name).append('=').append(value));
        request.samplesPerPixel()
                .ifPresent(samples -> text.append(", ").append(samples).append(" samples per pixel"));
        lines.put("renderer", text.toString());
    }

    private static String bounds(Bounds bounds) {
        return bounds.minX() > bounds.maxX()
                ? "empty"
                : String.format(
                        Locale.ROOT,
                        "(%.4g, %.4g, %.4g) to (%.4g, %.4g, %.4g)",
                        bounds.minX(),
                        bounds.minY(),
                        bounds.minZ(),
                        bounds.maxX(),
                        bounds.maxY(),
                        bounds.maxZ());
    }

    private static String counts(Map<String, Long> counts) {
        long total = 0;
        StringBuilder text = new StringBuilder();
        for (Map.Entry<String, Long> entry : counts.entrySet()) {
            total += entry.getValue();
            text.append(text.isEmpty() ? " (" : ", ")
                    .append(entry.getValue())
                    .append(' ')
                    .append(entry.getKey());
        }
        return total + (text.isEmpty() ? "" : text.append(')').toString());
    }

    /** Class names of the scene API are the names of what they stand for: TriangleMesh, RoughConductor. */
    private static String kind(Object thing) {
        return thing.getClass().getSimpleName();
    }
}
