package org.daybreak.core.light;

import java.util.List;

/**
 * Chooses lights by the irradiance they would cause at the point without occlusion. For few lights: each choice looks at all of
 * them.
 *
 * <p>A small part of the choices is uniform among the lights that can contribute at all, so that an estimate that is too low
 * costs a bounded amount of variance. A single light is always chosen, without a look at it.
 */
public final class ImportanceLightSelection implements LightSelection {
    /** Part of the choices that does not follow the estimates. */
    private static final double UNIFORM_SHARE = 0.05;

    /** Bound of single estimates, so that sums stay finite next to a point light. */
    private static final double LARGEST = 1e200;

    private final Light[] lights;
    private final PowerLightSelection forEmission;

    /** Creates the selection among these lights. */
    public ImportanceLightSelection(List<? extends Light> lights) {
        this.lights = lights.toArray(new Light[0]);
        forEmission = new PowerLightSelection(lights);
    }

    @Override
    public boolean choose(double px, double py, double pz, double nx, double ny, double nz, double u, LightChoice out) {
        if (lights.length == 1) {
            out.set(0, 1);
            return true;
        }
        // Most scenes have up to four lights. Their estimates fit into variables and need not be computed twice.
        double w0 = importanceIfAny(0, px, py, pz, nx, ny, nz);
        double w1 = importanceIfAny(1, px, py, pz, nx, ny, nz);
        double w2 = importanceIfAny(2, px, py, pz, nx, ny, nz);
        double w3 = importanceIfAny(3, px, py, pz, nx, ny, nz);
        double total = w0 + w1 + w2 + w3;
        int candidates = (w0 > 0 ? 1 : 0) + (w1 > 0 ? 1 : 0) + (w2 > 0 ? 1 : 0) + (w3 > 0 ? 1 : 0);
        for (int i = 4; i < lights.length; i++) {
            double importance = importance(i, px, py, pz, nx, ny, nz);
            if (importance > 0) {
                total += importance;
                candidates++;
            }
        }
        double left = u;
        for (int i = 0; candidates > 0 && i < lights.length; i++) {
            double importance =
                    i > 3 ? importance(i, px, py, pz, nx, ny, nz) : i == 0 ? w0 : i == 1 ? w1 : i == 2 ? w2 : w3;
            if (importance > 0) {
                double probability = mix(importance, total, candidates);
                out.set(i, probability);
                left -= probability;
                if (left < 0) {
                    break;
                }
            }
        }
        out.estimates[0] = w0;
        out.estimates[1] = w1;
        out.estimates[2] = w2;
        out.estimates[3] = w3;
        out.total = total;
        out.candidates = candidates;
        // Rounding may leave a little over: that is the last candidate's.
        return candidates > 0;
    }

    @Override
    public double probability(int light, double px, double py, double pz, double nx, double ny, double nz) {
        if (lights.length == 1) {
            return 1;
        }
        double own = importance(light, px, py, pz, nx, ny, nz);
        if (!(own > 0)) {
            return 0;
        }
        double total = 0;
        int candidates = 0;
        for (int i = 0; i < lights.length; i++) {
            double importance = i == light ? own : importance(i, px, py, pz, nx, ny, nz);
            if (importance > 0) {
                total += importance;
                candidates++;
            }
        }
        return mix(own, total, candidates);
    }

    @Override
    public int chooseForEmission(double u) {
        return forEmission.chooseForEmission(u);
    }

    @Override
    public double emissionProbability(int light) {
        return forEmission.emissionProbability(light);
    }

    /** Probability of a light with an estimate, among so many with one. */
    static double mix(double importance, double total, int candidates) {
        return !(importance > 0) ? 0 : (1 - UNIFORM_SHARE) * (importance / total) + UNIFORM_SHARE / candidates;
    }

    private double importanceIfAny(int light, double px, double py, double pz, double nx, double ny, double nz) {
        return light < lights.length ? importance(light, px, py, pz, nx, ny, nz) : 0;
    }

    private double importance(int light, double px, double py, double pz, double nx, double ny, double nz) {
        return Math.min(LARGEST, lights[light].importance(px, py, pz, nx, ny, nz));
    }
}
