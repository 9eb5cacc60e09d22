package org.daybreak.core.geometry;

import javax.vecmath.Point3d;

/**
 * A sphere. Texture coordinates: u = φ/2π around the z axis, v = θ/π from +z. The normal points outwards.
 *
 * @param centre centre
 * @param radius radius, positive and finite
 */
public record Sphere(Point3d centre, double radius) implements Shape {
    /** Copies the centre and checks the numbers. */
    public Sphere {
        centre = new Point3d(centre);
        Shapes.requireFinite("sphere centre", centre);
        Shapes.requirePositive("sphere radius", radius);
    }

    @Override
    public Point3d centre() {
        return new Point3d(centre);
    }
}
