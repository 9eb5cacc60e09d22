package org.daybreak.core.scene;

import org.daybreak.core.accel.Instance;
import org.daybreak.core.accel.Quadric;
import org.daybreak.core.geometry.SurfaceDifferential;
import org.daybreak.core.geometry.SurfacePoint;
import org.jspecify.annotations.Nullable;

/**
 * How normals turn along the tangents of a {@link SurfaceDifferential}. A normal field n = N/|N| with a vector field N that is
 * known has the derivative (I − nnᵀ) dN / |N|; of normals that a map with the linear part M places, N = M⁻ᵀN_o, and a tangent t
 * is M⁻¹t in object space.
 */
final class Curvature {
    private Curvature() {}

    /**
     * Sets the derivatives of the normals on a quadric, whose N is the gradient of its implicit function.
     *
     * @param flipped whether its front is the inside
     * @param instance the instance that the quadric is seen in, or null
     * @param out receives them; holds the tangents
     * @return false where there is no normal: at the tip of a cone
     */
    static boolean ofQuadric(
            Quadric q, boolean flipped, @Nullable Instance instance, SurfacePoint point, SurfaceDifferential out) {
        double lx = levelX(instance, point.x, point.y, point.z, 1);
        double ly = levelY(instance, point.x, point.y, point.z, 1);
        double lz = levelZ(instance, point.x, point.y, point.z, 1);
        // F = (across·(x² + y²) + along·z²)/2 + linear·z + constant.
        double across = 1;
        double along = 0;
        double linear = 0;
        switch (q.kind()) {
            case SPHERE -> along = 1;
            case DISK -> {
                across = 0;
                linear = 1;
            }
            case CYLINDER -> {}
            case CONE -> {
                along = -q.taper() * q.taper();
                linear = q.taper();
            }
        }
        double gx = across * row(q, 0, lx, ly, lz, 1);
        double gy = across * row(q, 4, lx, ly, lz, 1);
        double gz = along * row(q, 8, lx, ly, lz, 1) + linear;
        double wx = worldX(q, instance, gx, gy, gz);
        double wy = worldY(q, instance, gx, gy, gz);
        double wz = worldZ(q, instance, gx, gy, gz);
        double length = Math.sqrt(wx * wx + wy * wy + wz * wz);
        if (!(length > 0)) {
            return false;
        }
        double scale = (flipped ? -1 : 1) / length;
        for (int k = 0; k < 2; k++) {
            double px = k == 0 ? out.pux : out.pvx;
            double py = k == 0 ? out.puy : out.pvy;
            double pz = k == 0 ? out.puz : out.pvz;
            double tx = levelX(instance, px, py, pz, 0);
            double ty = levelY(instance, px, py, pz, 0);
            double tz = levelZ(instance, px, py, pz, 0);
            double hx = across * row(q, 0, tx, ty, tz, 0) * scale;
            double hy = across * row(q, 4, tx, ty, tz, 0) * scale;
            double hz = along * row(q, 8, tx, ty, tz, 0) * scale;
            setShading(
                    k,
                    worldX(q, instance, hx, hy, hz),
                    worldY(q, instance, hx, hy, hz),
                    worldZ(q, instance, hx, hy, hz),
                    point,
                    out);
        }
        out.gux = out.nux;
        out.guy = out.nuy;
        out.guz = out.nuz;
        out.gvx = out.nvx;
        out.gvy = out.nvy;
        out.gvz = out.nvz;
        return true;
    }

    /**
     * Sets the derivatives of the shading normal on a triangle with vertex normals, whose N is their interpolation.
     *
     * @param p vertex positions of the level
     * @param n normals of the vertices
     * @param a first number of vertex a in both arrays
     * @param instance the instance that the triangle is seen in, or null
     * @param out receives them; holds the tangents
     * @return false on triangles without area
     */
    static boolean ofVertexNormals(
            float[] p,
            float[] n,
            int a,
            int b,
            int c,
            @Nullable Instance instance,
            SurfacePoint point,
            SurfaceDifferential out) {
        double e1x = (double) p[b] - p[a];
        double e1y = (double) p[b + 1] - p[a + 1];
        double e1z = (double) p[b + 2] - p[a + 2];
        double e2x = (double) p[c] - p[a];
        double e2y = (double) p[c + 1] - p[a + 1];
        double e2z = (double) p[c + 2] - p[a + 2];
        double nx = e1y * e2z - e1z * e2y;
        double ny = e1z * e2x - e1x * e2z;
        double nz = e1x * e2y - e1y * e2x;
        double inverse = 1 / (nx * nx + ny * ny + nz * nz);
        if (!(inverse < Double.POSITIVE_INFINITY)) {
            return false;
        }
        // Barycentric coordinates of b and c change along a vector d by d · (e₂ × n) and d · (n × e₁), over |n|².
        double bx = (e2y * nz - e2z * ny) * inverse;
        double by = (e2z * nx - e2x * nz) * inverse;
        double bz = (e2x * ny - e2y * nx) * inverse;
        double cx = (ny * e1z - nz * e1y) * inverse;
        double cy = (nz * e1x - nx * e1z) * inverse;
        double cz = (nx * e1y - ny * e1x) * inverse;
        double d1x = (double) n[b] - n[a];
        double d1y = (double) n[b + 1] - n[a + 1];
        double d1z = (double) n[b + 2] - n[a + 2];
        double d2x = (double) n[c] - n[a];
        double d2y = (double) n[c + 1] - n[a + 1];
        double d2z = (double) n[c + 2] - n[a + 2];
        double lx = levelX(instance, point.x, point.y, point.z, 1) - p[a];
        double ly = levelY(instance, point.x, point.y, point.z, 1) - p[a + 1];
        double lz = levelZ(instance, point.x, point.y, point.z, 1) - p[a + 2];
        double v = lx * bx + ly * by + lz * bz;
        double w = lx * cx + ly * cy + lz * cz;
        double ox = n[a] + v * d1x + w * d2x;
        double oy = n[a + 1] + v * d1y + w * d2y;
        double oz = n[a + 2] + v * d1z + w * d2z;
        double wx = column(instance, 0, ox, oy, oz);
        double wy = column(instance, 1, ox, oy, oz);
        double wz = column(instance, 2, ox, oy, oz);
        if (!(wx * point.gx + wy * point.gy + wz * point.gz > 0)) {
            // There the geometric normal takes the place of the interpolated one.
            return true;
        }
        double scale = 1 / Math.sqrt(wx * wx + wy * wy + wz * wz);
        for (int k = 0; k < 2; k++) {
            double px = k == 0 ? out.pux : out.pvx;
            double py = k == 0 ? out.puy : out.pvy;
            double pz = k == 0 ? out.puz : out.pvz;
            double tx = levelX(instance, px, py, pz, 0);
            double ty = levelY(instance, px, py, pz, 0);
            double tz = levelZ(instance, px, py, pz, 0);
            double dv = (tx * bx + ty * by + tz * bz) * scale;
            double dw = (tx * cx + ty * cy + tz * cz) * scale;
            double dx = dv * d1x + dw * d2x;
            double dy = dv * d1y + dw * d2y;
            double dz = dv * d1z + dw * d2z;
            setShading(
                    k,
                    column(instance, 0, dx, dy, dz),
                    column(instance, 1, dx, dy, dz),
                    column(instance, 2, dx, dy, dz),
                    point,
                    out);
        }
        return true;
    }

    /** Sets the derivative of the shading normal along the first or second tangent from that of N, over |N|. */
    private static void setShading(
            int tangent, double dx, double dy, double dz, SurfacePoint point, SurfaceDifferential out) {
        double normal = dx * point.nx + dy * point.ny + dz * point.nz;
        if (tangent == 0) {
            out.nux = dx - normal * point.nx;
            out.nuy = dy - normal * point.ny;
            out.nuz = dz - normal * point.nz;
        } else {
            out.nvx = dx - normal * point.nx;
            out.nvy = dy - normal * point.ny;
            out.nvz = dz - normal * point.nz;
        }
    }

    /** First coordinate in the level of a point (w = 1) or vector (w = 0) of the world. */
    private static double levelX(@Nullable Instance i, double x, double y, double z, double w) {
        return i == null ? x : row(i, 0, x, y, z, w);
    }

    private static double levelY(@Nullable Instance i, double x, double y, double z, double w) {
        return i == null ? y : row(i, 4, x, y, z, w);
    }

    private static double levelZ(@Nullable Instance i, double x, double y, double z, double w) {
        return i == null ? z : row(i, 8, x, y, z, w);
    }

    private static double row(Instance i, int at, double x, double y, double z, double w) {
        return i.worldToObject(at) * x
                + i.worldToObject(at + 1) * y
                + i.worldToObject(at + 2) * z
                + i.worldToObject(at + 3) * w;
    }

    private static double row(Quadric q, int at, double x, double y, double z, double w) {
        return q.worldToObject(at) * x
                + q.worldToObject(at + 1) * y
                + q.worldToObject(at + 2) * z
                + q.worldToObject(at + 3) * w;
    }

    /** A component in the world of a normal of the level. */
    private static double column(@Nullable Instance i, int at, double x, double y, double z) {
        if (i == null) {
            return at == 0 ? x : at == 1 ? y : z;
        }
        return i.worldToObject(at) * x + i.worldToObject(at + 4) * y + i.worldToObject(at + 8) * z;
    }

    private static double column(Quadric q, int at, double x, double y, double z) {
        return q.worldToObject(at) * x + q.worldToObject(at + 4) * y + q.worldToObject(at + 8) * z;
    }

    /** First component in the world of a normal of the quadric's own space. */
    private static double worldX(Quadric q, @Nullable Instance i, double x, double y, double z) {
        return column(i, 0, column(q, 0, x, y, z), column(q, 1, x, y, z), column(q, 2, x, y, z));
    }

    private static double worldY(Quadric q, @Nullable Instance i, double x, double y, double z) {
        return column(i, 1, column(q, 0, x, y, z), column(q, 1, x, y, z), column(q, 2, x, y, z));
    }

    private static double worldZ(Quadric q, @Nullable Instance i, double x, double y, double z) {
        return column(i, 2, column(q, 0, x, y, z), column(q, 1, x, y, z), column(q, 2, x, y, z));
    }
}
