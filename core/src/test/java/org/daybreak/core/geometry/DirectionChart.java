package org.daybreak.core.geometry;

/**
 * An area-preserving chart of directions (Lambert's azimuthal projection), centred on an axis: what a small or far light covers fills
 * it, so that a χ² test resolves it. The whole sphere is the disk of radius 2.
 */
public final class DirectionChart {
    private final double[] axis;
    private final double[] first;
    private final double[] second;

    /** Creates a chart around a direction, which need not be of unit length. */
    public DirectionChart(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        axis = new double[] {x / length, y / length, z / length};
        double[] other = Math.abs(axis[0]) < 0.5 ? new double[] {1, 0, 0} : new double[] {0, 1, 0};
        double[] cross = cross(axis, other);
        double norm = Math.sqrt(cross[0] * cross[0] + cross[1] * cross[1] + cross[2] * cross[2]);
        first = new double[] {cross[0] / norm, cross[1] / norm, cross[2] / norm};
        second = cross(axis, first);
    }

    /** Writes the chart coordinates of a unit direction. */
    public void toChart(double dx, double dy, double dz, double[] dest) {
        double a = dot(first, dx, dy, dz);
        double b = dot(second, dx, dy, dz);
        double c = dot(axis, dx, dy, dz);
        // r = 2 sin(θ/2) = sin θ / cos(θ/2), and beyond the right angle r is known from the height itself.
        double sine = Math.sqrt(a * a + b * b);
        double r = c > 0 ? sine * Math.sqrt(2 / (1 + c)) : Math.sqrt(2 * (1 - c));
        dest[0] = sine > 0 ? r * a / sine : r;
        dest[1] = sine > 0 ? r * b / sine : 0;
    }

    /** Writes the unit direction of a point of the chart; false if there is none. */
    public boolean toDirection(double x, double y, double[] dest) {
        double squared = x * x + y * y;
        if (squared > 4) {
            return false;
        }
        double c = 1 - 0.5 * squared;
        double scale = Math.sqrt(Math.max(0, 1 - 0.25 * squared));
        for (int i = 0; i < 3; i++) {
            dest[i] = scale * (x * first[i] + y * second[i]) + c * axis[i];
        }
        return true;
    }

    private static double dot(double[] v, double x, double y, double z) {
        return v[0] * x + v[1] * y + v[2] * z;
    }

    private static double[] cross(double[] a, double[] b) {
        return new double[] {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    }
}
