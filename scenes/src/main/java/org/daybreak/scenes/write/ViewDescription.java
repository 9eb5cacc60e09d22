package org.daybreak.scenes.write;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.vecmath.Matrix4d;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.daybreak.scenes.view.AutoView;

/** Describes the camera and light that {@link AutoView} adds, which no file says anything about. */
final class ViewDescription {
    private ViewDescription() {}

    /**
     * The objects to be added to the scene.
     *
     * @param film of the camera
     * @param location the file that lacks them
     * @throws IOException if the light's image cannot be encoded
     */
    static List<PropertyDescription> of(
            AutoView.Additions additions, FilmSettings film, SourceLocation location, PanoramaEncoder panoramas)
            throws IOException {
        List<PropertyDescription> objects = new ArrayList<>();
        CameraSettings camera = additions.camera();
        if (camera != null) {
            objects.add(new PropertyDescription("", sensor(camera, film, location), location));
        }
        LightNode light = additions.light();
        if (light != null) {
            objects.add(new PropertyDescription("", environment(light, location, panoramas), location));
        }
        return objects;
    }

    private static Value sensor(CameraSettings camera, FilmSettings film, SourceLocation location) {
        Value image = nested(
                ObjectKind.FILM,
                "hdrfilm",
                location,
                property("width", new Value.WholeNumber(film.width()), location),
                property("height", new Value.WholeNumber(film.height()), location));
        return nested(
                ObjectKind.SENSOR,
                "perspective",
                location,
                property("fov", new Value.RealNumber(camera.fieldOfViewDegrees()), location),
                property("fov_axis", new Value.Text(camera.axis().name().toLowerCase(Locale.ROOT)), location),
                transform(camera.toWorld(), location),
                property("", image, location));
    }

    private static Value environment(LightNode light, SourceLocation location, PanoramaEncoder panoramas)
            throws IOException {
        if (!(light.source() instanceof LightSource.ImageEnvironment source)) {
            throw new IllegalArgumentException("the light of a view must be an image all around");
        }
        return nested(
                ObjectKind.EMITTER,
                "envmap",
                location,
                property("filename", new Value.Content("light", "exr", panoramas.encode(source.image())), location),
                property("scale", new Value.RealNumber(source.scale()), location),
                transform(light.transform(), location));
    }

    private static PropertyDescription transform(Matrix4d toWorld, SourceLocation location) {
        return property("to_world", new Value.Transform(toWorld), location);
    }

    private static PropertyDescription property(String name, Value value, SourceLocation location) {
        return new PropertyDescription(name, value, location);
    }

    private static Value nested(
            ObjectKind kind, String type, SourceLocation location, PropertyDescription... properties) {
        return new Value.Nested(new ObjectDescription(kind, type, null, location, List.of(properties)));
    }
}
