package org.daybreak.core.sampling;

import org.daybreak.core.math.Densities;
import org.daybreak.core.math.Scalars;

/**
 * A rectangle as seen from a point, sampled uniformly by solid angle.
 *
 * <p>Ureña, Fajardo and King, “An Area-Preserving Parametrization for Spherical Rectangles”, CGF 32(4), 2013, with
 * their angles γ written as π/2 plus a rest, which keeps the precision for rectangles that are far away. Where the
 * solid angle is too small even so, points are sampled uniformly by area.
 *
 * <p>Mutable, one per worker: {@link #set} for each pair of rectangle and point.
 */
public final class SphericalRectangle {
    /** Below this the cancellation in the solid angle, some 1e-15, would be visible in the density. */
    private static final double LEAST_SOLID_ANGLE = 1e-7;

    private double originX;
    private double originY;
    private double originZ;
    /** Local axes: x and y along the edges, z from the rectangle to the origin. */
    private double axisXx;

    private double axisXy;
    private double axisXz;
    private double axisYx;
    private double axisYy;
    private double axisYz;
    private double axisZx;
    private double axisZy;
    private double axisZz;
    /** The rectangle in local coordinates about the origin: [x0, x1] × [y0, y1] at z0 ≤ 0. */
    private double x0;

    private double x1;
    private double y0;
    private double y1;
    private double z0;
    private double b0;
    private double b1;
    /** Sine and cosine of the angle w at u = 0; up to u = 1 it grows by the solid angle. */
    private double firstSine;

    private double firstCosine;

    private double solidAngle;
    private double area;

    /** Creates an object that must be {@link #set} before use. */
    public SphericalRectangle() {}

    /**
     * Sets the rectangle and the point that sees it.
     *
     * @param corner a corner, in world coordinates
     * @param edgeX the edge from the corner along the local x axis
     * @param edgeY the edge from the corner along the local y axis, perpendicular to {@code edgeX}
     * @param fromX x of the point that sees the rectangle
     * @param fromY y of the point
     * @param fromZ z of the point
     */
    public void set(double[] corner, double[] edgeX, double[] edgeY, double fromX, double fromY, double fromZ) {
        originX = fromX;
        originY = fromY;
        originZ = fromZ;
        double lengthX = Math.sqrt(edgeX[0] * edgeX[0] + edgeX[1] * edgeX[1] + edgeX[2] * edgeX[2]);
        double lengthY = Math.sqrt(edgeY[0] * edgeY[0] + edgeY[1] * edgeY[1] + edgeY[2] * edgeY[2]);
        area = lengthX * lengthY;
        axisXx = edgeX[0] / lengthX;
        axisXy = edgeX[1] / lengthX;
        axisXz = edgeX[2] / lengthX;
        axisYx = edgeY[0] / lengthY;
        axisYy = edgeY[1] / lengthY;
        axisYz = edgeY[2] / lengthY;
        axisZx = axisXy * axisYz - axisXz * axisYy;
        axisZy = axisXz * axisYx - axisXx * axisYz;
        axisZz = axisXx * axisYy - axisXy * axisYx;
        double dx = corner[0] - fromX;
        double dy = corner[1] - fromY;
        double dz = corner[2] - fromZ;
        z0 = dx * axisZx + dy * axisZy + dz * axisZz;
        if (z0 > 0) {
            z0 = -z0;
            axisZx = -axisZx;
            axisZy = -axisZy;
            axisZz = -axisZz;
        }
        x0 = dx * axisXx + dy * axisXy + dz * axisXz;
        y0 = dx * axisYx + dy * axisYy + dz * axisYz;
        x1 = x0 + lengthX;
        y1 = y0 + lengthY;
        double z = -z0;
        double lengthX0 = Math.sqrt(x0 * x0 + z * z);
        double lengthX1 = Math.sqrt(x1 * x1 + z * z);
        double lengthY0 = Math.sqrt(y0 * y0 + z * z);
        double lengthY1 = Math.sqrt(y1 * y1 + z * z);
        // Heights of the unit normals of the four planes through the origin and an edge.
        double n0 = -y0 / lengthY0;
        double n1 = x1 / lengthX1;
        double n2 = y1 / lengthY1;
        double n3 = -x0 / lengthX0;
        b0 = n0;
        b1 = n2;
        // Sine and cosine of γ − π/2 at the four corners. The cosines are not taken from the sines, which would lose
        // grazing views. The angles are added as unit complex numbers, which saves all arc functions but one.
        double sin0 = n0 * n1;
        double cos0 = z * Math.sqrt(x1 * x1 + y0 * y0 + z * z) / (lengthX1 * lengthY0);
        double sin1 = n1 * n2;
        double cos1 = z * Math.sqrt(x1 * x1 + y1 * y1 + z * z) / (lengthX1 * lengthY1);
        double sin2 = n2 * n3;
        double cos2 = z * Math.sqrt(x0 * x0 + y1 * y1 + z * z) / (lengthX0 * lengthY1);
        double sin3 = n3 * n0;
        double cos3 = z * Math.sqrt(x0 * x0 + y0 * y0 + z * z) / (lengthX0 * lengthY0);
        double sin01 = sin0 * cos1 + cos0 * sin1;
        double cos01 = cos0 * cos1 - sin0 * sin1;
        double sin23 = sin2 * cos3 + cos2 * sin3;
        double cos23 = cos2 * cos3 - sin2 * sin3;
        double angle = Math.atan2(sin01 * cos23 + cos01 * sin23, cos01 * cos23 - sin01 * sin23);
        // Only a rectangle under the origin spans more than π; elsewhere a negative angle is a rounding error of 0.
        boolean under = x0 < 0 && x1 > 0 && y0 < 0 && y1 > 0;
        solidAngle = angle >= 0 ? angle : under ? angle + 2 * Math.PI : 0;
        firstSine = -sin23;
        firstCosine = cos23;
    }

    /** The solid angle of the rectangle in steradians, 0 … 2π, with an absolute error of about 1e-15. */
    public double solidAngle() {
        return solidAngle;
    }

    /**
     * Samples a point of the rectangle.
     *
     * @param dest receives the point, in world coordinates
     * @return density of the direction to it, per solid angle at the point that sees it; 0 if the rectangle is seen
     *     edge-on, and then no point is written
     */
    public double sample(double u, double v, double[] dest) {
        if (z0 == 0 || !(area > 0)) {
            return 0;
        }
        double x;
        double y;
        double density;
        if (solidAngle < LEAST_SOLID_ANGLE) {
            x = Scalars.lerp(u, x0, x1);
            y = Scalars.lerp(v, y0, y1);
            density = densityByArea(x, y);
        } else {
            x = sampleX(u);
            double squared = x * x + z0 * z0;
            double h0 = y0 / Math.sqrt(squared + y0 * y0);
            double h1 = y1 / Math.sqrt(squared + y1 * y1);
            double h = Scalars.lerp(v, h0, h1);
            double cosSquared = (1 - h) * (1 + h);
            y = cosSquared > 0 ? h * Math.sqrt(squared / cosSquared) : h;
            y = Scalars.clamp(y, y0, y1);
            density = 1 / solidAngle;
        }
        dest[0] = originX + x * axisXx + y * axisYx + z0 * axisZx;
        dest[1] = originY + x * axisXy + y * axisYy + z0 * axisZy;
        dest[2] = originZ + x * axisXz + y * axisYz + z0 * axisZz;
        return density;
    }

    /**
     * Density with which {@link #sample} chooses a direction, per solid angle.
     *
     * @param x x of a direction of any length from the point that sees the rectangle, in world coordinates
     * @param y y of the direction
     * @param z z of the direction
     * @return the density; 0 for a direction that misses the rectangle
     */
    public double density(double x, double y, double z) {
        double height = x * axisZx + y * axisZy + z * axisZz;
        if (!(height < 0) || z0 == 0) {
            return 0;
        }
        double t = z0 / height;
        double localX = t * (x * axisXx + y * axisXy + z * axisXz);
        double localY = t * (x * axisYx + y * axisYy + z * axisYz);
        if (localX < x0 || localX > x1 || localY < y0 || localY > y1) {
            return 0;
        }
        return solidAngle < LEAST_SOLID_ANGLE ? densityByArea(localX, localY) : 1 / solidAngle;
    }

    private double densityByArea(double x, double y) {
        double squaredDistance = x * x + y * y + z0 * z0;
        return Densities.areaToSolidAngle(1 / area, squaredDistance, z0 / Math.sqrt(squaredDistance));
    }

    /** The x below which lies the part u of the solid angle (Ureña et al., section 4.1). */
    private double sampleX(double u) {
        double sine = Math.sin(u * solidAngle);
        double cosine = Math.cos(u * solidAngle);
        double sinW = firstSine * cosine + firstCosine * sine;
        double cosW = firstCosine * cosine - firstSine * sine;
        // f = ±∞ where w = 0, which is right: x = 0.
        double f = (cosW * b0 + b1) / sinW;
        double c = Math.copySign(1 / Math.sqrt(f * f + b0 * b0), f);
        double sineSquared = (1 - c) * (1 + c);
        double x = sineSquared > 0 ? -c * z0 / Math.sqrt(sineSquared) : Math.copySign(Double.POSITIVE_INFINITY, c);
        return Scalars.clamp(x, x0, x1);
    }
}
