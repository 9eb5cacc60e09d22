package org.daybreak.core.light;

import java.util.Arrays;

/**
 * Luminous intensity of a luminaire over directions: type C photometry, bilinear in the vertical angle from the axis and the
 * horizontal angle about it. Immutable.
 */
public final class PhotometricProfile {
    private final double[] vertical;
    private final double[] horizontal;
    private final double[] candela;

    /**
     * Creates a profile.
     *
     * @param vertical angles from the axis in degrees, ascending, from 0 to 180; beyond them there is no light
     * @param horizontal angles about the axis in degrees, ascending: a single 0 for symmetry about the axis, or from 0 to 90
     *     (symmetric about both planes), 180 (about one) or 360
     * @param candela intensity for each horizontal angle, and in it each vertical one; not negative
     * @throws IllegalArgumentException if the angles or the number of values are not as described
     */
    public PhotometricProfile(double[] vertical, double[] horizontal, double[] candela) {
        this.vertical = checked("vertical", vertical, 180);
        this.horizontal = checked("horizontal", horizontal, 360);
        double last = horizontal[horizontal.length - 1];
        if (horizontal[0] != 0 || (last != 0 && last != 90 && last != 180 && last != 360)) {
            throw new IllegalArgumentException(
                    "the horizontal angles must go from 0 to 0, 90, 180 or 360 degrees but go" + " from "
                            + horizontal[0] + " to " + last);
        }
        if ((long) vertical.length * horizontal.length != candela.length) {
            throw new IllegalArgumentException("there must be " + vertical.length + " x " + horizontal.length
                    + " candela values but there are " + candela.length);
        }
        for (double c : candela) {
            if (!(c >= 0) || Double.isInfinite(c)) {
                throw new IllegalArgumentException("candela values must not be negative but one is " + c);
            }
        }
        this.candela = candela.clone();
    }

    private static double[] checked(String name, double[] angles, double largest) {
        if (angles.length == 0) {
            throw new IllegalArgumentException("there are no " + name + " angles");
        }
        for (int i = 0; i < angles.length; i++) {
            if (!(angles[i] >= 0 && angles[i] <= largest) || (i > 0 && !(angles[i] > angles[i - 1]))) {
                throw new IllegalArgumentException("the " + name + " angles must ascend from 0 to at most " + largest
                        + " degrees but contain " + angles[i]);
            }
        }
        return angles.clone();
    }

    /** Largest intensity in candela. */
    public double maximum() {
        return Arrays.stream(candela).max().orElse(0);
    }

    /** Intensity in candela for a unit direction; +z is the axis, horizontal angles run from +x to +y. */
    public double candela(double x, double y, double z) {
        double theta = Math.toDegrees(Math.acos(Math.max(-1, Math.min(1, z))));
        if (theta < vertical[0] || theta > vertical[vertical.length - 1]) {
            return 0;
        }
        double last = horizontal[horizontal.length - 1];
        double phi = 0;
        if (last > 0) {
            phi = Math.toDegrees(Math.atan2(y, x));
            phi = phi < 0 ? phi + 360 : phi;
            if (last <= 180) {
                phi = phi > 180 ? 360 - phi : phi;
            }
            if (last <= 90) {
                phi = phi > 90 ? 180 - phi : phi;
            }
        }
        int h = interval(horizontal, phi);
        int v = interval(vertical, theta);
        double below = row(h, v, theta);
        if (h + 1 == horizontal.length) {
            return below;
        }
        double t = (phi - horizontal[h]) / (horizontal[h + 1] - horizontal[h]);
        return below + t * (row(h + 1, v, theta) - below);
    }

    private double row(int h, int v, double theta) {
        double value = candela[h * vertical.length + v];
        if (v + 1 == vertical.length) {
            return value;
        }
        double t = (theta - vertical[v]) / (vertical[v + 1] - vertical[v]);
        return value + t * (candela[h * vertical.length + v + 1] - value);
    }

    /** Index of the interval that holds a value; the last one that starts before the end, if there are two angles or more. */
    private static int interval(double[] angles, double value) {
        int at = Arrays.binarySearch(angles, value);
        int index = at >= 0 ? at : -at - 2;
        return Math.max(0, Math.min(index, Math.max(0, angles.length - 2)));
    }
}
