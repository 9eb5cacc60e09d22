package org.daybreak.core.geometry;

import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Point3d;
import org.daybreak.core.math.Transform;

/**
 * A convex surface under a transform, for tests: it finds by its own means, in object space, the point of the surface that turns
 * its front to a ray. At most one such point exists per ray.
 */
public final class SurfaceCase {
    /** A right-angled map with mirroring, a map with unequal scales and shear, and others. */
    private static final Transform TURN = Transform.translate(0.3, -0.2, 0.5).multiply(Transform.rotate(1, 2, 3, 70));

    private static final Transform STRETCH = TURN.multiply(Transform.scale(1.5, 0.6, 0.8));
    private static final Transform MIRROR = TURN.multiply(Transform.scale(1.2, -0.7, 1));
    private static final Transform SHEAR =
            Transform.ofRows(1.1, 0.5, 0.2, 0.1, -0.3, 0.8, 0.4, 0.2, 0.1, -0.2, 0.6, -0.4);
    private static final Transform MIRROR_SHEAR = SHEAR.multiply(Transform.scale(1, 1, -1));

    private final String name;
    private final Shape shape;
    private final Transform toWorld;
    private final boolean flip;
    /** Map from the canonical shape to the world. */
    private final Transform map;

    /** Creates a case. */
    public SurfaceCase(String name, Shape shape, Transform toWorld, boolean flip) {
        this.name = name;
        this.shape = shape;
        this.toWorld = toWorld;
        this.flip = flip;
        map = shape instanceof Sphere s
                ? toWorld.multiply(ShapeFrames.of(s))
                : shape instanceof Cylinder c
                        ? toWorld.multiply(ShapeFrames.of(c))
                        : shape instanceof Cone cone ? toWorld.multiply(ShapeFrames.of(cone)) : toWorld;
    }

    /** Every kind of surface with every kind of transform that it treats differently. */
    public static List<SurfaceCase> all() {
        Sphere sphere = new Sphere(new Point3d(0.1, -0.2, 0.05), 0.8);
        Cylinder cylinder = new Cylinder(new Point3d(-0.3, -0.5, 0.2), new Point3d(0.2, 0.4, 0.6), 0.5);
        Cone cone = new Cone(new Point3d(-0.3, -0.5, 0.2), new Point3d(0.2, 0.4, 0.6), 0.7, 0);
        Cone frustum = new Cone(new Point3d(-0.3, -0.5, 0.2), new Point3d(0.2, 0.4, 0.6), 0.3, 0.6);
        List<SurfaceCase> cases = new ArrayList<>();
        for (boolean flip : new boolean[] {false, true}) {
            String suffix = flip ? ", flipped" : "";
            cases.add(new SurfaceCase("rectangle" + suffix, new Rectangle(), STRETCH, flip));
            cases.add(new SurfaceCase("mirrored rectangle" + suffix, new Rectangle(), MIRROR, flip));
            cases.add(new SurfaceCase("parallelogram" + suffix, new Rectangle(), SHEAR, flip));
            cases.add(new SurfaceCase("disk" + suffix, new Disk(), TURN, flip));
            cases.add(new SurfaceCase("mirrored ellipse" + suffix, new Disk(), MIRROR_SHEAR, flip));
            cases.add(new SurfaceCase("sphere" + suffix, sphere, TURN, flip));
            cases.add(new SurfaceCase("mirrored ellipsoid" + suffix, sphere, MIRROR_SHEAR, flip));
            cases.add(new SurfaceCase("cylinder" + suffix, cylinder, TURN, flip));
            cases.add(new SurfaceCase("mirrored oblique cylinder" + suffix, cylinder, MIRROR_SHEAR, flip));
            cases.add(new SurfaceCase("cone" + suffix, cone, TURN, flip));
            cases.add(new SurfaceCase("mirrored oblique frustum" + suffix, frustum, MIRROR_SHEAR, flip));
            cases.add(new SurfaceCase("cube" + suffix, new Cube(), TURN, flip));
            cases.add(new SurfaceCase("mirrored box" + suffix, new Cube(), MIRROR_SHEAR, flip));
        }
        return cases;
    }

    /** Points to look from: near, far, grazing, and inside of what has an inside. */
    public static List<double[]> views() {
        return List.of(
                new double[] {2.5, 1.5, -2},
                new double[] {-20, 9, 31},
                new double[] {0.3, 0.1, 0.4},
                new double[] {0.9, -1.2, 1.4},
                new double[] {-1.5, -1, -0.8});
    }

    /** Name of the case. */
    public String name() {
        return name;
    }

    /** Map from the shape to the world. */
    public Transform toWorld() {
        return toWorld;
    }

    /** A new sampler. */
    public SurfaceSampler sampler() {
        return SurfaceSamplers.of(shape, toWorld, flip);
    }

    /** Finds the point whose front faces the origin of a ray; fills position and geometric normal. */
    public boolean hit(double px, double py, double pz, double dx, double dy, double dz, SurfacePoint out) {
        if (shape instanceof Cube) {
            return hitCube(px, py, pz, dx, dy, dz, out);
        }
        double[] o = new double[3];
        double[] d = new double[3];
        map.applyInversePoint(px, py, pz, o);
        map.applyInverseVector(dx, dy, dz, d);
        if (shape instanceof Rectangle || shape instanceof Disk) {
            double t = -o[2] / d[2];
            double x = o[0] + t * d[0];
            double y = o[1] + t * d[1];
            boolean inside = shape instanceof Disk ? x * x + y * y <= 1 : Math.abs(x) <= 1 && Math.abs(y) <= 1;
            return inside && accept(t, 0, 0, 1, px, py, pz, dx, dy, dz, out);
        }
        double height = shape instanceof Sphere ? 1 : 0;
        double taper = shape instanceof Cone cone ? cone.taper() : 0;
        double radius = 1 - taper * o[2];
        double a = d[0] * d[0] + d[1] * d[1] + (height - taper * taper) * d[2] * d[2];
        double b = o[0] * d[0] + o[1] * d[1] + height * o[2] * d[2] + taper * radius * d[2];
        double c = o[0] * o[0] + o[1] * o[1] + height * o[2] * o[2] - radius * radius;
        double discriminant = b * b - a * c;
        if (discriminant < 0) {
            return false;
        }
        for (int sign = -1; sign <= 1; sign += 2) {
            double t = (-b + sign * Math.sqrt(discriminant)) / a;
            double z = o[2] + t * d[2];
            boolean inside = shape instanceof Sphere || (z >= 0 && z <= 1);
            double nz = height * z + taper * (1 - taper * z);
            if (inside && accept(t, o[0] + t * d[0], o[1] + t * d[1], nz, px, py, pz, dx, dy, dz, out)) {
                return true;
            }
        }
        return false;
    }

    private boolean accept(
            double t,
            double nx,
            double ny,
            double nz,
            double px,
            double py,
            double pz,
            double dx,
            double dy,
            double dz,
            SurfacePoint out) {
        if (!(t > 0)) {
            return false;
        }
        double[] n = new double[3];
        map.applyNormal(nx, ny, nz, n);
        double scale = (flip ? -1 : 1) / Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        out.x = px + t * dx;
        out.y = py + t * dy;
        out.z = pz + t * dz;
        out.gx = scale * n[0];
        out.gy = scale * n[1];
        out.gz = scale * n[2];
        return out.geometricCosine(dx, dy, dz) < 0;
    }

    private boolean hitCube(double px, double py, double pz, double dx, double dy, double dz, SurfacePoint out) {
        double[] o = new double[3];
        double[] d = new double[3];
        toWorld.applyInversePoint(px, py, pz, o);
        toWorld.applyInverseVector(dx, dy, dz, d);
        for (int axis = 0; axis < 3; axis++) {
            int j = (axis + 1) % 3;
            int k = (axis + 2) % 3;
            for (int side = -1; side <= 1; side += 2) {
                double t = (side - o[axis]) / d[axis];
                double[] n = new double[3];
                n[axis] = side;
                if (Math.abs(o[j] + t * d[j]) <= 1
                        && Math.abs(o[k] + t * d[k]) <= 1
                        && accept(t, n[0], n[1], n[2], px, py, pz, dx, dy, dz, out)) {
                    // As CubeMesh numbers them: two triangles per face, parted by the diagonal.
                    int face = 2 * axis + (side + 1) / 2;
                    boolean first = side * (o[j] + t * d[j]) >= o[k] + t * d[k];
                    out.primitive = 2 * face + (first ? 0 : 1);
                    return true;
                }
            }
        }
        return false;
    }

    @Override
    public String toString() {
        return name;
    }
}
