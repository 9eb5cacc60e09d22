package org.daybreak.metropolis.strategy;

import org.daybreak.core.math.Frame;
import org.daybreak.core.sampling.RandomStream;

/**
 * Small random changes whose size is distributed evenly on a logarithmic scale (Veach 1997, eq. 11.9): r = r₂·exp(−ln(r₂/r₁)·ξ), in any
 * direction alike.
 */
final class Tilt {
    /** No direction is tilted by more, in radians. */
    private static final double LARGEST = 0.5 * Math.PI;

    private Tilt() {}

    /** Draws the size of a change. */
    static double size(double smallest, double largest, double number) {
        return largest * Math.exp(-Math.log(largest / smallest) * number);
    }

    /**
     * Tilts a unit direction by an angle between two bounds.
     *
     * @param scale factor from the sizes to angles in radians
     * @return false if the bounds are empty
     */
    static boolean tilt(
            double x,
            double y,
            double z,
            double smallest,
            double largest,
            double scale,
            RandomStream random,
            RandomWalk out) {
        double low = smallest * scale;
        double high = Math.min(LARGEST, largest * scale);
        double number = random.nextDouble();
        double phi = 2 * Math.PI * random.nextDouble();
        if (!(low > 0) || !(low < high)) {
            return false;
        }
        Frame frame = out.frame();
        double theta = size(low, high, number);
        frame.set(x, y, z);
        double s = Math.sin(theta);
        double a = s * Math.cos(phi);
        double b = s * Math.sin(phi);
        double c = Math.cos(theta);
        out.setDirection(
                a * frame.sx + b * frame.tx + c * x,
                a * frame.sy + b * frame.ty + c * y,
                a * frame.sz + b * frame.tz + c * z);
        return true;
    }

    /** Density per solid angle of tilting one unit direction to another, with bounds as for {@link #tilt}. */
    static double density(
            double x,
            double y,
            double z,
            double toX,
            double toY,
            double toZ,
            double smallest,
            double largest,
            double scale) {
        double low = smallest * scale;
        double high = Math.min(LARGEST, largest * scale);
        double cx = y * toZ - z * toY;
        double cy = z * toX - x * toZ;
        double cz = x * toY - y * toX;
        double sine = Math.sqrt(cx * cx + cy * cy + cz * cz);
        double theta = Math.atan2(sine, x * toX + y * toY + z * toZ);
        if (!(low > 0) || !(low < high) || theta < low || theta > high) {
            return 0;
        }
        return 1 / (2 * Math.PI * sine * theta * Math.log(high / low));
    }
}
