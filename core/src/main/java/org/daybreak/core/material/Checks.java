package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;

/** Argument checks shared by the materials. */
final class Checks {
    private Checks() {}

    /** Returns a refractive index after checking that it is positive and finite. */
    static double requireIor(String name, double ior) {
        if (!(ior > 0 && ior < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(name + " index of refraction must be positive and finite but is " + ior);
        }
        return ior;
    }

    /** Checks a complex refractive index: both parts finite and not negative, and not both zero in any channel. */
    static void requireComplexIor(Spectrum eta, Spectrum k) {
        requireComplexIor("red", eta.r, k.r);
        requireComplexIor("green", eta.g, k.g);
        requireComplexIor("blue", eta.b, k.b);
    }

    private static void requireComplexIor(String channel, double eta, double k) {
        boolean valid = eta >= 0 && k >= 0 && eta + k > 0 && eta + k < Double.POSITIVE_INFINITY;
        if (!valid) {
            throw new IllegalArgumentException("complex index of refraction must have finite, non-negative parts, not "
                    + "both zero, but is eta " + eta + ", k " + k + " in " + channel);
        }
    }

    /** Returns a copy of a 2×3 affine matrix after checking it. */
    static double[] requireAffine(double[] uvTransform) {
        if (uvTransform.length != 6) {
            throw new IllegalArgumentException(
                    "a texture transform has 6 numbers (2x3 matrix) but got " + uvTransform.length);
        }
        for (double m : uvTransform) {
            if (!Double.isFinite(m)) {
                throw new IllegalArgumentException("a texture transform must be finite but contains " + m);
            }
        }
        return uvTransform.clone();
    }
}
