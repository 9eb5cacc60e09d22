package org.daybreak.core.accel;

/**
 * An analytic surface: a canonical shape under an arbitrary invertible affine map (non-uniform scale, shear and
 * mirroring included).
 */
public final class Quadric {
    /** The canonical shapes in object space. */
    public enum Kind {
        /** x² + y² + z² = 1. */
        SPHERE,
        /** z = 0, x² + y² ≤ 1. */
        DISK,
        /** x² + y² = 1, 0 ≤ z ≤ 1; the lateral surface only. */
        CYLINDER,
        /** x² + y² = (1 − t·z)², 0 ≤ z ≤ 1, with a taper t from 0 to 1; the lateral surface only. */
        CONE
    }

    private static final int SPHERE_TAG = 0;
    private static final int DISK_TAG = 1;
    private static final int CYLINDER_TAG = 2;
    private static final int CONE_TAG = 3;

    private final Kind kind;
    private final double[] objectToWorld;
    private final double[] worldToObject;
    private final double taper;

    /**
     * Creates a surface.
     *
     * @param kind canonical shape
     * @param objectToWorld rows of the 3×4 matrix that maps the canonical shape to its place
     * @param worldToObject its inverse
     * @throws IllegalArgumentException if an entry is not finite or the maps are not inverse to each other
     */
    public Quadric(Kind kind, double[] objectToWorld, double[] worldToObject) {
        this(kind, kind == Kind.CONE ? 1 : 0, objectToWorld, worldToObject);
    }

    /**
     * Creates a surface.
     *
     * @param kind canonical shape
     * @param taper of a cone, from 0 to 1; for other kinds 0
     * @param objectToWorld rows of the 3×4 matrix that maps the canonical shape to its place
     * @param worldToObject its inverse
     * @throws IllegalArgumentException if an entry is not finite, the maps are not inverse to each other, or the taper is
     *     out of range
     */
    public Quadric(Kind kind, double taper, double[] objectToWorld, double[] worldToObject) {
        Affine.check(objectToWorld, worldToObject);
        if (!(taper >= 0 && taper <= 1) || (kind != Kind.CONE && taper != 0)) {
            throw new IllegalArgumentException("a " + kind + " cannot have the taper " + taper);
        }
        this.kind = kind;
        this.taper = taper;
        this.objectToWorld = objectToWorld.clone();
        this.worldToObject = worldToObject.clone();
    }

    /**
     * Creates a surface, computing the inverse map.
     *
     * @param kind canonical shape
     * @param objectToWorld rows of the 3×4 matrix that maps the canonical shape to its place
     * @throws IllegalArgumentException if an entry is not finite or the map is singular
     */
    public Quadric(Kind kind, double[] objectToWorld) {
        this(kind, objectToWorld, Affine.invert(objectToWorld));
    }

    /**
     * A cone with another taper in the same place.
     *
     * @throws IllegalArgumentException if this is no cone or the taper is not from 0 to 1
     */
    public Quadric withTaper(double newTaper) {
        return new Quadric(kind, newTaper, objectToWorld, worldToObject);
    }

    /** Canonical shape. */
    public Kind kind() {
        return kind;
    }

    /** Taper of a cone; 0 for other kinds. */
    public double taper() {
        return taper;
    }

    /** The kind as the number that kernels switch on. */
    int tag() {
        return switch (kind) {
            case SPHERE -> SPHERE_TAG;
            case DISK -> DISK_TAG;
            case CYLINDER -> CYLINDER_TAG;
            case CONE -> CONE_TAG;
        };
    }

    /** Entry of the map from object to world; row-major 3×4. */
    public double objectToWorld(int entry) {
        return objectToWorld[entry];
    }

    /** Entry of the map from world to object; row-major 3×4. */
    public double worldToObject(int entry) {
        return worldToObject[entry];
    }

    /** Writes the map from world to object to 12 entries of the target. */
    void copyWorldToObject(double[] target, int offset) {
        System.arraycopy(worldToObject, 0, target, offset, 12);
    }

    /**
     * Writes conservative bounds: minimum x, y, z, maximum x, y, z. The extent of the image of the unit ball along an
     * axis is the norm of that row of the matrix.
     */
    void bounds(double[] target) {
        for (int axis = 0; axis < 3; axis++) {
            double a = objectToWorld[4 * axis];
            double b = objectToWorld[4 * axis + 1];
            double c = objectToWorld[4 * axis + 2];
            double centre = objectToWorld[4 * axis + 3];
            double radius = Math.sqrt(a * a + b * b + (kind == Kind.SPHERE ? c * c : 0));
            double shift = kind == Kind.CYLINDER || kind == Kind.CONE ? c : 0;
            double farRadius = radius * (1 - taper);
            double low = centre + Math.min(-radius, shift - farRadius);
            double high = centre + Math.max(radius, shift + farRadius);
            double rounding = 0x1p-48 * (Math.abs(centre) + radius + Math.abs(shift));
            target[axis] = low - rounding;
            target[axis + 3] = high + rounding;
        }
    }

    /**
     * Least parameter in (0, tMax) at which a ray meets a quadric.
     *
     * @param tag {@link #tag} of the quadric
     * @param taper of a cone, else 0
     * @param m array that holds the map from world to object
     * @param at where in the array it starts
     * @return the parameter, or +∞ if there is none
     */
    static double intersect(
            int tag,
            double taper,
            double[] m,
            int at,
            double wox,
            double woy,
            double woz,
            double wdx,
            double wdy,
            double wdz,
            double tMax) {
        double oz = m[at + 8] * wox + m[at + 9] * woy + m[at + 10] * woz + m[at + 11];
        double dz = m[at + 8] * wdx + m[at + 9] * wdy + m[at + 10] * wdz;
        double ox = m[at] * wox + m[at + 1] * woy + m[at + 2] * woz + m[at + 3];
        double oy = m[at + 4] * wox + m[at + 5] * woy + m[at + 6] * woz + m[at + 7];
        double dx = m[at] * wdx + m[at + 1] * wdy + m[at + 2] * wdz;
        double dy = m[at + 4] * wdx + m[at + 5] * wdy + m[at + 6] * wdz;
        return switch (tag) {
            case SPHERE_TAG -> sphere(ox, oy, oz, dx, dy, dz, tMax);
            case DISK_TAG -> disk(ox, oy, oz, dx, dy, dz, tMax);
            case CYLINDER_TAG -> cylinder(ox, oy, oz, dx, dy, dz, tMax);
            default -> cone(taper, ox, oy, oz, dx, dy, dz, tMax);
        };
    }

    /**
     * The discriminant comes from the distance of the line from the centre, which keeps its digits when the origin is
     * far away; the root that would cancel comes from Vieta's formula.
     */
    private static double sphere(double ox, double oy, double oz, double dx, double dy, double dz, double tMax) {
        double a = dx * dx + dy * dy + dz * dz;
        double b = -(ox * dx + oy * dy + oz * dz);
        double closest = b / a;
        double fx = ox + closest * dx;
        double fy = oy + closest * dy;
        double fz = oz + closest * dz;
        double rest = 1 - (fx * fx + fy * fy + fz * fz);
        if (!(rest >= 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double c = ox * ox + oy * oy + oz * oz - 1;
        double q = b + Math.copySign(Math.sqrt(a * rest), b);
        double t0 = c / q;
        double t1 = q / a;
        double near = Math.min(t0, t1);
        if (near > 0) {
            return near < tMax ? near : Double.POSITIVE_INFINITY;
        }
        double far = Math.max(t0, t1);
        return far > 0 && far < tMax ? far : Double.POSITIVE_INFINITY;
    }

    private static double disk(double ox, double oy, double oz, double dx, double dy, double dz, double tMax) {
        double t = -oz / dz;
        if (!(t > 0 && t < tMax)) {
            return Double.POSITIVE_INFINITY;
        }
        double x = ox + t * dx;
        double y = oy + t * dy;
        return x * x + y * y <= 1 ? t : Double.POSITIVE_INFINITY;
    }

    private static double cylinder(double ox, double oy, double oz, double dx, double dy, double dz, double tMax) {
        double a = dx * dx + dy * dy;
        double b = -(ox * dx + oy * dy);
        double closest = b / a;
        double fx = ox + closest * dx;
        double fy = oy + closest * dy;
        double rest = 1 - (fx * fx + fy * fy);
        if (!(rest >= 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double c = ox * ox + oy * oy - 1;
        double q = b + Math.copySign(Math.sqrt(a * rest), b);
        double t0 = c / q;
        double t1 = q / a;
        double near = Math.min(t0, t1);
        if (near > 0 && near < tMax) {
            double z = oz + near * dz;
            if (z >= 0 && z <= 1) {
                return near;
            }
        }
        double far = Math.max(t0, t1);
        if (far > 0 && far < tMax) {
            double z = oz + far * dz;
            if (z >= 0 && z <= 1) {
                return far;
            }
        }
        return Double.POSITIVE_INFINITY;
    }

    /**
     * The discriminant does not change along the ray, so that it is taken at the point nearest to the middle of the cone,
     * where it keeps its digits; coefficients and roots are those at the origin, as for the sphere.
     */
    private static double cone(
            double taper, double ox, double oy, double oz, double dx, double dy, double dz, double tMax) {
        double slope = taper * dz;
        double a = dx * dx + dy * dy - slope * slope;
        double nearest = -(ox * dx + oy * dy + (oz - 0.5) * dz) / (dx * dx + dy * dy + dz * dz);
        double fx = ox + nearest * dx;
        double fy = oy + nearest * dy;
        double fr = 1 - taper * (oz + nearest * dz);
        double fb = fx * dx + fy * dy + fr * slope;
        double discriminant = fb * fb - a * (fx * fx + fy * fy - fr * fr);
        if (!(discriminant >= 0)) {
            return Double.POSITIVE_INFINITY;
        }
        double r = 1 - taper * oz;
        double b = -(ox * dx + oy * dy + r * slope);
        double c = ox * ox + oy * oy - r * r;
        double q = b + Math.copySign(Math.sqrt(discriminant), b);
        double t0 = c / q;
        double t1 = q / a;
        double near = Math.min(t0, t1);
        if (near > 0 && near < tMax) {
            double z = oz + near * dz;
            if (z >= 0 && z <= 1) {
                return near;
            }
        }
        double far = Math.max(t0, t1);
        if (far > 0 && far < tMax) {
            double z = oz + far * dz;
            if (z >= 0 && z <= 1) {
                return far;
            }
        }
        return Double.POSITIVE_INFINITY;
    }
}
