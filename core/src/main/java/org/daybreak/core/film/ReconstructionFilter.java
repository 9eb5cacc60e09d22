package org.daybreak.core.film;

import java.util.Locale;

/**
 * A separable pixel filter with a finite support, in pixels. Immutable.
 *
 * @param kind shape of the filter
 * @param radius half-width of the support in pixels, at least 0.5
 * @param parameter standard deviation in pixels for the Gaussian, B of (B, C = (1−B)/2) for Mitchell–Netravali, unused
 *     otherwise
 */
public record ReconstructionFilter(Kind kind, double radius, double parameter) {
    /** The box of one pixel: every sample belongs to the pixel it lies in. */
    public static final ReconstructionFilter BOX = new ReconstructionFilter(Kind.BOX, 0.5, 0);

    /** A tent (bilinear) filter of radius 1. */
    public static final ReconstructionFilter TENT = new ReconstructionFilter(Kind.TENT, 1, 0);

    /** A Gaussian of standard deviation 0.5, cut at radius 2 and lowered to reach zero there. */
    public static final ReconstructionFilter GAUSSIAN = new ReconstructionFilter(Kind.GAUSSIAN, 2, 0.5);

    /** Mitchell–Netravali with B = C = 1/3 (Mitchell and Netravali 1988), radius 2; has negative lobes. */
    public static final ReconstructionFilter MITCHELL = new ReconstructionFilter(Kind.MITCHELL, 2, 1.0 / 3);

    /** The cubic of Catmull and Rom, radius 2: Mitchell–Netravali with B = 0, C = 1/2; interpolates and has negative lobes. */
    public static final ReconstructionFilter CATMULL_ROM = new ReconstructionFilter(Kind.MITCHELL, 2, 0);

    /** The four-term window of Blackman and Harris, radius 1.5: close to a Gaussian, and 0 at the end of its own. */
    public static final ReconstructionFilter BLACKMAN_HARRIS = new ReconstructionFilter(Kind.BLACKMAN_HARRIS, 1.5, 0);

    /** Lanczos with three lobes; has negative lobes. */
    public static final ReconstructionFilter LANCZOS = new ReconstructionFilter(Kind.LANCZOS, 3, 0);

    /** Shape of a filter. */
    public enum Kind {
        /** Constant. */
        BOX,
        /** Linear. */
        TENT,
        /** Truncated Gaussian, offset to be continuous. */
        GAUSSIAN,
        /** Cubic of Mitchell and Netravali. */
        MITCHELL,
        /** Four-term window of minimum side lobes (Harris, “On the Use of Windows”, Proc. IEEE 66, 1978, table 1). */
        BLACKMAN_HARRIS,
        /** Sinc with a lobe per pixel of the radius, windowed by the central lobe of a sinc (Duchon 1979). */
        LANCZOS;

        /** Name in files and on the command line. */
        public String id() {
            return name().toLowerCase(Locale.ROOT).replace('_', '-');
        }
    }

    /** Checks the numbers. */
    public ReconstructionFilter {
        if (!(radius >= 0.5 && radius <= 16)) {
            throw new IllegalArgumentException("the filter radius must be from 0.5 to 16 pixels but is " + radius);
        }
        if (kind == Kind.MITCHELL && !Double.isFinite(parameter)) {
            throw new IllegalArgumentException(
                    "the parameter B of the Mitchell filter must be finite but is " + parameter);
        }
        if (kind == Kind.GAUSSIAN && !(parameter > 0 && Double.isFinite(parameter))) {
            throw new IllegalArgumentException(
                    "the standard deviation of the Gaussian filter must be positive but is " + parameter);
        }
    }

    /** The filter's value at a distance from the centre along one axis, not normalised; 0 outside the support. */
    public double evaluate(double distance) {
        double d = Math.abs(distance);
        if (d > radius) {
            return 0;
        }
        return switch (kind) {
            case BOX -> 1;
            case TENT -> 1 - d / radius;
            case GAUSSIAN -> Math.max(0, gaussian(d) - gaussian(radius));
            case MITCHELL -> mitchell(2 * d / radius);
            case BLACKMAN_HARRIS -> blackmanHarris(Math.PI * d / radius);
            case LANCZOS -> sinc(d) * sinc(d / radius);
        };
    }

    private double gaussian(double d) {
        return Math.exp(-d * d / (2 * parameter * parameter));
    }

    private static double blackmanHarris(double angle) {
        return Math.max(
                0, 0.35875 + 0.48829 * Math.cos(angle) + 0.14128 * Math.cos(2 * angle) + 0.01168 * Math.cos(3 * angle));
    }

    private static double sinc(double x) {
        double angle = Math.PI * x;
        return angle < 1e-4 ? 1 - angle * angle / 6 : Math.sin(angle) / angle;
    }

    private double mitchell(double x) {
        double b = parameter;
        double c = (1 - b) / 2;
        if (x < 1) {
            return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + (6 - 2 * b)) / 6;
        }
        return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + (8 * b + 24 * c)) / 6;
    }
}
