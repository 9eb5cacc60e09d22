package org.daybreak.core.geometry;

import org.daybreak.core.math.Arcs;
import org.daybreak.core.math.Turns;

/**
 * Sampling of rectangles by solid angle (Ureña, Fajardo and King, “An Area-Preserving Parametrization for Spherical
 * Rectangles”, CGF 32(4), 2013). Pure functions on the rectangle [x0, x1] × [y0, y1] at height −z below the origin, z &gt; 0;
 * intermediate results go into a caller-owned array.
 *
 * <p>The angles γ of the paper are written as π/2 plus a rest, and added as unit complex numbers: that keeps the precision
 * for rectangles that are far away and needs one arc function in place of four.
 */
final class SphericalRectangles {
    private static final int FIRST_SINE = 0;
    private static final int FIRST_COSINE = 1;
    private static final int B0 = 2;
    private static final int B1 = 3;

    private SphericalRectangles() {}

    /**
     * The solid angle, with an absolute error of about 1e-15.
     *
     * @param work receives in its first four elements what {@link #sampleX} needs
     */
    static double solidAngle(double x0, double x1, double y0, double y1, double z, double[] work) {
        double squaredZ = z * z;
        double lengthX0 = Math.sqrt(x0 * x0 + squaredZ);
        double lengthX1 = Math.sqrt(x1 * x1 + squaredZ);
        double lengthY0 = Math.sqrt(y0 * y0 + squaredZ);
        double lengthY1 = Math.sqrt(y1 * y1 + squaredZ);
        // Heights of the unit normals of the four planes through the origin and an edge.
        double n0 = -y0 / lengthY0;
        double n1 = x1 / lengthX1;
        double n2 = y1 / lengthY1;
        double n3 = -x0 / lengthX0;
        // Sine and cosine of γ − π/2 at the four corners. Cosines taken from the sines would lose grazing views.
        double sin0 = n0 * n1;
        double cos0 = z * Math.sqrt(x1 * x1 + y0 * y0 + squaredZ) / (lengthX1 * lengthY0);
        double sin1 = n1 * n2;
        double cos1 = z * Math.sqrt(x1 * x1 + y1 * y1 + squaredZ) / (lengthX1 * lengthY1);
        double sin2 = n2 * n3;
        double cos2 = z * Math.sqrt(x0 * x0 + y1 * y1 + squaredZ) / (lengthX0 * lengthY1);
        double sin3 = n3 * n0;
        double cos3 = z * Math.sqrt(x0 * x0 + y0 * y0 + squaredZ) / (lengthX0 * lengthY0);
        double sin01 = sin0 * cos1 + cos0 * sin1;
        double cos01 = cos0 * cos1 - sin0 * sin1;
        double sin23 = sin2 * cos3 + cos2 * sin3;
        double cos23 = cos2 * cos3 - sin2 * sin3;
        double angle = Arcs.atan2(sin01 * cos23 + cos01 * sin23, cos01 * cos23 - sin01 * sin23);
        work[FIRST_SINE] = -sin23;
        work[FIRST_COSINE] = cos23;
        work[B0] = n0;
        work[B1] = n2;
        // Only a rectangle under the origin spans more than π; elsewhere a negative angle is a rounding error of 0.
        boolean under = x0 < 0 && x1 > 0 && y0 < 0 && y1 > 0;
        return angle >= 0 ? angle : under ? angle + 2 * Math.PI : 0;
    }

    /**
     * The x coordinate below which lies the part u of the solid angle.
     *
     * @param solidAngle the solid angle; positive
     * @param work as {@link #solidAngle} left it
     */
    static double sampleX(double u, double solidAngle, double x0, double x1, double z, double[] work) {
        double turns = u * (solidAngle / (2 * Math.PI));
        double sine = Turns.sin(turns);
        double cosine = Turns.cos(turns);
        double sinW = work[FIRST_SINE] * cosine + work[FIRST_COSINE] * sine;
        double cosW = work[FIRST_COSINE] * cosine - work[FIRST_SINE] * sine;
        double b0 = work[B0];
        // f is infinite where w = 0, which is right: x = 0.
        double f = (cosW * b0 + work[B1]) / sinW;
        double c = Math.copySign(1 / Math.sqrt(f * f + b0 * b0), f);
        double sineSquared = (1 - c) * (1 + c);
        double x = sineSquared > 0 ? c * z / Math.sqrt(sineSquared) : Math.copySign(Double.POSITIVE_INFINITY, c);
        return Math.max(x0, Math.min(x1, x));
    }

    /** The y coordinate of the point at x that has the part v of the strip's solid angle below it. */
    static double sampleY(double v, double x, double y0, double y1, double z) {
        double squared = x * x + z * z;
        double h0 = y0 / Math.sqrt(squared + y0 * y0);
        double h1 = y1 / Math.sqrt(squared + y1 * y1);
        double h = (1 - v) * h0 + v * h1;
        double cosineSquared = (1 - h) * (1 + h);
        double y = cosineSquared > 0 ? h * Math.sqrt(squared / cosineSquared) : h;
        return Math.max(y0, Math.min(y1, y));
    }
}
