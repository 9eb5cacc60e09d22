package org.daybreak.metropolis.chains;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmLayer;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.Progress;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderListener;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.scene.Scene;
import org.daybreak.tracing.PathTracerFactory;

/**
 * Which paths are rendered apart from the chains, and how: those of at most two edges, by path tracing (thesis, section 5.4; Veach
 * 1997, §11.5), or these and what else samples take off the chains ({@link SamplePlan}). Immutable.
 */
final class DirectPart {
    private static final int EDGES = 2;

    /** An eye subpath of so many vertices can follow all paths of two edges: it meets the emitter behind a mirror. */
    private static final int EYE_VERTICES = 3;

    /** Seconds in which a virtual machine that has just started takes a first sample of each pixel, and what it needs for each. */
    private static final double LEAST_SECONDS = 0.3;

    private static final double SECONDS_PER_PIXEL = 3e-6;

    /** A limit that is over before the first sample, when the pilot has taken all the time. */
    private static final double NO_SECONDS = 1e-9;

    private final ChainSettings settings;
    private final int maxEyeDepth;
    private final int maxDepth;

    /**
     * Finds out.
     *
     * @param maxEyeDepth largest number of vertices of an eye subpath, -1 for no limit
     * @param maxDepth largest number of edges of a path, -1 for no limit
     */
    DirectPart(ChainSettings settings, int maxEyeDepth, int maxDepth) {
        this.settings = settings;
        this.maxEyeDepth = maxEyeDepth;
        this.maxDepth = maxDepth;
    }

    /** True if there is such a part. */
    boolean exists() {
        return settings.separateDirect() && !isImpossible();
    }

    /** True if there shall be such a part, but path tracing would find other paths than those that the limits of depth allow. */
    private boolean isImpossible() {
        return settings.separateDirect() && maxEyeDepth >= 0 && maxEyeDepth < EYE_VERTICES;
    }

    /** True if no paths are left for the chains. */
    boolean isAll() {
        return exists() && maxDepth >= 0 && maxDepth <= EDGES;
    }

    /** Smallest number of edges of the paths that are left for the chains. */
    int shortestOfChains() {
        return exists() ? EDGES + 1 : 1;
    }

    /** What the user should know if it is not rendered. */
    List<String> warnings(Film film) {
        List<String> warnings = new ArrayList<>();
        if (isImpossible()) {
            warnings.add("with maxEyeDepth below 3 path tracing finds other paths than the chains: direct lighting is"
                    + " not rendered apart");
        }
        if (!exists() && film.layers().stream().anyMatch(layer -> layer != FilmLayer.VARIANCE)) {
            warnings.add("without direct lighting apart no image samples are taken: the albedo, normal and depth images"
                    + " stay empty");
        }
        return warnings;
    }

    /** What renders it if samples take nothing else off the chains: path tracing. */
    Renderer pathTracer() {
        int edges = maxDepth >= 0 ? Math.min(EDGES, maxDepth) : EDGES;
        PathTracerFactory factory = new PathTracerFactory();
        Map<String, String> parameters = Map.of("maxDepth", Integer.toString(edges), "splitting", "1");
        return factory.create(ParameterValues.parse(factory.parameters(), parameters, factory.id()));
    }

    /** Its part of the time: all if there is nothing else, otherwise what a plan says, or the numbers of samples and mutations. */
    double timeShare(SamplePlan plan) {
        if (isAll()) {
            return 1;
        }
        return plan.timeShare() > 0 ? plan.timeShare() : settings.directShare();
    }

    /**
     * What renders this part.
     *
     * @param timeShare part of the time that is left for it
     * @param perPixel number of samples, if their number is limited
     * @param workShare part of all samples and steps
     */
    record Samples(Renderer renderer, double timeShare, int perPixel, double workShare) {}

    /**
     * Renders it.
     *
     * @param context of the whole render, with the state to go on from and the checkpoints of this part of it
     * @param secondsGone of the whole render
     */
    RenderReport render(
            Samples samples, Scene scene, Camera camera, Film film, RenderContext context, double secondsGone) {
        RenderBudget budget = budget(context.budget(), samples, secondsGone, film);
        return samples.renderer.render(
                scene,
                camera,
                film,
                new RenderContext(
                        context.seed(),
                        context.threads(),
                        budget,
                        context.antialiasing(),
                        context.cancellation(),
                        new Listener(context.listener(), context.budget().seconds() - secondsGone, samples.workShare),
                        context.part(),
                        context.start(),
                        context.checkpoints()));
    }

    /**
     * Of the time, this part may take its share, and of short times so much that each pixel should get a sample. Of the square of the error half is for it, so that the chains can bring the whole
     * below the target: as its own relative error is that of a darker image, this is on the safe side.
     */
    private RenderBudget budget(RenderBudget whole, Samples samples, double secondsGone, Film film) {
        boolean open = whole.samplesPerPixel() >= Integer.MAX_VALUE;
        double target = isAll() ? whole.targetError() : whole.targetError() * Math.sqrt(0.5);
        double left = Math.max(NO_SECONDS, whole.seconds() - secondsGone);
        double pixels = (double) film.settings().width() * film.settings().height();
        double least = LEAST_SECONDS + SECONDS_PER_PIXEL * pixels;
        double seconds = Math.max(left * samples.timeShare, Math.min(0.5 * left, least));
        return new RenderBudget(open ? Integer.MAX_VALUE : samples.perPixel, seconds, target);
    }

    /** Tells of this part's progress as a part of the whole. */
    private static final class Listener implements RenderListener {
        private final RenderListener whole;
        private final double seconds;
        private final double share;

        Listener(RenderListener whole, double seconds, double share) {
            this.whole = whole;
            this.seconds = seconds;
            this.share = share;
        }

        @Override
        public void progress(Progress p) {
            double fraction = p.fraction() * share;
            double left = seconds < Double.POSITIVE_INFINITY
                    ? seconds - p.secondsElapsed()
                    : p.secondsElapsed() * (1 - fraction) / fraction;
            whole.progress(new Progress(
                    fraction, p.samples(), p.samplesPerSecond(), p.secondsElapsed(), Math.max(0, left), Double.NaN));
        }

        @Override
        public void passFinished(Film film) {
            whole.passFinished(film);
        }
    }
}
