package org.daybreak.core.testing;

/** Mean and variance of numbers, accumulated by Welford's method. */
public final class Moments {
    private long count;
    private double mean;
    private double squares;

    /** Creates an empty accumulator. */
    public Moments() {}

    /** The moments of some numbers. */
    public static Moments of(double... values) {
        Moments moments = new Moments();
        for (double value : values) {
            moments.add(value);
        }
        return moments;
    }

    /** Takes a number in. */
    public void add(double value) {
        count++;
        double delta = value - mean;
        mean += delta / count;
        squares += delta * (value - mean);
    }

    /** How many numbers were taken in. */
    public long count() {
        return count;
    }

    /** The mean. */
    public double mean() {
        return mean;
    }

    /** The unbiased estimate of the variance of one number; NaN below two numbers. */
    public double variance() {
        return count < 2 ? Double.NaN : squares / (count - 1);
    }

    /** The estimate of the variance of the mean; NaN below two numbers. */
    public double varianceOfMean() {
        return variance() / count;
    }
}
