package org.daybreak.bidirectional;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.render.SampleRecord;
import org.daybreak.core.render.SampleRecord.Outcome;
import org.daybreak.core.render.SampleRequest;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.EarlierSamples;
import org.daybreak.tracing.PixelSampling;
import org.daybreak.tracing.RaySample;
import org.jspecify.annotations.Nullable;

/**
 * Computes one sample as a render does and records its subpaths and what became of each technique (s, t). The roulette for tests of
 * occlusion learns from the samples before in the tile, so these are computed first, unless their numbers depend on the
 * whole image: then it leaves nothing out, and contributions are those before their division by the probability of survival.
 */
final class SampleTrace implements Contribution.Listener {
    private final Scene scene;
    private final TechniqueLimits limits;
    private final long maxVertices;
    private final boolean allLights;
    private final List<SampleRecord.Subpath> subpaths = new ArrayList<>();
    private final List<SampleRecord.Contribution> found = new ArrayList<>();

    private final List<LightPath> lightPaths = new ArrayList<>();
    private final List<EyePath> eyePaths = new ArrayList<>();

    /** An eye subpath: the number of vertices it shares with the first one, and whether its vertices can be joined. */
    private record EyePath(int shared, List<Boolean> connectable) {}

    /** A light subpath: its light, and whether its vertices can be joined. */
    private record LightPath(int light, List<Boolean> connectable) {}

    private SampleTrace(Scene scene, Camera camera, BidirectionalSettings settings) {
        this.scene = scene;
        limits = settings.limits(camera);
        maxVertices = settings.maxVertices();
        allLights = settings.allLights();
    }

    /** Computes a sample. */
    static SampleRecord of(Scene scene, Camera camera, BidirectionalSettings settings, SampleRequest request) {
        boolean efficiency = settings.roulette() == BidirectionalSettings.Roulette.EFFICIENCY;
        boolean known = request.antialiasing().allocation().isEmpty();
        SampleTrace trace = new SampleTrace(scene, camera, settings);
        ConnectionRoulette roulette = known ? settings.connectionRoulette() : new ConnectionRoulette(false);
        if (efficiency && known) {
            // Without a listener, as in the render: it has rays traced for contributions without weight.
            EarlierSamples.trace(request, new BiDirectionalProcessor(scene, camera, false, settings, null, roulette));
        }
        BiDirectionalProcessor processor = new BiDirectionalProcessor(scene, camera, false, settings, trace, roulette);
        PixelSampling position = PixelSampling.of(request);
        RaySample sample = new RaySample();
        Sampler sampler = position.start(request);
        boolean finite = processor.trace(position.filmX, position.filmY, sampler, sample, new SplatBuffer());
        List<String> notes = new ArrayList<>();
        if (efficiency && known) {
            notes.add(
                    "the roulette that leaves out occlusion tests is that of a render of the whole image which its number"
                            + " of samples ends: a crop, or a limit of time, has another; survivors are divided by their"
                            + " probability");
        } else if (efficiency) {
            notes.add(
                    "the roulette that leaves out occlusion tests depends on the samples before and is off here: in the"
                            + " render, small contributions may be missing, or divided by their probability of survival");
        }
        if (position.factor != 1) {
            notes.add("the film multiplies the radiance by " + position.factor + " (filter with negative lobes)");
        }
        if (!finite || !sample.radiance.isFinite()) {
            notes.add("the sample is infinite or not a number");
        }
        Map<String, Long> rays = new LinkedHashMap<>();
        for (RayKind kind : RayKind.values()) {
            rays.put(kind.name().toLowerCase(Locale.ROOT), processor.rays(kind));
        }
        return new SampleRecord(
                position.filmX,
                position.filmY,
                new SampleRecord.Color(sample.radiance.r, sample.radiance.g, sample.radiance.b),
                trace.subpaths,
                trace.contributions(),
                rays,
                notes);
    }

    @Override
    public void traced(PathValues path, int light) {
        List<Boolean> connectable = new ArrayList<>();
        List<SampleRecord.Vertex> vertices = new ArrayList<>();
        for (int i = 0; i < path.length(); i++) {
            connectable.add(path.connectable[i]);
            vertices.add(vertex(path, i, light < 0));
        }
        if (light < 0) {
            int number = eyePaths.size();
            int shared = number == 0 ? 0 : eyePaths.get(0).connectable.size();
            eyePaths.add(new EyePath(shared, connectable));
            subpaths.add(new SampleRecord.Subpath(
                    number == 0 ? "eye subpath 0" : "eye subpath " + number + ", a branch of 0",
                    vertices.subList(shared, vertices.size())));
        } else {
            lightPaths.add(new LightPath(light, connectable));
            subpaths.add(new SampleRecord.Subpath("subpath from " + lightName(light), vertices));
        }
    }

    private SampleRecord.Vertex vertex(PathValues path, int i, boolean eye) {
        SurfacePoint p = path.points[i];
        boolean lens = eye && i == 0;
        boolean source = !eye && i == 0;
        SampleRecord.Vector normal = lens
                ? new SampleRecord.Vector(0, 0, 0)
                : source ? new SampleRecord.Vector(p.gx, p.gy, p.gz) : new SampleRecord.Vector(p.nx, p.ny, p.nz);
        return new SampleRecord.Vertex(
                (eye ? "z" : "y") + i,
                lens ? "lens" : source ? lightName(path.light[0]) : surfaceName(path, i),
                new SampleRecord.Vector(p.x, p.y, p.z),
                normal,
                path.delta[i],
                path.connectable[i],
                new SampleRecord.Color(path.throughputR[i], path.throughputG[i], path.throughputB[i]),
                path.forward[i],
                i + 2 < path.length() ? path.reverse[i] : Double.NaN);
    }

    private String lightName(int light) {
        return "light " + light + " (" + scene.light(light).getClass().getSimpleName() + ")";
    }

    private static String surfaceName(PathValues path, int i) {
        String name = "shape " + path.points[i].shape + " ("
                + path.bsdfs[i].getClass().getSimpleName() + ")";
        return path.light[i] < 0 ? name : name + ", light " + path.light[i];
    }

    @Override
    public void found(Contribution c) {
        add(c, c.t <= 1 ? Outcome.SPLATTED : Outcome.ADDED);
    }

    @Override
    public void occluded(Contribution c) {
        add(c, Outcome.OCCLUDED);
    }

    @Override
    public void leftOut(Contribution c) {
        add(c, Outcome.ROULETTE);
    }

    private void add(Contribution c, Outcome outcome) {
        // An eye subpath meets lights while it is traced, and is joined afterwards.
        int eyePath = c.t <= 1 ? -1 : c.s == 0 ? eyePaths.size() : eyePaths.size() - 1;
        found.add(new SampleRecord.Contribution(
                c.s,
                c.t,
                eyePath,
                c.lightIndex,
                outcome,
                new SampleRecord.Color(c.r, c.g, c.b),
                c.weight,
                c.filmX,
                c.filmY));
    }

    /** What was found, and why there is nothing where nothing was. */
    private List<SampleRecord.Contribution> contributions() {
        int lightVertices = 1;
        for (LightPath path : lightPaths) {
            lightVertices = Math.max(lightVertices, path.connectable.size());
        }
        List<SampleRecord.Contribution> all = new ArrayList<>();
        for (int s = 0; s <= lightVertices + 1; s++) {
            if (s > 1 && limits.lensHits()) {
                addAll(s, 0, -1, all);
            }
            if (s > 0) {
                addAll(s, 1, -1, all);
            }
            for (int i = 0; i < eyePaths.size(); i++) {
                int last = eyePaths.get(i).connectable.size();
                for (int t = Math.max(2, eyePaths.get(i).shared + 1); t <= last; t++) {
                    addAll(s, t, i, all);
                }
                if (s == 0) {
                    // A subpath that left the scene had a vertex at infinity for a while.
                    addFound(s, Math.max(2, last + 1), i, null, all);
                }
            }
        }
        return all;
    }

    /** Adds what became of a technique with an eye subpath, or with none (-1). */
    private void addAll(int s, int t, int eyePath, List<SampleRecord.Contribution> all) {
        if (s == 0 || (s == 1 && t > 1 && !allLights)) {
            if (!addFound(s, t, eyePath, null, all)) {
                all.add(nothing(s, t, eyePath, null));
            }
            return;
        }
        for (LightPath path : lightPaths) {
            int longest = Math.max(1, path.connectable.size()) + (t == 0 ? 1 : 0);
            if (s <= longest && !addFound(s, t, eyePath, path, all)) {
                all.add(nothing(s, t, eyePath, path));
            }
        }
    }

    /**
     * Adds the contributions of a technique; false if there are none.
     *
     * @param path those with this light subpath only; null for all
     */
    private boolean addFound(int s, int t, int eyePath, @Nullable LightPath path, List<SampleRecord.Contribution> all) {
        int before = all.size();
        for (SampleRecord.Contribution c : found) {
            if (c.s() == s && c.t() == t && c.eyePath() == eyePath && (path == null || c.light() == path.light)) {
                all.add(c);
            }
        }
        return all.size() > before;
    }

    private SampleRecord.Contribution nothing(int s, int t, int eyePath, @Nullable LightPath path) {
        int light = path == null ? -1 : path.light;
        Outcome outcome = reason(s, t, eyePath, path);
        return new SampleRecord.Contribution(s, t, eyePath, light, outcome, SampleRecord.Color.BLACK, 0, 0, 0);
    }

    /** Why a technique has no contribution. */
    private Outcome reason(int s, int t, int eyePath, @Nullable LightPath path) {
        if (s + t > maxVertices || s > limits.maxLightVertices() || t > limits.maxEyeVertices()) {
            return Outcome.DEPTH;
        }
        if (t == 1 && !(s == 1 ? limits.emitterAtLens() : limits.lens())) {
            return Outcome.OFF;
        }
        boolean eyeDelta = s > 0 && t > 1 && !eyePaths.get(eyePath).connectable.get(t - 1);
        boolean lightDelta = path != null
                && t > 0
                && (s > 1
                        ? !path.connectable.get(s - 1)
                        : t == 1 && scene.light(path.light).isDelta());
        return eyeDelta || lightDelta ? Outcome.DELTA : Outcome.ZERO;
    }
}
