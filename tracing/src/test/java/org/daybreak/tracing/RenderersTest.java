package org.daybreak.tracing;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.atomic.AtomicInteger;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.film.FilmLayer;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.render.CancellationToken;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.Progress;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderListener;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.testing.Allocation;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The life of a render: threads, budgets, cancellation, reports. */
@Timeout(120)
final class RenderersTest {
    @ParameterizedTest
    @ValueSource(strings = {"path", "raytracer", "light"})
    void theImageDoesNotDependOnTheNumberOfThreads(String id) {
        Scene scene = TestScenes.diffuseRoom(70, 45, ReconstructionFilter.MITCHELL);
        Set<FilmLayer> layers = EnumSet.allOf(FilmLayer.class);
        FilmImage first = null;
        for (int threads : new int[] {1, 2, 3, 8}) {
            Film film = new Film(scene.film(), layers);
            RenderReport report = Rendering.renderer(id, Map.of())
                    .render(scene, scene.camera(), film, Rendering.context(5, threads, RenderBudget.samples(6)));
            assertEquals(6L * 70 * 45, report.samples());
            assertEquals(6, report.samplesPerPixel());
            FilmImage image = film.develop();
            if (first == null) {
                first = image;
            }
            for (String channel : image.channelNames()) {
                assertArrayEquals(first.channel(channel), image.channel(channel), channel + " with " + threads);
            }
        }
        assertTrue(first != null && first.mean("G") > 0);
    }

    @ParameterizedTest
    @ValueSource(strings = {"path", "light"})
    void aCropIsPartOfTheWhole(String id) {
        Scene scene = TestScenes.diffuseRoom(40, 30, ReconstructionFilter.BOX);
        FilmImage whole = Rendering.image(Rendering.renderer(id, Map.of()), scene, 3, 2);
        FilmSettings settings = new FilmSettings(40, 30, new FilmSettings.Crop(7, 9, 20, 11), ReconstructionFilter.BOX);
        Film film = new Film(settings);
        Rendering.renderer(id, Map.of())
                .render(scene, scene.camera(), film, Rendering.context(3, 1, RenderBudget.samples(2)));
        FilmImage part = film.develop();
        for (int x = 0; x < 20; x++) {
            for (int y = 0; y < 11; y++) {
                assertEquals(whole.get("R", 7 + x, 9 + y), part.get("R", x, y));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(strings = {"path", "raytracer", "light"})
    void cancellationIsPromptAndLeavesAValidImage(String id) {
        Scene scene = TestScenes.cornell(64, 36);
        Film film = new Film(scene.film());
        CancellationToken token = new CancellationToken();
        long[] cancelledAt = new long[1];
        RenderListener listener = new RenderListener() {
            @Override
            public void passFinished(Film f) {
                assertSame(film, f);
                f.develop();
                cancelledAt[0] = System.nanoTime();
                token.cancel();
            }
        };
        RenderReport report = Rendering.renderer(id, Map.of())
                .render(
                        scene,
                        scene.camera(),
                        film,
                        Rendering.context(1, 2, RenderBudget.samples(Integer.MAX_VALUE), token, listener));
        double seconds = (System.nanoTime() - cancelledAt[0]) * 1e-9;
        assertTrue(report.cancelled());
        assertTrue(report.samples() >= 64 * 36 && report.samplesPerPixel() >= 1);
        // Milliseconds on an idle machine.
        assertTrue(seconds < 5, "took " + seconds + " s to stop");
        assertTrue(film.develop().mean("G") > 0);
    }

    @ParameterizedTest
    @ValueSource(strings = {"path", "raytracer", "light"})
    void theTimeLimitIsKept(String id) {
        Scene scene = TestScenes.cornell(64, 36);
        Film film = new Film(scene.film());
        List<Progress> reports = new ArrayList<>();
        RenderListener listener = new RenderListener() {
            @Override
            public void progress(Progress progress) {
                reports.add(progress);
            }
        };
        long start = System.nanoTime();
        RenderReport report = Rendering.renderer(id, Map.of())
                .render(
                        scene,
                        scene.camera(),
                        film,
                        Rendering.context(1, 2, RenderBudget.seconds(1), new CancellationToken(), listener));
        double seconds = (System.nanoTime() - start) * 1e-9;
        assertFalse(report.cancelled());
        assertTrue(seconds >= 1);
        // A few milliseconds more on an idle machine.
        assertTrue(seconds < 3, "took " + seconds + " s");
        assertEquals(
                seconds,
                report.secondsByPhase().get("prepare") + report.secondsByPhase().get("render"),
                0.5);
        Progress last = reports.get(reports.size() - 1);
        assertEquals(1, last.fraction());
        assertEquals(report.samples(), last.samples());
        assertEquals(0, last.secondsLeft());
        for (int i = 1; i < reports.size(); i++) {
            assertTrue(reports.get(i).fraction() >= reports.get(i - 1).fraction());
            assertTrue(reports.get(i).samples() >= reports.get(i - 1).samples());
        }
    }

    @Test
    void theTargetErrorEndsTheRender() {
        Scene scene = TestScenes.diffuseRoom(24, 16, ReconstructionFilter.BOX);
        Film film = new Film(scene.film());
        RenderReport report = Rendering.renderer("path", Map.of())
                .render(scene, scene.camera(), film, Rendering.context(1, 2, new RenderBudget(1_000_000, 60, 0.1)));
        assertFalse(report.cancelled());
        assertTrue(report.samplesPerPixel() < 1_000_000);
        assertTrue(film.relativeError() < 0.1 && film.relativeError() > 0.001);
    }

    @Test
    void anInterruptIsACancellation() {
        Scene scene = TestScenes.cornell(32, 18);
        Film film = new Film(scene.film());
        Thread.currentThread().interrupt();
        RenderReport report = Rendering.renderer("path", Map.of())
                .render(scene, scene.camera(), film, Rendering.context(1, 2, RenderBudget.samples(Integer.MAX_VALUE)));
        assertTrue(Thread.interrupted());
        assertTrue(report.cancelled());
    }

    @Test
    void aFailingListenerEndsTheRender() {
        Scene scene = TestScenes.cornell(32, 18);
        RenderListener listener = new RenderListener() {
            @Override
            public void passFinished(Film film) {
                throw new IllegalStateException("listener");
            }
        };
        assertThrows(
                IllegalStateException.class,
                () -> Rendering.renderer("path", Map.of())
                        .render(
                                scene,
                                scene.camera(),
                                new Film(scene.film()),
                                Rendering.context(
                                        1,
                                        2,
                                        RenderBudget.samples(Integer.MAX_VALUE),
                                        new CancellationToken(),
                                        listener)));
    }

    @Test
    void everyPassIsAnnouncedFromTheCallersThread() {
        Scene scene = TestScenes.diffuseRoom(16, 16, ReconstructionFilter.BOX);
        Thread caller = Thread.currentThread();
        AtomicInteger passes = new AtomicInteger();
        RenderListener listener = new RenderListener() {
            @Override
            public void passFinished(Film film) {
                assertSame(caller, Thread.currentThread());
                passes.incrementAndGet();
            }
        };
        Rendering.renderer("path", Map.of())
                .render(
                        scene,
                        scene.camera(),
                        new Film(scene.film()),
                        Rendering.context(1, 2, RenderBudget.samples(1), new CancellationToken(), listener));
        assertEquals(1, passes.get());
    }

    @Test
    void raysAreCounted() {
        Scene scene = TestScenes.furnaceSphere(0.5, 8);
        RenderReport report = Rendering.renderer("path", Map.of("maxDepth", "2", "splitting", "1"))
                .render(
                        scene,
                        scene.camera(),
                        new Film(scene.film()),
                        Rendering.context(1, 3, RenderBudget.samples(4)));
        assertEquals(
                List.of("camera", "light", "scattered", "shadow"),
                List.copyOf(report.raysByKind().keySet()));
        assertEquals(8L * 8 * 4, report.raysByKind().get("camera"));
        long scattered = report.raysByKind().get("scattered");
        assertTrue(scattered > 0 && scattered < 8 * 8 * 4);
        assertTrue(report.raysByKind().get("shadow") <= scattered);
        assertEquals(0, report.raysByKind().get("light"));
    }

    @Test
    void nonFiniteSamplesAreReportedWithTheirAddress() {
        Scene scene = TestScenes.furnaceSphere(0.5, 8);
        Film film = new Film(scene.film());
        Renderer renderer = new PixelwiseRenderer("broken", (s, camera, features) -> new RayProcessor() {
            @Override
            public boolean trace(double x, double y, Sampler sampler, RaySample out, SplatBuffer splats) {
                double value = x > 3 && x < 4 && y > 5 && y < 6 ? Double.NaN : 2;
                out.radiance.set(value, value, value);
                return true;
            }

            @Override
            public long rays(org.daybreak.core.scene.RayKind kind) {
                return 0;
            }
        });
        RenderReport report =
                renderer.render(scene, scene.camera(), film, Rendering.context(9, 2, RenderBudget.samples(2)));
        assertEquals(2, report.nonFiniteSamples());
        assertEquals(
                List.of("seed 9, pixel (3, 5), sample 0", "seed 9, pixel (3, 5), sample 1"),
                report.nonFiniteAddresses());
        assertEquals(0, film.develop().get("R", 3, 5));
        assertEquals(2, film.develop().get("R", 4, 5));
    }

    @Test
    void featuresShowTheFirstSurfaceBehindVeils() {
        Scene scene = TestScenes.furnaceSphere(0.25, 9);
        Film film = new Film(scene.film(), EnumSet.of(FilmLayer.ALBEDO, FilmLayer.NORMAL, FilmLayer.DEPTH));
        Rendering.renderer("path", Map.of())
                .render(scene, scene.camera(), film, Rendering.context(1, 1, RenderBudget.samples(16)));
        FilmImage image = film.develop();
        assertEquals(0.25, image.get("albedo.G", 4, 4), 1e-6);
        assertEquals(1, image.get("normal.Z", 4, 4), 0.02);
        assertEquals(3, image.get("depth.Z", 4, 4), 0.05);
        assertEquals(0, image.get("albedo.G", 0, 0));
        assertEquals(0, image.get("depth.Z", 0, 0));
    }

    @Test
    void lightTracingSaysWhatItCannotShow() {
        Scene scene = TestScenes.cornell(16, 9);
        RenderReport report = Rendering.renderer("light", Map.of())
                .render(
                        scene,
                        scene.camera(),
                        new Film(scene.film(), EnumSet.of(FilmLayer.DEPTH)),
                        Rendering.context(1, 1, RenderBudget.samples(1)));
        assertEquals(2, report.warnings().size());
        assertTrue(report.warnings().get(1).contains("mirrors and glass"));
    }

    @Test
    void aFilmOfAnotherSizeIsRefused() {
        Scene scene = TestScenes.cornell(16, 9);
        Film film = new Film(new FilmSettings(16, 10, ReconstructionFilter.BOX));
        ParameterException e = assertThrows(
                ParameterException.class,
                () -> Rendering.renderer("path", Map.of())
                        .render(scene, scene.camera(), film, Rendering.context(1, 1, RenderBudget.samples(1))));
        assertEquals("the camera is made for 16x9 pixels but the film has 16x10", e.getMessage());
    }

    /** After warming up, paths of each kind are traced without allocation; the limit is 1 byte per path. */
    @Test
    void pathsAllocateNothing() {
        Scene scene = TestScenes.veiledRoom(40, 30);
        Sampler sampler = new SobolSampling().newSampler(1, 64);
        RaySample sample = new RaySample();
        SplatBuffer splats = new SplatBuffer();
        RayProcessor[] processors = {
            new PathTracer(scene, scene.camera(), true, new PathTracerSettings(-1, 5, 4)),
            new ClassicRayTracer(scene, scene.camera(), true, new ClassicRayTracerSettings(10))
        };
        LightTracer light = new LightTracer(scene, scene.camera(), 1, new LightTracerSettings(-1, 5));
        int lightPaths = 40 * 30 * 8;
        Allocation.assertNone("path", lightPaths * (processors.length + 1), 40, () -> {
            for (int i = 0; i < lightPaths; i++) {
                for (RayProcessor processor : processors) {
                    sampler.start(i / 8, i % 8);
                    int column = i / 8 % 40;
                    int row = i / 8 / 40;
                    double x = column + sampler.next();
                    double y = row + sampler.next();
                    splats.clear();
                    processor.trace(x, y, sampler, sample, splats);
                }
                light.trace(i, splats);
            }
        });
    }
}
