package org.daybreak.core.color;

/**
 * A spectral quantity, such as radiance, throughput or reflectance, as linear RGB with the primaries and the white
 * point of Rec. 709 (those of sRGB).
 *
 * <p>Mutable, for reuse in hot paths: it has identity, not value, semantics. Code that transports light uses the
 * operations below; the three fields are for what must know the colour space (textures, film, files), so that a finer
 * spectrum can take the place of RGB.
 */
public final class Spectrum {
    /** Weight of red in the luminance (Rec. 709, rounded so that the weights sum to 1). */
    public static final double LUMINANCE_R = 0.212671;
    /** Weight of green in the luminance. */
    public static final double LUMINANCE_G = 0.715160;
    /** Weight of blue in the luminance. */
    public static final double LUMINANCE_B = 0.072169;

    public double r;
    public double g;
    public double b;

    /** Creates the zero spectrum. */
    public Spectrum() {}

    /** Creates a spectrum from linear RGB. */
    public Spectrum(double r, double g, double b) {
        this.r = r;
        this.g = g;
        this.b = b;
    }

    /** Luminance of linear Rec. 709 RGB; white (1, 1, 1) has luminance 1. */
    public static double luminance(double r, double g, double b) {
        return LUMINANCE_R * r + LUMINANCE_G * g + LUMINANCE_B * b;
    }

    /** Sets every component. */
    public void set(double r, double g, double b) {
        this.r = r;
        this.g = g;
        this.b = b;
    }

    /** Sets every component to the same value. */
    public void set(double value) {
        r = value;
        g = value;
        b = value;
    }

    /** Copies the other spectrum into this one. */
    public void set(Spectrum other) {
        r = other.r;
        g = other.g;
        b = other.b;
    }

    /** Sets every component to 0. */
    public void setZero() {
        r = 0;
        g = 0;
        b = 0;
    }

    /** Adds the other spectrum. */
    public void add(Spectrum other) {
        r += other.r;
        g += other.g;
        b += other.b;
    }

    /** Adds {@code scale · other}. */
    public void addScaled(Spectrum other, double scale) {
        r += scale * other.r;
        g += scale * other.g;
        b += scale * other.b;
    }

    /** Adds the component-wise product {@code scale · first · second}. */
    public void addProduct(Spectrum first, Spectrum second, double scale) {
        r += scale * first.r * second.r;
        g += scale * first.g * second.g;
        b += scale * first.b * second.b;
    }

    /** Multiplies by the other spectrum, component by component. */
    public void mul(Spectrum other) {
        r *= other.r;
        g *= other.g;
        b *= other.b;
    }

    /** Multiplies every component by the factor. */
    public void scale(double factor) {
        r *= factor;
        g *= factor;
        b *= factor;
    }

    /** The luminance of this spectrum. */
    public double luminance() {
        return luminance(r, g, b);
    }

    /** The largest component. */
    public double max() {
        return Math.max(r, Math.max(g, b));
    }

    /** Whether every component is exactly 0. */
    public boolean isBlack() {
        return r == 0 && g == 0 && b == 0;
    }

    /** Whether no component is NaN or infinite. */
    public boolean isFinite() {
        return Double.isFinite(r) && Double.isFinite(g) && Double.isFinite(b);
    }

    /** A new spectrum with the same components. */
    public Spectrum copy() {
        return new Spectrum(r, g, b);
    }

    @Override
    public String toString() {
        return "Spectrum[" + r + ", " + g + ", " + b + "]";
    }
}
