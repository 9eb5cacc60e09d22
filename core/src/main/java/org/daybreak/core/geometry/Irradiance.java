package org.daybreak.core.geometry;

import org.daybreak.core.math.Arcs;

/**
 * Irradiance of uniform emitters without occlusion, exact or estimated. Pure functions. They weigh lights against each
 * other, so an estimate must be good to some ten percent, cheap, and positive where the truth is.
 */
final class Irradiance {
    /** Clipped spheres with a smaller sine than this are treated as flat disks, where the exact formula cancels. */
    private static final double SMALL_SINE = 0.01;

    private Irradiance() {}

    /**
     * Mean of max(0, cosine) over the directions to a sphere, weighted by projected solid angle on its own: the factor
     * that turns π·sin²σ into the irradiance of a sphere partly below the horizon. Exact (Lagarde and de Rousiers, “Moving
     * Frostbite to PBR”, 2014, section 4.7.2.2) but for small clipped spheres.
     *
     * @param cosine cosine between the normal and the direction to the centre
     * @param sineSquared squared sine of the sphere's angular radius σ, in (0, 1]
     * @return 0 exactly if the sphere is below the horizon
     */
    static double meanCosine(double cosine, double sineSquared) {
        if (cosine > 0 && cosine * cosine >= sineSquared) {
            return cosine;
        }
        double sine = Math.sqrt(sineSquared);
        double above = cosine + sine;
        if (!(above > 0)) {
            return 0;
        }
        // The part of a flat disk above a line, times its mean height, with the right values at both ends.
        double flat = above * above / (4 * sine);
        if (sine < SMALL_SINE) {
            return flat;
        }
        double x = Math.sqrt((1 - sineSquared) / sineSquared);
        double sineTheta = Math.sqrt(Math.max(0, 1 - cosine * cosine));
        double y = Math.max(-1, Math.min(1, -x * cosine / sineTheta));
        double s = sineTheta * Math.sqrt((1 - y) * (1 + y));
        double exact = (cosine * Arcs.acos(y) - x * s + Arcs.atan2(s, x) / sineSquared) / Math.PI;
        return Math.max(exact, 0.05 * flat);
    }

    /**
     * Mean receiver cosine for an emitter within a sphere; 1 for the fluence (zero normal). From within the sphere the
     * emitter may be anywhere, so then the result is positive for every normal.
     *
     * @param dx vector from the point to the centre
     * @param squaredDistance its squared length
     */
    static double receiver(
            double dx,
            double dy,
            double dz,
            double squaredDistance,
            double squaredRadius,
            double nx,
            double ny,
            double nz) {
        if (nx == 0 && ny == 0 && nz == 0) {
            return 1;
        }
        double projected = dx * nx + dy * ny + dz * nz;
        if (squaredDistance > squaredRadius) {
            return meanCosine(projected / Math.sqrt(squaredDistance), squaredRadius / squaredDistance);
        }
        // Continues the value (1 + cos θ)/2 on the sphere to 1/2 at its centre.
        return Math.max(0.5 * (1 + projected / Math.sqrt(squaredRadius)), 1e-3);
    }

    /**
     * Irradiance of a parallelogram of unit radiance, for a point in front of it. The vector irradiance is Lambert's,
     * exact but for {@link #angleOverSine}. The clipping at the horizon is that of the sphere with the same vector
     * irradiance (Heitz and Hill, “Real-Time Line- and Disk-Light Shading”, 2017), so unclipped parallelograms are right.
     *
     * @param cx vector from the point to a corner
     * @param ax first edge from there
     * @param bx second edge from there
     */
    static double parallelogram(
            double cx,
            double cy,
            double cz,
            double ax,
            double ay,
            double az,
            double bx,
            double by,
            double bz,
            double nx,
            double ny,
            double nz) {
        double fx = 0;
        double fy = 0;
        double fz = 0;
        double highest = Double.NEGATIVE_INFINITY;
        double px = cx;
        double py = cy;
        double pz = cz;
        double inverseP = 1 / Math.sqrt(px * px + py * py + pz * pz);
        for (int i = 1; i <= 4; i++) {
            double a = i == 1 || i == 2 ? 1 : 0;
            double b = i == 2 || i == 3 ? 1 : 0;
            double qx = cx + a * ax + b * bx;
            double qy = cy + a * ay + b * by;
            double qz = cz + a * az + b * bz;
            double inverseQ = 1 / Math.sqrt(qx * qx + qy * qy + qz * qz);
            double scale = inverseP * inverseQ;
            double weight = scale * angleOverSine(scale * (px * qx + py * qy + pz * qz));
            fx += weight * (py * qz - pz * qy);
            fy += weight * (pz * qx - px * qz);
            fz += weight * (px * qy - py * qx);
            highest = Math.max(highest, qx * nx + qy * ny + qz * nz);
            px = qx;
            py = qy;
            pz = qz;
            inverseP = inverseQ;
        }
        double length = Math.sqrt(fx * fx + fy * fy + fz * fz);
        if (!(length > 0)) {
            return 0;
        }
        // The sum is 2π times the form factor of a patch that faces it.
        double form = Math.min(length / (2 * Math.PI), 1);
        if (nx == 0 && ny == 0 && nz == 0) {
            return 2 * Math.PI * form / (1 + Math.sqrt(1 - form));
        }
        if (!(highest > 0)) {
            return 0;
        }
        // The winding decides the sign of the sum; the emitter's side is known from a corner and the centre.
        double side = fx * (cx + 0.5 * (ax + bx)) + fy * (cy + 0.5 * (ay + by)) + fz * (cz + 0.5 * (az + bz));
        double projected = fx * nx + fy * ny + fz * nz;
        double cosine = (side < 0 ? -projected : projected) / length;
        return Math.PI * form * Math.max(meanCosine(cosine, form), 1e-3);
    }

    /**
     * θ/sin θ for a cosine, to 1.2e-4: the polynomial of degree 4 through the Chebyshev nodes of [0, 1], continued by
     * θ ↦ π − θ. Bounded at −1, where the true value has a pole.
     */
    private static double angleOverSine(double cosine) {
        double x = Math.min(Math.abs(cosine), 1);
        double acute = 1.57061462 + x * (-0.99075111 + x * (0.70437805 + x * (-0.38999851 + x * 0.10585294)));
        return cosine >= 0 ? acute : Math.PI / Math.sqrt(Math.max(1 - x * x, 1e-12)) - acute;
    }
}
