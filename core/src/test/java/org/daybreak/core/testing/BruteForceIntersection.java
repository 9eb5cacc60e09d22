package org.daybreak.core.testing;

import org.daybreak.core.accel.Instance;
import org.daybreak.core.accel.PrimitiveSet;
import org.daybreak.core.accel.Quadric;
import org.daybreak.core.accel.Ray;

/** Reference answers for ray queries: every primitive in turn, in double precision, by textbook formulas. */
public final class BruteForceIntersection {
    private BruteForceIntersection() {}

    /**
     * Fills the result fields of the ray with the closest hit.
     *
     * @param levels what each instance of the set places
     */
    public static boolean intersect(PrimitiveSet set, PrimitiveSet[] levels, Ray ray) {
        ray.primitive = -1;
        ray.instance = -1;
        ray.t = ray.tMax;
        closestInLevel(set, ray);
        for (int i = 0; i < set.instanceCount(); i++) {
            Ray local = toObject(set.instance(i), ray);
            local.primitive = -1;
            local.t = ray.t;
            closestInLevel(levels[i], local);
            if (local.primitive >= 0) {
                ray.t = local.t;
                ray.primitive = local.primitive;
                ray.instance = i;
            }
        }
        return ray.primitive >= 0;
    }

    private static Ray toObject(Instance instance, Ray ray) {
        double[] m = new double[12];
        for (int i = 0; i < 12; i++) {
            m[i] = instance.worldToObject(i);
        }
        return transformed(m, ray);
    }

    private static Ray transformed(double[] m, Ray ray) {
        Ray local = new Ray();
        local.set(
                m[0] * ray.ox + m[1] * ray.oy + m[2] * ray.oz + m[3],
                m[4] * ray.ox + m[5] * ray.oy + m[6] * ray.oz + m[7],
                m[8] * ray.ox + m[9] * ray.oy + m[10] * ray.oz + m[11],
                m[0] * ray.dx + m[1] * ray.dy + m[2] * ray.dz,
                m[4] * ray.dx + m[5] * ray.dy + m[6] * ray.dz,
                m[8] * ray.dx + m[9] * ray.dy + m[10] * ray.dz,
                ray.tMax);
        return local;
    }

    private static void closestInLevel(PrimitiveSet set, Ray ray) {
        for (int i = 0; i < set.triangleCount(); i++) {
            double t = triangle(set, i, ray);
            if (t > 0 && t < ray.t) {
                ray.t = t;
                ray.primitive = i;
            }
        }
        for (int i = 0; i < set.quadricCount(); i++) {
            double t = quadric(set.quadric(i), ray);
            if (t < ray.t) {
                ray.t = t;
                ray.primitive = set.triangleCount() + i;
            }
        }
    }

    /** Parameter at which the line of the ray meets a triangle (Möller and Trumbore), or NaN. */
    public static double triangle(PrimitiveSet set, int index, Ray ray) {
        float[] p = set.positions();
        int a = 3 * set.triangles()[3 * index];
        int b = 3 * set.triangles()[3 * index + 1];
        int c = 3 * set.triangles()[3 * index + 2];
        double e1x = (double) p[b] - p[a];
        double e1y = (double) p[b + 1] - p[a + 1];
        double e1z = (double) p[b + 2] - p[a + 2];
        double e2x = (double) p[c] - p[a];
        double e2y = (double) p[c + 1] - p[a + 1];
        double e2z = (double) p[c + 2] - p[a + 2];
        double hx = ray.dy * e2z - ray.dz * e2y;
        double hy = ray.dz * e2x - ray.dx * e2z;
        double hz = ray.dx * e2y - ray.dy * e2x;
        double determinant = e1x * hx + e1y * hy + e1z * hz;
        double sx = ray.ox - p[a];
        double sy = ray.oy - p[a + 1];
        double sz = ray.oz - p[a + 2];
        double u = (sx * hx + sy * hy + sz * hz) / determinant;
        double qx = sy * e1z - sz * e1y;
        double qy = sz * e1x - sx * e1z;
        double qz = sx * e1y - sy * e1x;
        double v = (ray.dx * qx + ray.dy * qy + ray.dz * qz) / determinant;
        double t = (e2x * qx + e2y * qy + e2z * qz) / determinant;
        return u >= 0 && v >= 0 && u + v <= 1 ? t : Double.NaN;
    }

    private static double quadric(Quadric quadric, Ray ray) {
        double[] m = new double[12];
        for (int i = 0; i < 12; i++) {
            m[i] = quadric.worldToObject(i);
        }
        Ray r = transformed(m, ray);
        if (quadric.kind() == Quadric.Kind.DISK) {
            double t = -r.oz / r.dz;
            double x = r.ox + t * r.dx;
            double y = r.oy + t * r.dy;
            return t > 0 && x * x + y * y <= 1 ? t : Double.POSITIVE_INFINITY;
        }
        boolean sphere = quadric.kind() == Quadric.Kind.SPHERE;
        double z = sphere ? 1 : 0;
        // x² + y² + z·oz² = (1 − taper·oz)²
        double taper = quadric.taper();
        double radius = 1 - taper * r.oz;
        double a = r.dx * r.dx + r.dy * r.dy + (z - taper * taper) * r.dz * r.dz;
        double b = r.ox * r.dx + r.oy * r.dy + z * r.oz * r.dz + taper * radius * r.dz;
        double c = r.ox * r.ox + r.oy * r.oy + z * r.oz * r.oz - radius * radius;
        double root = Math.sqrt(b * b - a * c);
        double t0 = (-b - root) / a;
        double t1 = (-b + root) / a;
        for (double t : new double[] {Math.min(t0, t1), Math.max(t0, t1)}) {
            double height = r.oz + t * r.dz;
            if (t > 0 && (sphere || (height >= 0 && height <= 1))) {
                return t;
            }
        }
        return Double.POSITIVE_INFINITY;
    }
}
