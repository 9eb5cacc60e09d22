package org.daybreak.core.accel;

/** Reference answers: every primitive in turn, in double precision. */
final class BruteForce {
    private BruteForce() {}

    /** Fills the result fields of the ray. */
    static boolean intersect(PrimitiveSet set, PrimitiveSet[] levels, Ray ray) {
        ray.primitive = -1;
        ray.instance = -1;
        ray.t = ray.tMax;
        closestInLevel(set, ray);
        for (int i = 0; i < set.instanceCount(); i++) {
            Ray local = new Ray();
            set.instance(i).toObject(ray, local);
            local.primitive = -1;
            local.tMax = ray.tMax;
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

    private static void closestInLevel(PrimitiveSet set, Ray ray) {
        for (int i = 0; i < set.triangleCount(); i++) {
            double t = triangle(set, i, ray);
            if (t > 0 && t < ray.t) {
                ray.t = t;
                ray.primitive = i;
            }
        }
        double[] m = new double[12];
        for (int i = 0; i < set.quadricCount(); i++) {
            for (int entry = 0; entry < 12; entry++) {
                m[entry] = set.quadric(i).worldToObject(entry);
            }
            double t = Quadric.intersect(
                    set.quadric(i).kind().ordinal(), m, 0, ray.ox, ray.oy, ray.oz, ray.dx, ray.dy, ray.dz, ray.t);
            if (t < ray.t) {
                ray.t = t;
                ray.primitive = set.triangleCount() + i;
            }
        }
    }

    /** Parameter at which the ray meets a triangle (Möller and Trumbore), or NaN. */
    static double triangle(PrimitiveSet set, int index, Ray ray) {
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
}
