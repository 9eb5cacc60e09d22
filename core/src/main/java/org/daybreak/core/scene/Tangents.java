package org.daybreak.core.scene;

import org.daybreak.core.accel.HitRefinement;
import org.daybreak.core.accel.Instance;
import org.daybreak.core.accel.Quadric;
import org.daybreak.core.geometry.SurfacePoint;
import org.jspecify.annotations.Nullable;

/** Derivatives of surface points by their texture coordinates: what turns shading frames along them. */
final class Tangents {
    private static final double TWO_PI = 2 * Math.PI;

    private Tangents() {}

    /**
     * Aligns the frame of a point on a triangle, whose derivatives are constant.
     *
     * @param p vertex positions of the level
     * @param st texture coordinates of its vertices
     * @param instance the instance that the triangle is seen in, or null
     */
    static void ofTriangle(float[] p, float[] st, int a, int b, int c, @Nullable Instance instance, SurfacePoint hit) {
        double e1x = (double) p[3 * b] - p[3 * a];
        double e1y = (double) p[3 * b + 1] - p[3 * a + 1];
        double e1z = (double) p[3 * b + 2] - p[3 * a + 2];
        double e2x = (double) p[3 * c] - p[3 * a];
        double e2y = (double) p[3 * c + 1] - p[3 * a + 1];
        double e2z = (double) p[3 * c + 2] - p[3 * a + 2];
        double du1 = (double) st[2 * b] - st[2 * a];
        double dv1 = (double) st[2 * b + 1] - st[2 * a + 1];
        double du2 = (double) st[2 * c] - st[2 * a];
        double dv2 = (double) st[2 * c + 1] - st[2 * a + 1];
        double inverse = 1 / (du1 * dv2 - dv1 * du2);
        align(
                (dv2 * e1x - dv1 * e2x) * inverse,
                (dv2 * e1y - dv1 * e2y) * inverse,
                (dv2 * e1z - dv1 * e2z) * inverse,
                (du1 * e2x - du2 * e1x) * inverse,
                (du1 * e2y - du2 * e1y) * inverse,
                (du1 * e2z - du2 * e1z) * inverse,
                instance,
                hit);
    }

    /**
     * Turns the frame of a point on a triangle along the interpolated tangents of its vertices; zero vectors leave it.
     *
     * @param tangents directions of the vertices of the level
     * @param u weight of vertex a
     * @param instance the instance that the triangle is seen in, or null
     */
    static void turnToVertices(
            float[] tangents,
            int a,
            int b,
            int c,
            double u,
            double v,
            double w,
            @Nullable Instance instance,
            SurfacePoint hit) {
        double x = u * tangents[3 * a] + v * tangents[3 * b] + w * tangents[3 * c];
        double y = u * tangents[3 * a + 1] + v * tangents[3 * b + 1] + w * tangents[3 * c + 1];
        double z = u * tangents[3 * a + 2] + v * tangents[3 * b + 2] + w * tangents[3 * c + 2];
        if (instance == null) {
            hit.turnFrame(x, y, z);
            return;
        }
        hit.turnFrame(
                instance.objectToWorld(0) * x + instance.objectToWorld(1) * y + instance.objectToWorld(2) * z,
                instance.objectToWorld(4) * x + instance.objectToWorld(5) * y + instance.objectToWorld(6) * z,
                instance.objectToWorld(8) * x + instance.objectToWorld(9) * y + instance.objectToWorld(10) * z);
    }

    /** Aligns the frame of a point on a quadric, from its place in the quadric's own space. */
    static void ofQuadric(
            Quadric q, boolean reversed, HitRefinement refined, @Nullable Instance instance, SurfacePoint hit) {
        double x = refined.objectX;
        double y = refined.objectY;
        double z = refined.objectZ;
        double r = Math.sqrt(x * x + y * y);
        double ux = -TWO_PI * y;
        double uy = TWO_PI * x;
        double vx = 0;
        double vy = 0;
        double vz = 0;
        switch (q.kind()) {
            case SPHERE -> {
                vx = Math.PI * z * x / r;
                vy = Math.PI * z * y / r;
                vz = -Math.PI * r;
            }
            case DISK -> {
                vx = ux;
                vy = uy;
                ux = x / r;
                uy = y / r;
            }
            case CYLINDER -> vz = 1;
            case CONE -> {
                // Along the ruling; where the cone is reversed, both coordinates run the other way.
                double sign = reversed ? -1 : 1;
                ux *= sign;
                uy *= sign;
                vx = -sign * q.taper() * x / r;
                vy = -sign * q.taper() * y / r;
                vz = sign;
            }
        }
        align(
                q.objectToWorld(0) * ux + q.objectToWorld(1) * uy,
                q.objectToWorld(4) * ux + q.objectToWorld(5) * uy,
                q.objectToWorld(8) * ux + q.objectToWorld(9) * uy,
                q.objectToWorld(0) * vx + q.objectToWorld(1) * vy + q.objectToWorld(2) * vz,
                q.objectToWorld(4) * vx + q.objectToWorld(5) * vy + q.objectToWorld(6) * vz,
                q.objectToWorld(8) * vx + q.objectToWorld(9) * vy + q.objectToWorld(10) * vz,
                instance,
                hit);
    }

    private static void align(
            double ux, double uy, double uz, double vx, double vy, double vz, @Nullable Instance i, SurfacePoint hit) {
        if (i == null) {
            hit.alignFrame(ux, uy, uz, vx, vy, vz);
            return;
        }
        hit.alignFrame(
                i.objectToWorld(0) * ux + i.objectToWorld(1) * uy + i.objectToWorld(2) * uz,
                i.objectToWorld(4) * ux + i.objectToWorld(5) * uy + i.objectToWorld(6) * uz,
                i.objectToWorld(8) * ux + i.objectToWorld(9) * uy + i.objectToWorld(10) * uz,
                i.objectToWorld(0) * vx + i.objectToWorld(1) * vy + i.objectToWorld(2) * vz,
                i.objectToWorld(4) * vx + i.objectToWorld(5) * vy + i.objectToWorld(6) * vz,
                i.objectToWorld(8) * vx + i.objectToWorld(9) * vy + i.objectToWorld(10) * vz);
    }
}
