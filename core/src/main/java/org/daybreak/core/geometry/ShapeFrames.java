package org.daybreak.core.geometry;

import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import org.daybreak.core.math.Frame;
import org.daybreak.core.math.Transform;

/**
 * The maps that carry canonical quadrics to the places their shapes describe. Intersection and sampling both use them, so
 * that a texture lies the same for both.
 */
public final class ShapeFrames {
    private ShapeFrames() {}

    /** The map from the unit sphere at the origin to a sphere. */
    public static Transform of(Sphere sphere) {
        Point3d centre = sphere.centre();
        double r = sphere.radius();
        return Transform.ofRows(r, 0, 0, centre.x, 0, r, 0, centre.y, 0, 0, r, centre.z);
    }

    /**
     * The map from the canonical cone x² + y² = (1 − t·z)², 0 ≤ z ≤ 1, t the {@linkplain Cone#taper taper}, to a cone. Its
     * wider end is at z = 0. The direction φ = 0 is that of a cylinder with the same axis; if the cone widens, φ runs the
     * other way around, as z runs the other way along.
     */
    public static Transform of(Cone cone) {
        Transform cylinder = of(new Cylinder(cone.from(), cone.to(), Math.max(cone.fromRadius(), cone.toRadius())));
        return cone.widens() ? cylinder.multiply(Transform.ofRows(1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 1)) : cylinder;
    }

    /**
     * The map from the canonical cylinder x² + y² = 1, 0 ≤ z ≤ 1 to a cylinder. The direction φ = 0 is the first tangent of
     * {@link Frame#set(double, double, double)} for the axis, as in Mitsuba.
     */
    public static Transform of(Cylinder cylinder) {
        Point3d from = cylinder.from();
        Vector3d axis = new Vector3d(cylinder.to());
        axis.sub(from);
        double length = axis.length();
        double r = cylinder.radius();
        Frame frame = new Frame();
        frame.set(axis.x / length, axis.y / length, axis.z / length);
        return Transform.ofRows(
                r * frame.sx,
                r * frame.tx,
                axis.x,
                from.x,
                r * frame.sy,
                r * frame.ty,
                axis.y,
                from.y,
                r * frame.sz,
                r * frame.tz,
                axis.z,
                from.z);
    }
}
