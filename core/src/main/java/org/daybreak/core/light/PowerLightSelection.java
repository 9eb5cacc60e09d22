package org.daybreak.core.light;

import java.util.List;
import org.daybreak.core.sampling.DiscreteDistribution;
import org.jspecify.annotations.Nullable;

/** Chooses lights by their power, wherever the point. If no light has power, all are equally likely. */
public final class PowerLightSelection implements LightSelection {
    private final @Nullable DiscreteDistribution byPower;

    /** Creates the selection among these lights. */
    public PowerLightSelection(List<? extends Light> lights) {
        double[] powers = new double[lights.size()];
        for (int i = 0; i < powers.length; i++) {
            powers[i] = lights.get(i).power();
        }
        byPower = powers.length == 0 ? null : new DiscreteDistribution(powers);
    }

    @Override
    public boolean choose(double px, double py, double pz, double nx, double ny, double nz, double u, LightChoice out) {
        int light = chooseForEmission(u);
        if (light < 0) {
            return false;
        }
        out.set(light, emissionProbability(light));
        return true;
    }

    @Override
    public double probability(int light, double px, double py, double pz, double nx, double ny, double nz) {
        return emissionProbability(light);
    }

    @Override
    public int chooseForEmission(double u) {
        return byPower == null ? -1 : byPower.sample(u);
    }

    @Override
    public double emissionProbability(int light) {
        return byPower == null ? 0 : byPower.probability(light);
    }
}
