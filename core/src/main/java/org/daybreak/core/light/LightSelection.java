package org.daybreak.core.light;

/**
 * Chooses among the lights of a scene. Immutable and thread-safe. Indices are those of the scene's light list.
 */
public interface LightSelection {
    /**
     * Chooses a light for next-event estimation at a point with a normal (zero vector where there is none).
     *
     * @param u uniform number in [0,1)
     * @param out receives the light and its probability, which comes out of the choice and need not be asked for
     * @return false if no light can reach the point; {@code out} is then as it was
     */
    boolean choose(double px, double py, double pz, double nx, double ny, double nz, double u, LightChoice out);

    /** Probability with which {@link #choose} chooses the light at this point: for lights that were met otherwise. */
    double probability(int light, double px, double py, double pz, double nx, double ny, double nz);

    /** Chooses a light to start a light subpath from, independent of any point; -1 if there is no light. */
    int chooseForEmission(double u);

    /** Probability with which {@link #chooseForEmission} returns the light. */
    double emissionProbability(int light);
}
