package org.daybreak.metropolis.chains;

/**
 * What is known of b, the integral of the chains' target over all paths: the mean luminance of their image or, in the
 * second of two stages, of that image times its {@link ImageImportance} (Veach 1997, §11.3.1).
 *
 * @param mean the estimate of b; NaN as long as no candidates were drawn
 * @param standardError of the estimate; NaN if there were fewer than two candidates
 * @param candidates number of candidates that it comes from
 * @param withoutLight how many of these offered no state
 */
record Brightness(double mean, double standardError, long candidates, long withoutLight) {
    /** Before candidates are drawn. */
    static final Brightness UNKNOWN = new Brightness(Double.NaN, Double.NaN, 0, 0);

    /** What candidates have shown. */
    static Brightness of(StartDistribution candidates) {
        return new Brightness(
                candidates.mean(), candidates.standardError(), candidates.candidates(), candidates.withoutLight());
    }

    /** Writes all of it. */
    void save(StateWriter out) {
        out.put(mean);
        out.put(standardError);
        out.put(candidates);
        out.put(withoutLight);
    }

    /** Reads what {@link #save} has written. */
    static Brightness load(StateReader in) {
        return new Brightness(in.nextDouble(), in.nextDouble(), in.next(), in.next());
    }
}
