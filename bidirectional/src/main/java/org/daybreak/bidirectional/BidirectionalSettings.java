package org.daybreak.bidirectional;

import java.util.ArrayList;
import java.util.List;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.ParameterValues;

/**
 * Settings of bidirectional path tracing.
 *
 * @param maxEyeDepth largest number of vertices of an eye subpath, the one on the lens included; -1 for no limit
 * @param maxLightDepth largest number of vertices of a light subpath, the one on the light included; -1 for no limit
 * @param maxDepth largest number of edges of a full path; -1 for no limit
 * @param heuristicExponent β of the heuristic
 * @param roulette where Russian roulette is played
 * @param rrDepth Russian roulette may end a subpath from this number of edges on
 * @param splitting number of ways in which an eye subpath goes on from the first surface that scatters diffusely
 * @param allLights whether each sample has a light subpath and a light sample for every light, or for one that is chosen
 * @param causticMap whether light subpaths are joined to the lens
 * @param causticMapShare as how many samples a light subpath joined to the lens counts in the weights, in (0, 1]
 * @param lensHits whether light subpaths count that hit a lens with an area
 * @param minDepth smallest number of edges of the full paths that count: shorter ones are left out, which does not change the weights
 *     of the others
 */
public record BidirectionalSettings(
        int maxEyeDepth,
        int maxLightDepth,
        int maxDepth,
        double heuristicExponent,
        Roulette roulette,
        int rrDepth,
        int splitting,
        boolean allLights,
        boolean causticMap,
        double causticMapShare,
        boolean lensHits,
        int minDepth) {
    /** Where Russian roulette is played. */
    public enum Roulette {
        /** Nowhere: the limits of depth end paths. */
        NONE,
        /** Subpaths end in proportion to their throughput. */
        THROUGHPUT,
        /** And occlusion tests of small contributions are left out: {@link ConnectionRoulette}. */
        EFFICIENCY
    }

    private static final int DEFAULT_SPLITTING = 2;

    private static final List<Parameter> PATHS = List.of(
            depth(
                    "maxEyeDepth",
                    "Max. eye path depth",
                    "Largest number of vertices of an eye path, the one on the lens included: 1 shows only what light"
                            + " paths bring to the lens; -1 for no limit."),
            depth(
                    "maxLightDepth",
                    "Max. light path depth",
                    "Largest number of vertices of a light path, the one on the light included: 1 behaves as path"
                            + " tracing; -1 for no limit."),
            depth(
                    "maxDepth",
                    "Recursion depth",
                    "Largest number of edges of a full path: 1 shows emitters only, 2 adds direct light, and so on; -1"
                            + " for no limit."),
            Parameter.real(
                    "heuristicExponent",
                    "Heuristic exponent",
                    2,
                    0,
                    1000,
                    "Exponent β of the heuristic that weights the ways to make a path: 0 for equal weights, 1 for the"
                            + " balance heuristic, 2 for the power heuristic. Does not change the mean."));

    private static final Parameter RR_DEPTH = Parameter.integer(
            "rrDepth",
            "Russian roulette from depth",
            3,
            1,
            Integer.MAX_VALUE,
            "Number of edges from which on a subpath may be ended at random. Does not change the mean.");

    private static final Parameter CAUSTIC_MAP = Parameter.flag(
            "causticMap",
            "Caustic map",
            true,
            "Whether light paths are joined to the lens, which finds caustics and what else light paths bring"
                    + " there. Without, light that no other way finds is missing.");

    /** The parameters from which the settings are made. */
    static final List<Parameter> PARAMETERS = joined(
            PATHS,
            Parameter.choice(
                    "russianRoulette",
                    "Russian roulette",
                    "efficiency",
                    List.of("none", "throughput", "efficiency"),
                    "none: limits of depth alone end paths; throughput: paths end in proportion to what they can still"
                            + " contribute; efficiency: besides, occlusion tests of small contributions are left out at"
                            + " random. Does not change the mean."),
            RR_DEPTH,
            Parameter.integer(
                    "splitting",
                    "Eye paths from the first diffuse surface",
                    DEFAULT_SPLITTING,
                    1,
                    1024,
                    "Number of ways in which an eye path goes on from the first surface that scatters diffusely. More help"
                            + " where mirrors show caustics, which light paths cannot bring to the lens. With"
                            + " lightsPerPath all it is 1. Does not change the mean."),
            Parameter.choice(
                    "lightsPerPath",
                    "Light paths per sample",
                    "one",
                    List.of("one", "all"),
                    "one: a light is chosen by its power for the light path, and by its effect for each light sample;"
                            + " all: every light gets a light path and a light sample. Does not change the mean."),
            CAUSTIC_MAP,
            Parameter.real(
                    "causticMapShare",
                    "Share of the caustic map",
                    0.25,
                    1e-3,
                    1,
                    "As how many samples a light path at the lens counts in the weights. Each pixel has eye paths of its"
                            + " own, while light paths fall where they will, which a comparison of densities does not"
                            + " see; 1 is that comparison. Does not change the mean."),
            Parameter.flag(
                    "lensHits",
                    "Light paths that hit the lens",
                    false,
                    "Whether light paths count that hit a lens with an area by themselves: more help where a wide lens sees"
                            + " caustics in mirrors or glass. Finds, besides, what no other way does: point lights, as the"
                            + " discs that a lens makes of them, and their caustics in mirrors and glass."));

    /** The parameters of algorithms whose states are single samples: {@link #ofSingleSamples} makes settings from them. */
    public static final List<Parameter> SINGLE_SAMPLE_PARAMETERS = joined(
            PATHS,
            Parameter.choice(
                    "russianRoulette",
                    "Russian roulette",
                    "throughput",
                    List.of("none", "throughput"),
                    "none: limits of depth alone end paths; throughput: paths end in proportion to what they can still"
                            + " contribute. Does not change the mean."),
            RR_DEPTH,
            CAUSTIC_MAP);

    private static List<Parameter> joined(List<Parameter> first, Parameter... others) {
        List<Parameter> all = new ArrayList<>(first);
        all.addAll(List.of(others));
        return List.copyOf(all);
    }

    private static Parameter depth(String name, String label, String doc) {
        return Parameter.integer(name, label, -1, -1, Integer.MAX_VALUE, doc);
    }

    /**
     * Checks what the ranges of the single values do not say.
     *
     * @throws ParameterException if a depth is 0, if nothing can be rendered, or if paths would never end
     * @throws IllegalArgumentException if the smallest number of edges is not positive
     */
    public BidirectionalSettings {
        requireDepth("maxEyeDepth", maxEyeDepth);
        requireDepth("maxLightDepth", maxLightDepth);
        if (maxEyeDepth == 1 && !causticMap) {
            throw new ParameterException("with maxEyeDepth 1 all light comes through the caustic map, which is off");
        }
        boolean endless = maxDepth < 0 && (maxEyeDepth < 0 || maxLightDepth < 0);
        if (roulette == Roulette.NONE && endless) {
            throw new ParameterException(
                    "without Russian roulette paths need a limit: set maxDepth, or maxEyeDepth" + " and maxLightDepth");
        }
        if (minDepth < 1) {
            throw new IllegalArgumentException("paths have at least 1 edge: " + minDepth);
        }
    }

    /** Settings with which paths of all lengths count, but hits of the lens do not, and densities alone decide weights. */
    public BidirectionalSettings(
            int maxEyeDepth,
            int maxLightDepth,
            int maxDepth,
            double heuristicExponent,
            Roulette roulette,
            int rrDepth,
            int splitting,
            boolean allLights,
            boolean causticMap) {
        this(
                maxEyeDepth,
                maxLightDepth,
                maxDepth,
                heuristicExponent,
                roulette,
                rrDepth,
                splitting,
                allLights,
                causticMap,
                1,
                false,
                1);
    }

    private static void requireDepth(String name, int depth) {
        if (depth == 0) {
            throw new ParameterException(
                    "parameter '" + name + "' is '0' but must be a whole number, at least 1, or -1 for no limit");
        }
    }

    /** Settings from parameter values. */
    static BidirectionalSettings of(ParameterValues values) {
        return of(
                values,
                values.integer("splitting"),
                values.choice("lightsPerPath").equals("all"),
                values.real("causticMapShare"),
                values.flag("lensHits"));
    }

    /** Settings from the parameters that single samples have as well, and values of the others. */
    private static BidirectionalSettings of(
            ParameterValues values, int splitting, boolean allLights, double causticMapShare, boolean lensHits) {
        return new BidirectionalSettings(
                values.integer("maxEyeDepth"),
                values.integer("maxLightDepth"),
                values.integer("maxDepth"),
                values.real("heuristicExponent"),
                switch (values.choice("russianRoulette")) {
                    case "none" -> Roulette.NONE;
                    case "throughput" -> Roulette.THROUGHPUT;
                    default -> Roulette.EFFICIENCY;
                },
                values.integer("rrDepth"),
                splitting,
                allLights,
                values.flag("causticMap"),
                causticMapShare,
                lensHits,
                1);
    }

    /** A roulette for occlusion tests as the settings want it. */
    ConnectionRoulette connectionRoulette() {
        return new ConnectionRoulette(roulette == Roulette.EFFICIENCY);
    }

    /**
     * Settings of an algorithm whose states are single samples: {@link #singleSample} at once.
     *
     * @param values with {@link #SINGLE_SAMPLE_PARAMETERS} among them
     */
    public static BidirectionalSettings ofSingleSamples(ParameterValues values) {
        return of(values, 1, false, 1, false);
    }

    /** The same settings for paths of so many edges or more. */
    public BidirectionalSettings withMinDepth(int edges) {
        return with(roulette, splitting, allLights, causticMapShare, lensHits, edges);
    }

    /**
     * The same settings for samples that depend on nothing but their numbers: with one light subpath, without splitting, without hits
     * of the lens, without the roulette for occlusion tests, which goes by the samples before, and with weights by densities alone, as
     * pixels have no samples of their own.
     */
    public BidirectionalSettings singleSample() {
        return with(roulette == Roulette.NONE ? Roulette.NONE : Roulette.THROUGHPUT, 1, false, 1, false, minDepth);
    }

    /**
     * The same settings for samples that belong to pixels: without light subpaths at the lens, and with the default values of all that
     * {@link #singleSample} has not.
     */
    public BidirectionalSettings ofPixels() {
        return new BidirectionalSettings(
                maxEyeDepth,
                maxLightDepth,
                maxDepth,
                heuristicExponent,
                roulette == Roulette.NONE ? Roulette.NONE : Roulette.EFFICIENCY,
                rrDepth,
                DEFAULT_SPLITTING,
                false,
                false,
                1,
                false,
                minDepth);
    }

    /** The same depths and heuristic with other values of the rest. */
    private BidirectionalSettings with(
            Roulette kind, int ways, boolean everyLight, double share, boolean hits, int edges) {
        return new BidirectionalSettings(
                maxEyeDepth,
                maxLightDepth,
                maxDepth,
                heuristicExponent,
                kind,
                rrDepth,
                ways,
                everyLight,
                causticMap,
                share,
                hits,
                edges);
    }

    /** In how many ways an eye subpath goes on from the first vertex that can be connected. */
    int eyeBranches() {
        return allLights ? 1 : splitting;
    }

    /** Largest number of edges from which on Russian roulette may end subpaths; beyond all paths if it may not. */
    int rouletteFrom() {
        return roulette == Roulette.NONE ? Integer.MAX_VALUE : rrDepth;
    }

    /** What can be sampled with a camera. */
    TechniqueLimits limits(Camera camera) {
        return limits(camera.isParallel(), camera.hasLensArea());
    }

    /**
     * What can be sampled.
     *
     * @param parallelFilm whether the camera sees along a single direction
     * @param lensArea whether rays can hit the lens
     */
    TechniqueLimits limits(boolean parallelFilm, boolean lensArea) {
        boolean hits = lensHits && lensArea;
        int eye = limit(maxEyeDepth);
        int light = limit(maxLightDepth);
        if (maxDepth >= 0) {
            eye = (int) Math.min(eye, maxDepth + 1L);
            light = (int) Math.min(light, hits ? maxDepth + 1L : maxDepth);
        }
        return new TechniqueLimits(eye, light, causticMap, parallelFilm, hits, causticMapShare);
    }

    /** Whether light paths bring something to the lens. */
    boolean splats() {
        TechniqueLimits limits = limits(false, true);
        boolean longer = limits.maxLightVertices() > 1;
        return (longer && (limits.lens() || limits.lensHits())) || limits.emitterAtLens();
    }

    /** Largest number of vertices of a full path. */
    long maxVertices() {
        return maxDepth < 0 ? Long.MAX_VALUE : maxDepth + 1L;
    }

    private static int limit(int depth) {
        return depth < 0 ? Integer.MAX_VALUE - 8 : depth;
    }
}
