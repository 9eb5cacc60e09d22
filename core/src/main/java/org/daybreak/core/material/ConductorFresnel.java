package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.jspecify.annotations.Nullable;

/** Reflectance of a conducting surface by angle, per channel. Immutable. */
final class ConductorFresnel {
    private final boolean perfect;
    private final double etaR;
    private final double etaG;
    private final double etaB;
    private final double kR;
    private final double kG;
    private final double kB;

    /** Creates the reflectance of η + ik; null for both means reflectance 1 at every angle. */
    ConductorFresnel(@Nullable Spectrum eta, @Nullable Spectrum k) {
        perfect = eta == null || k == null;
        if (eta != null && k != null) {
            Checks.requireComplexIor(eta, k);
            etaR = eta.r;
            etaG = eta.g;
            etaB = eta.b;
            kR = k.r;
            kG = k.g;
            kB = k.b;
        } else {
            etaR = 0;
            etaG = 0;
            etaB = 0;
            kR = 0;
            kG = 0;
            kB = 0;
        }
    }

    /** Multiplies by the reflectance at the angle with the given cosine. */
    void multiply(double cosine, Spectrum value) {
        if (perfect) {
            return;
        }
        value.set(
                value.r * Fresnel.conductor(cosine, etaR, kR),
                value.g * Fresnel.conductor(cosine, etaG, kG),
                value.b * Fresnel.conductor(cosine, etaB, kB));
    }
}
