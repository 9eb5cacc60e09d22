package org.daybreak.core.light;

/** A light that was chosen for a point. Mutable, owned by one worker. */
public final class LightChoice {
    /** Index of the light in the scene's light list. */
    public int light;

    /** Probability with which it was chosen, positive; what {@link LightSelection#probability} gives for it. */
    public double probability;

    /** Room for intermediate results of the selections, so that they need not allocate. */
    final double[] scratch = new double[2];

    /** Estimates of the first lights at the point, where the selection has made them; and what turns them into probabilities. */
    final double[] estimates = new double[4];

    double total;
    int candidates;

    /** Creates an empty choice. */
    public LightChoice() {}

    /** Sets both. */
    void set(int light, double probability) {
        this.light = light;
        this.probability = probability;
        candidates = 0;
    }

    /**
     * What {@link LightSelection#probability} gives for another light at the point of the last choice that was made with this object;
     * -1 if that was made without a look at it.
     */
    public double probabilityOf(int other) {
        return candidates > 0 && other < estimates.length
                ? ImportanceLightSelection.mix(estimates[other], total, candidates)
                : -1;
    }
}
