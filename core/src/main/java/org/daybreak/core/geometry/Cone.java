package org.daybreak.core.geometry;

import javax.vecmath.Point3d;

/**
 * The lateral surface of a circular cone or frustum, without caps. Texture coordinates: u = φ/2π about the axis, v = position
 * along the axis from {@code from} (0) to {@code to} (1). The normal points outwards.
 *
 * @param from centre of one end
 * @param to centre of the other end, different from the first
 * @param fromRadius radius at {@code from}, finite and not negative
 * @param toRadius radius at {@code to}, finite and not negative; one of the two is positive
 */
public record Cone(Point3d from, Point3d to, double fromRadius, double toRadius) implements Shape {
    /** Copies the points and checks the numbers. */
    public Cone {
        from = new Point3d(from);
        to = new Point3d(to);
        Shapes.requireFinite("cone end", from);
        Shapes.requireFinite("cone end", to);
        Shapes.requirePositive("cone length", from.distance(to));
        if (!(fromRadius >= 0 && toRadius >= 0)) {
            throw new IllegalArgumentException(
                    "cone radii must not be negative but are " + fromRadius + " and " + toRadius);
        }
        Shapes.requirePositive("larger cone radius", Math.max(fromRadius, toRadius));
    }

    @Override
    public Point3d from() {
        return new Point3d(from);
    }

    @Override
    public Point3d to() {
        return new Point3d(to);
    }

    /** Whether the wider end, where the canonical cone has z = 0, is {@code to}. */
    public boolean widens() {
        return toRadius > fromRadius;
    }

    /** Loss of radius from the wider to the narrower end, as a part of the wider radius: 0 for a cylinder, 1 for a tip. */
    public double taper() {
        return 1 - Math.min(fromRadius, toRadius) / Math.max(fromRadius, toRadius);
    }
}
