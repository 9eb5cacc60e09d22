package org.daybreak.cli.flip;

import java.util.Arrays;

/**
 * Computes FLIP errors: for each pixel a number from 0, no visible difference, to 1. Images are linear RGB with the primaries of
 * Rec. 709, interleaved, rows from the top. Thread-safe.
 */
public final class Flip {
    /** Pixels per degree of visual angle of a 3840 pixels wide monitor of 0.7 m, seen from 0.7 m (2020, section 6). */
    public static final double DEFAULT_PIXELS_PER_DEGREE = 3840 * Math.PI / 180;

    /** Exponent on colour differences (2020, section 4.1.4). */
    private static final double COLOR_EXPONENT = 0.7;

    /** Exponent on feature differences (2020, section 4.2.3). */
    private static final double FEATURE_EXPONENT = 0.5;

    /** Colour differences up to this part of the largest are mapped to [0, {@link #SMALL_ERRORS_TO}]. */
    private static final double SMALL_ERRORS = 0.4;

    private static final double SMALL_ERRORS_TO = 0.95;

    /** Value of the tone curve that the brightest and the median luminance are exposed to (2021, section 3). */
    private static final double EXPOSED_TO = 0.85;

    /** Coefficients of the rational tone curve (a·x² + b·x)/(c·x² + d·x + e): Narkowicz' fit of ACES, without pre-exposure. */
    private static final double ACES_A = 0.36 * 2.51;

    private static final double ACES_B = 0.6 * 0.03;
    private static final double ACES_C = 0.36 * 2.43;
    private static final double ACES_D = 0.6 * 0.59;
    private static final double ACES_E = 0.14;

    private final int width;
    private final int height;
    private final ContrastFilter contrast;
    private final FeatureFilter features;

    /**
     * Prepares to compare images of a size.
     *
     * @param pixelsPerDegree pixels per degree of visual angle
     */
    public Flip(int width, int height, double pixelsPerDegree) {
        this.width = width;
        this.height = height;
        contrast = new ContrastFilter(width, height, pixelsPerDegree);
        features = new FeatureFilter(width, height, pixelsPerDegree);
    }

    /**
     * LDR-FLIP, between images as a display shows them. Components are clamped to [0, 1].
     *
     * @return the error of each pixel
     */
    public float[] displayError(float[] image, float[] reference) {
        double[][] a = toYcxcz(image);
        double[][] b = toYcxcz(reference);
        float[] error = features.difference(a[0], b[0]);
        contrast.apply(a);
        contrast.apply(b);
        double[] labA = new double[3];
        double[] labB = new double[3];
        double largest = Math.pow(largestDifference(), COLOR_EXPONENT);
        for (int p = 0; p < error.length; p++) {
            OpponentColor.toHuntLab(a[0][p], a[1][p], a[2][p], labA);
            OpponentColor.toHuntLab(b[0][p], b[1][p], b[2][p], labB);
            double color = redistribute(Math.pow(hyab(labA, labB), COLOR_EXPONENT), largest);
            double feature = Math.pow(error[p] / Math.sqrt(2), FEATURE_EXPONENT);
            error[p] = (float) Math.pow(color, 1 - feature);
        }
        return error;
    }

    /**
     * HDR-FLIP: the largest of the LDR-FLIP errors over exposures from one that shows the highlights to one that shows the
     * shadows. Negative components count as 0.
     *
     * @return the error of each pixel
     */
    public float[] highDynamicRangeError(float[] image, float[] reference) {
        Exposures exposures = exposures(reference);
        float[] largest = new float[width * height];
        float[] exposedImage = new float[image.length];
        float[] exposedReference = new float[image.length];
        for (int i = 0; i < exposures.count(); i++) {
            double scale = Math.pow(2, exposures.at(i));
            expose(image, scale, exposedImage);
            expose(reference, scale, exposedReference);
            float[] error = displayError(exposedImage, exposedReference);
            for (int p = 0; p < error.length; p++) {
                largest[p] = Math.max(largest[p], error[p]);
            }
        }
        return largest;
    }

    /**
     * Exposures in stops.
     *
     * @param start the shortest
     * @param stop the longest
     * @param count how many, in equal steps
     */
    record Exposures(double start, double stop, int count) {
        double at(int i) {
            return count == 1 ? start : start + i * (stop - start) / (count - 1);
        }
    }

    /** Exposures that bring the brightest and the median luminance of the reference to a given value (2021, equation 2). */
    static Exposures exposures(float[] reference) {
        float[] luminance = new float[reference.length / 3];
        float brightest = 0;
        for (int p = 0; p < luminance.length; p++) {
            luminance[p] =
                    (float) (0.2126 * reference[3 * p] + 0.7152 * reference[3 * p + 1] + 0.0722 * reference[3 * p + 2]);
            brightest = Math.max(brightest, luminance[p]);
        }
        if (!(brightest > 0)) {
            return new Exposures(0, 0, 2);
        }
        Arrays.sort(luminance);
        int middle = luminance.length / 2;
        double median = luminance.length % 2 == 1
                ? luminance[middle]
                : 0.5 * ((double) luminance[middle - 1] + luminance[middle]);
        double p = (ACES_B - ACES_D * EXPOSED_TO) / (ACES_A - ACES_C * EXPOSED_TO);
        double q = -ACES_E * EXPOSED_TO / (ACES_A - ACES_C * EXPOSED_TO);
        double exposed = -0.5 * p + Math.sqrt(0.25 * p * p - q);
        double start = Math.log(exposed / brightest) / Math.log(2);
        double stop = Math.log(exposed / Math.max(median, Float.MIN_NORMAL)) / Math.log(2);
        return new Exposures(start, stop, (int) Math.max(2, Math.ceil(stop - start)));
    }

    private static void expose(float[] image, double scale, float[] out) {
        for (int i = 0; i < image.length; i++) {
            double x = Math.max(0, image[i]) * scale;
            double y = (ACES_A * x + ACES_B) * x / ((ACES_C * x + ACES_D) * x + ACES_E);
            out[i] = (float) (y < 1 ? y : 1);
        }
    }

    private double[][] toYcxcz(float[] rgb) {
        int n = width * height;
        if (rgb.length != 3 * n) {
            throw new IllegalArgumentException(rgb.length + " samples for " + width + " x " + height + " x 3");
        }
        double[][] planes = new double[3][n];
        double[] color = new double[3];
        for (int p = 0; p < n; p++) {
            OpponentColor.toYcxcz(clamp(rgb[3 * p]), clamp(rgb[3 * p + 1]), clamp(rgb[3 * p + 2]), color);
            for (int c = 0; c < 3; c++) {
                planes[c][p] = color[c];
            }
        }
        return planes;
    }

    private static double clamp(float value) {
        return value > 0 ? Math.min(value, 1) : 0;
    }

    /** Distance of colours in a Hunt-adjusted L*a*b* space (2020, section 4.1.3; Abasi, Tehran and Fairchild 2020). */
    private static double hyab(double[] a, double[] b) {
        return Math.abs(a[0] - b[0]) + Math.hypot(a[1] - b[1], a[2] - b[2]);
    }

    /** The distance between pure green and pure blue: the largest there is. */
    private static double largestDifference() {
        double[] ycxcz = new double[3];
        double[] green = new double[3];
        double[] blue = new double[3];
        OpponentColor.toYcxcz(0, 1, 0, ycxcz);
        OpponentColor.toHuntLab(ycxcz[0], ycxcz[1], ycxcz[2], green);
        OpponentColor.toYcxcz(0, 0, 1, ycxcz);
        OpponentColor.toHuntLab(ycxcz[0], ycxcz[1], ycxcz[2], blue);
        return hyab(green, blue);
    }

    private static double redistribute(double difference, double largest) {
        double bend = SMALL_ERRORS * largest;
        return difference < bend
                ? SMALL_ERRORS_TO * difference / bend
                : SMALL_ERRORS_TO + (difference - bend) / (largest - bend) * (1 - SMALL_ERRORS_TO);
    }
}
