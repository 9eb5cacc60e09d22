package org.daybreak.core.light;

/**
 * Chooses among the lights of a scene. Immutable and thread-safe. Indices are those of the scene's light list.
 */
public interface LightSelection {
    /**
     * Chooses a light for next-event estimation at a point with a normal (zero vector where there is none).
     *
     * @param u uniform number in [0,1)
     * @return light index, or -1 if no light can reach the point
     */
    int choose(double px, double py, double pz, double nx, double ny, double nz, double u);

    /** Probability with which {@link #choose} returns the light at this point. */
    double probability(int light, double px, double py, double pz, double nx, double ny, double nz);

    /** Chooses a light to start a light subpath from, independent of any point; -1 if there is no light. */
    int chooseForEmission(double u);

    /** Probability with which {@link #chooseForEmission} returns the light. */
    double emissionProbability(int light);
}
