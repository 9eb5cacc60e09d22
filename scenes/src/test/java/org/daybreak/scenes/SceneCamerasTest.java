package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.image.StandardImageLoader;
import org.junit.jupiter.api.Test;

/** Cameras, films and what a scene file asks of the renderer. */
class SceneCamerasTest extends SceneReading {
    @Test
    void readsOtherCamerasAndFilters() throws IOException, SceneException {
        for (String[] row : new String[][] {
            {"orthographic", "<float name='pixel_aspect' value='2'/>", "lanczos", "ORTHOGRAPHIC", "LANCZOS"},
            {"environment", "", "blackmanharris", "ENVIRONMENT", "BLACKMAN_HARRIS"},
            {"spherical", "", "catmullrom", "ENVIRONMENT", "MITCHELL"},
            {"perspective", "<float name='principal_point_offset_x' value='0.2'/>", "tent", "PERSPECTIVE", "TENT"}
        }) {
            Path file = SceneTexts.write(
                    folder,
                    "camera.xml",
                    "<scene version='3.0.0'><sensor type='" + row[0] + "'>" + row[1]
                            + "<film type='hdrfilm'><boolean name='filter_sampling' value='true'/><rfilter type='"
                            + row[2]
                            + "'/></film></sensor></scene>");
            SceneFile scene = new SceneReader(new StandardImageLoader()).load(file, Map.of());
            CameraSettings camera = Objects.requireNonNull(scene.graph().camera());
            assertEquals(row[3], camera.projection().name());
            FilmSettings film = Objects.requireNonNull(scene.graph().film());
            assertEquals(row[4], film.filter().kind().name());
            assertTrue(film.filterSampling());
        }
    }

    @Test
    void readsCameraFilmAndRequests() throws IOException, SceneException {
        SceneFile file = SceneTexts.load(
                folder,
                "<scene version='3.0.0'>" + SceneTexts.LIGHT
                        + "<default name='spp' value='16'/><integrator type='ptracer'><integer name='max_depth' value='7'/>"
                        + "<integer name='rr_depth' value='9'/></integrator><sensor type='thinlens'>"
                        + "<float name='fov' value='30'/><string name='fov_axis' value='larger'/>"
                        + "<float name='aperture_radius' value='0.2'/><float name='focus_distance' value='5'/>"
                        + "<float name='near_clip' value='0.1'/>"
                        + "<sampler type='multijitter'><integer name='sample_count' value='$spp'/><integer name='seed' value='12'/></sampler>"
                        + "<film type='hdrfilm'><integer name='width' value='40'/><integer name='height' value='30'/>"
                        + "<integer name='crop_offset_y' value='10'/><integer name='crop_height' value='5'/>"
                        + "<rfilter type='gaussian'><float name='stddev' value='0.4'/></rfilter></film></sensor></scene>");
        CameraSettings camera = file.graph().camera();
        assertNotNull(camera);
        assertEquals(30, camera.fieldOfViewDegrees());
        assertEquals(CameraSettings.FovAxis.LARGER, camera.axis());
        assertEquals(0.2, camera.apertureRadius());
        assertEquals(5, camera.focusDistance());
        assertEquals(
                new FilmSettings(
                        40,
                        30,
                        new FilmSettings.Crop(0, 10, 40, 5),
                        new ReconstructionFilter(ReconstructionFilter.Kind.GAUSSIAN, 1.6, 0.4)),
                file.graph().film());
        assertEquals(Optional.of("light"), file.request().rendererId());
        assertEquals(Map.of("maxDepth", "7", "rrDepth", "9"), file.request().parameters());
        assertEquals(OptionalInt.of(16), file.request().samplesPerPixel());
        assertEquals(OptionalLong.of(12), file.request().seed());
        assertEquals(1, file.warnings().size());
        assertTrue(file.warnings().get(0).message().contains("near_clip"));
    }

    @Test
    void defaultsAreThoseOfMitsuba() throws IOException, SceneException {
        SceneFile file = SceneTexts.load(
                folder, "<scene version='3.0.0'>" + SceneTexts.LIGHT + "<sensor type='perspective'/></scene>");
        assertEquals(
                new FilmSettings(768, 576, ReconstructionFilter.GAUSSIAN),
                file.graph().film());
        CameraSettings camera = file.graph().camera();
        assertNotNull(camera);
        assertEquals(CameraSettings.FovAxis.DIAGONAL, camera.axis());
        // 50 mm; Mitsuba 3.9.1 says 38.1848 degrees across 768 of 768 x 576.
        double x = 2 * Math.toDegrees(Math.atan(0.8 * Math.tan(Math.toRadians(camera.fieldOfViewDegrees() / 2))));
        assertEquals(38.1848, x, 1e-4);
        assertEquals(Optional.empty(), file.request().rendererId());
        assertEquals(OptionalInt.empty(), file.request().samplesPerPixel());
        assertTrue(file.request().parameters().isEmpty());
    }

    @Test
    void readsFilters() throws IOException, SceneException {
        assertEquals(ReconstructionFilter.BOX, filter("<rfilter type='box'/>"));
        assertEquals(ReconstructionFilter.TENT, filter("<rfilter type='tent'/>"));
        assertEquals(ReconstructionFilter.GAUSSIAN, filter("<rfilter type='gaussian'/>"));
        assertEquals(ReconstructionFilter.MITCHELL, filter("<rfilter type='mitchell'/>"));
        assertEquals(
                new ReconstructionFilter(ReconstructionFilter.Kind.MITCHELL, 2, 0),
                filter("<rfilter type='catmullrom'/>"));
    }

    private ReconstructionFilter filter(String rfilter) throws IOException, SceneException {
        FilmSettings film = SceneTexts.load(
                        folder,
                        "<scene version='3.0.0'>" + SceneTexts.LIGHT
                                + "<sensor type='perspective'><film type='hdrfilm'>" + rfilter
                                + "</film></sensor></scene>")
                .graph()
                .film();
        assertNotNull(film);
        return film.filter();
    }
}
