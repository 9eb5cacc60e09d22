package org.daybreak.bidirectional;

/**
 * Weights of multiple importance sampling for full paths x₀…x_k, x₀ on the light and x_k on the lens (Veach 1997, eq. 8.8
 * and §10.2; thesis eq. 4.6): w_s = (n_s p_s)^β / Σ_i (n_i p_i)^β over the techniques i that the configuration can sample. n_i is
 * 1 but for light paths joined to the lens: {@link TechniqueLimits#share}. Pure functions.
 *
 * <p>Technique s takes s vertices from the light and k+1−s from the lens; technique k+1 hits the lens. With L_i and E_i the
 * densities of x_i from the light and from the lens, and N that of x₀ by next-event estimation, which technique 1 samples it with,
 *
 * <pre>p_0 = E₀E₁…E_k,  p_1 = N·E₁E₂…E_k,  p_s = L₀…L_{s−1}·E_s E_{s+1}…E_k,  p_{k+1} = L₀…L_k</pre>
 *
 * <p>There are two forms. {@link #weight} walks over the arrays of densities of a {@link CombinedPathValues} and knows all limits.
 * {@link #chain} goes with sums that {@link LineTracer} makes while it extends a subpath, and costs the same for any length.
 */
final class MisWeight {
    private MisWeight() {}

    /**
     * A ratio of densities raised to the exponent; 0 for 0, also with exponent 0, as what cannot be sampled has no part.
     *
     * @param ratio not negative
     */
    static double power(double ratio, double exponent) {
        if (exponent == 2) {
            return ratio * ratio;
        }
        if (ratio == 0) {
            return 0;
        }
        return exponent == 1 ? ratio : Math.pow(ratio, exponent);
    }

    /**
     * One end of the recursive form: with a vertex e that is connected, Σ_{i≤e} of the densities of the techniques that connect
     * before vertex i, relative to the one that connects behind e: R_e·(a_e + R_{e−1}·T_{e−1}), T_i = a_i + R_{i−1}·T_{i−1}.
     *
     * @param ratio R_e: reverse over forward density of e, raised to the exponent
     * @param admissible a_e: 1 if the edge before e can be connected, else 0; or the correction of technique 1
     * @param ratioBefore R_{e−1}
     * @param tail T_{e−1}
     */
    static double chain(double ratio, double admissible, double ratioBefore, double tail) {
        return ratio * (admissible + ratioBefore * tail);
    }

    /**
     * The weight of a technique, from the densities alone.
     *
     * @param path the full path
     * @param s the technique it was made by
     * @param limits what the configuration can sample
     * @param exponent β ≥ 0
     */
    static double weight(CombinedPathValues path, int s, TechniqueLimits limits, double exponent) {
        double sum = 1;
        double[] fromLight = path.fromLight;
        double[] fromEye = path.fromEye;
        double own = first(path, s, limits);
        double ratio = 1;
        for (int i = s - 1; i >= 0; i--) {
            if (i > 0) {
                ratio *= fromEye[i] / fromLight[i];
            }
            if (limits.admits(path, i)) {
                sum += power(ratio * first(path, i, limits) / own, exponent);
            }
        }
        ratio = 1;
        for (int i = s + 1; i <= path.length(); i++) {
            if (i > 1) {
                ratio *= fromLight[i - 1] / fromEye[i - 1];
            }
            if (limits.admits(path, i)) {
                sum += power(ratio * first(path, i, limits) / own, exponent);
            }
        }
        return 1 / sum;
    }

    /** Density of x₀ in a technique, times n_s. */
    private static double first(CombinedPathValues path, int s, TechniqueLimits limits) {
        double density = s == 0 ? path.fromEye[0] : s == 1 ? path.nextEvent : path.fromLight[0];
        return limits.share(path, s) * density;
    }
}
