package org.daybreak.core.math;

/**
 * Sine and cosine of angles that come as fractions of a turn, as uniform numbers do: no reduction by π, and several times as
 * fast as {@link Math#sin}. Absolute error below 2.3e-16; the same bits everywhere.
 */
public final class Turns {
    private Turns() {}

    /** sin(2π·turns) for turns in [−2³⁰, 2³⁰]. */
    public static double sin(double turns) {
        int quarter = nearestQuarter(turns);
        double x = 2 * (4 * turns - quarter);
        double value = (quarter & 1) == 0 ? sinEighth(x) : cosEighth(x);
        return (quarter & 2) == 0 ? value : -value;
    }

    /** cos(2π·turns) for turns in [−2³⁰, 2³⁰]. */
    public static double cos(double turns) {
        int quarter = nearestQuarter(turns);
        double x = 2 * (4 * turns - quarter);
        double value = (quarter & 1) == 0 ? cosEighth(x) : -sinEighth(x);
        return (quarter & 2) == 0 ? value : -value;
    }

    /** sin(π/4·x) for |x| ≤ 1: Chebyshev fit of sin(π/4·√s)/√s on [0, 1], error 2.5e-18 before rounding. */
    public static double sinEighth(double x) {
        double s = x * x;
        double p = 6.877360573166326e-12;
        p = p * s - 1.7571500746983935e-09;
        p = p * s + 3.133616225433416e-07;
        p = p * s - 3.657620415891387e-05;
        p = p * s + 0.002490394570188844;
        p = p * s - 0.08074551218828054;
        p = p * s + 0.7853981633974483;
        return x * p;
    }

    /** cos(π/4·x) for |x| ≤ 1: Chebyshev fit of cos(π/4·√s) on [0, 1], error 5e-17 before rounding. */
    public static double cosEighth(double x) {
        double s = x * x;
        double p = 1.1365469207731353e-10;
        p = p * s - 2.4609507094028117e-08;
        p = p * s + 3.590859179850238e-06;
        p = p * s - 0.00032599188648354014;
        p = p * s + 0.015854344243741547;
        p = p * s - 0.30842513753403783;
        return p * s + 1;
    }

    private static int nearestQuarter(double turns) {
        double quarters = 4 * turns;
        return (int) (quarters + Math.copySign(0.5, quarters));
    }
}
