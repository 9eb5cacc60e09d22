package org.daybreak.core.light;

/** A light that was chosen for a point. Mutable, owned by one worker. */
public final class LightChoice {
    /** Index of the light in the scene's light list. */
    public int light;

    /** Probability with which it was chosen, positive; what {@link LightSelection#probability} gives for it. */
    public double probability;

    /** Room for intermediate results of the selections, so that they need not allocate. */
    final double[] scratch = new double[2];

    /** Creates an empty choice. */
    public LightChoice() {}

    /** Sets both. */
    void set(int light, double probability) {
        this.light = light;
        this.probability = probability;
    }
}
