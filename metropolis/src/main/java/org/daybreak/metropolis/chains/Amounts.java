package org.daybreak.metropolis.chains;

/**
 * How many samples and steps a render takes if nothing stops it. Without {@link ChainSettings#directSamples()} the numbers follow the plan, so that
 * neither part keeps noise that the other has long lost, however many mutations are asked for:
 *
 * <ul>
 *   <li>where samples take kinds of paths off the chains, both together do the work of the mutations per pixel, each its share of the time;
 *   <li>where they render direct light alone, their work comes on top.
 * </ul>
 *
 * @param samplesPerPixel of what is rendered apart
 * @param steps of all chains together
 */
record Amounts(int samplesPerPixel, long steps) {
    /** Finds out. */
    static Amounts of(ChainSettings settings, SamplePlan plan, long pixels) {
        long steps = settings.steps(pixels);
        if (settings.directSamples() > 0) {
            return new Amounts(settings.directSamples(), steps);
        }
        double mutations = settings.mutationsPerPixel();
        double share = plan.timeShare();
        if (share == 0) {
            return new Amounts(atLeastOne(mutations * ChainSettings.SAMPLES_PER_MUTATION), steps);
        }
        if (plan.ofSamples().isEmpty()) {
            return new Amounts(atLeastOne(mutations * share / (1 - share) / plan.stepsPerSample()), steps);
        }
        return new Amounts(
                atLeastOne(mutations * share / plan.stepsPerSample()),
                Math.max(1, Math.round(steps * (1 - share) / plan.stepCost())));
    }

    /** An {@code int} that is near. */
    private static int atLeastOne(double number) {
        return (int) Math.max(1, Math.rint(number));
    }

    /** What part of all samples and steps are samples. */
    double shareOfSamples(long pixels) {
        double samples = (double) samplesPerPixel * pixels;
        return samples / (samples + steps);
    }
}
