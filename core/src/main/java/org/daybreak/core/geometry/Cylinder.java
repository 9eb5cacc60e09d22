package org.daybreak.core.geometry;

import javax.vecmath.Point3d;

/**
 * The lateral surface of a circular cylinder, without caps. Texture coordinates: u = φ/2π, v = position along the axis from
 * {@code from} (0) to {@code to} (1). The normal points outwards.
 *
 * @param from centre of one end
 * @param to centre of the other end, different from the first
 * @param radius radius, positive and finite
 */
public record Cylinder(Point3d from, Point3d to, double radius) implements Shape {
    /** Copies the points and checks the numbers. */
    public Cylinder {
        from = new Point3d(from);
        to = new Point3d(to);
        Shapes.requireFinite("cylinder end", from);
        Shapes.requireFinite("cylinder end", to);
        Shapes.requirePositive("cylinder radius", radius);
        Shapes.requirePositive("cylinder length", from.distance(to));
    }

    @Override
    public Point3d from() {
        return new Point3d(from);
    }

    @Override
    public Point3d to() {
        return new Point3d(to);
    }
}
