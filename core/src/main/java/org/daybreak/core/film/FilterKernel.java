package org.daybreak.core.film;

/**
 * A reconstruction filter along one axis, tabulated, scaled to integrate to 1. Immutable.
 *
 * <p>Between the entries of the table it is linear. So the table is the filter that is used, and the integrals that
 * normalise splats are those of the table and exact; it deviates from the formula by less than 1e-5 of the peak.
 */
final class FilterKernel {
    private static final int ENTRIES_PER_PIXEL = 512;

    private final double radius;
    private final double perPixel;
    /** Values at distances 0, 1/perPixel, …, radius, and one more to interpolate towards. */
    private final double[] values;
    /** Integral from 0 to each distance. */
    private final double[] integrals;
    /** The same of bounds of the absolute values, linear in between: the density that offsets are drawn with is constant there. */
    private final double[] absoluteIntegrals;

    FilterKernel(ReconstructionFilter filter) {
        radius = filter.radius();
        int n = (int) Math.ceil(radius * ENTRIES_PER_PIXEL);
        perPixel = n / radius;
        values = new double[n + 2];
        integrals = new double[n + 2];
        for (int i = 0; i <= n; i++) {
            values[i] = filter.evaluate(Math.min(i / perPixel, radius));
        }
        values[n + 1] = values[n];
        for (int i = 1; i <= n + 1; i++) {
            integrals[i] = integrals[i - 1] + 0.5 * (values[i - 1] + values[i]) / perPixel;
        }
        double norm = 2 * integrals[n];
        for (int i = 0; i <= n + 1; i++) {
            values[i] /= norm;
            integrals[i] /= norm;
        }
        absoluteIntegrals = new double[n + 2];
        for (int i = 1; i <= n + 1; i++) {
            double step = 0.5 * (Math.abs(values[i - 1]) + Math.abs(values[i])) / perPixel;
            absoluteIntegrals[i] = absoluteIntegrals[i - 1] + step;
        }
    }

    /** How many pixels beyond its own a sample can reach: pixels whose centre is within the radius of some point of it. */
    static int border(ReconstructionFilter filter) {
        return (int) Math.ceil(filter.radius() - 0.5);
    }

    /** Weight at a distance from the centre; 0 beyond the radius. */
    double weight(double distance) {
        double d = Math.abs(distance);
        if (d > radius) {
            return 0;
        }
        double position = d * perPixel;
        int i = (int) position;
        return values[i] + (position - i) * (values[i + 1] - values[i]);
    }

    /** Integral of the weights over [from, to], in distances from the centre. */
    double integral(double from, double to) {
        return primitive(to) - primitive(from);
    }

    private double primitive(double distance) {
        double d = Math.min(Math.abs(distance), radius);
        double position = d * perPixel;
        int i = (int) position;
        double f = position - i;
        double value = integrals[i] + f * (values[i] + 0.5 * f * (values[i + 1] - values[i])) / perPixel;
        return Math.copySign(value, distance);
    }

    /** Integral of the absolute values of the weights over [from, to]. */
    double absoluteIntegral(double from, double to) {
        return absolutePrimitive(to) - absolutePrimitive(from);
    }

    private double absolutePrimitive(double distance) {
        double d = Math.min(Math.abs(distance), radius);
        double position = d * perPixel;
        int i = (int) position;
        double f = position - i;
        double value = absoluteIntegrals[i] + f * (absoluteIntegrals[i + 1] - absoluteIntegrals[i]);
        return Math.copySign(value, distance);
    }

    /** The distance up to which, from 0 on, the integral of the absolute weights has a value; odd in that value. */
    double absoluteQuantile(double integral) {
        double wanted = Math.abs(integral);
        int n = absoluteIntegrals.length - 2;
        int low = 0;
        int high = n;
        while (high - low > 1) {
            int middle = (low + high) >>> 1;
            if (absoluteIntegrals[middle] <= wanted) {
                low = middle;
            } else {
                high = middle;
            }
        }
        double step = absoluteIntegrals[low + 1] - absoluteIntegrals[low];
        double f = step > 0 ? Math.min(1, (wanted - absoluteIntegrals[low]) / step) : 0;
        return Math.copySign(Math.min((low + f) / perPixel, radius), integral);
    }

    /** Mean of the absolute weight over the step of the table that a distance lies in: the density of quantiles. */
    double absoluteStep(double distance) {
        int i = Math.min((int) (Math.abs(distance) * perPixel), absoluteIntegrals.length - 3);
        return (absoluteIntegrals[i + 1] - absoluteIntegrals[i]) * perPixel;
    }
}
