package org.daybreak.core.material;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/**
 * The diffuse base below a dielectric coating. Light enters through the coating, is scattered by the base, and is
 * thrown back by the inside of the coating any number of times before it leaves:
 * f = ρ/(1 − ρ R)·T(θ_o) T(θ_i)/(π η²), with R the coating's diffuse reflectance from inside. Symmetric in its
 * directions; for ρ = 1 and R = 1 − ∫T/η² nothing is lost but by the coating itself.
 */
final class CoatedDiffuse {
    private final Reflectance reflectance;
    private final double internalReflectance;
    private final boolean nonlinear;
    private final double scale;

    /**
     * Creates the base.
     *
     * @param eta index of the coating over that of the outside
     * @param internalReflectance R, in [0,1)
     * @param nonlinear whether colours shift with every internal reflection (ρ R above); otherwise the sum over
     *     reflections is taken with ρ = 1, and ρ scales the result
     */
    CoatedDiffuse(Reflectance reflectance, double eta, double internalReflectance, boolean nonlinear) {
        this.reflectance = reflectance;
        this.internalReflectance = internalReflectance;
        this.nonlinear = nonlinear;
        this.scale = 1 / (eta * eta);
    }

    /**
     * Writes ρ/(1 − ρ R)/η² times a factor.
     *
     * @param factor transmittances, cosine and 1/π
     */
    void evaluate(SurfacePoint point, double factor, Spectrum out) {
        double k = factor * scale;
        if (nonlinear) {
            reflectance.evaluate(point, out);
            out.set(k * multiplied(out.r), k * multiplied(out.g), k * multiplied(out.b));
        } else {
            reflectance.evaluateScaled(point, k / (1 - internalReflectance), out);
        }
    }

    /** True unless the reflectance is the same everywhere. */
    boolean varies() {
        return reflectance.varies();
    }

    private double multiplied(double rho) {
        return rho / (1 - rho * internalReflectance);
    }
}
