package org.daybreak.core.scene;

import org.daybreak.core.accel.HitRefinement;
import org.daybreak.core.accel.Instance;
import org.daybreak.core.accel.PrimitiveSet;
import org.daybreak.core.accel.Quadric;
import org.daybreak.core.geometry.SurfaceDifferential;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.TangentFrame;
import org.jspecify.annotations.Nullable;

/**
 * The geometry of one level with what the acceleration structure does not know: vertex normals, texture coordinates and which
 * shape each primitive belongs to. Immutable.
 */
final class LevelGeometry {
    private static final double TWO_PI = 2 * Math.PI;

    private final float[] positions;
    private final int[] triangles;
    private final float @Nullable [] normals;
    private final float @Nullable [] uvs;
    private final @Nullable VertexAttributes attributes;
    private final int[] firstTriangle;
    private final int[] shapeOfRun;
    private final TangentFrame @Nullable [] frameOfRun;
    private final Quadric[] quadrics;
    private final QuadricShape[] quadricShapes;

    /**
     * What a quadric belongs to.
     *
     * @param shape the shape's number in the scene
     * @param flipped true if its front is the inside
     * @param needs what its points must offer
     * @param reversed true if texture coordinates run against the canonical cone's
     */
    record QuadricShape(int shape, boolean flipped, ShadingNeeds needs, boolean reversed) {}

    /**
     * Takes over all arrays.
     *
     * @param normals unit vertex normals or zero vectors where a mesh has none; null if no mesh has any
     * @param uvs texture coordinates; null if no mesh has any
     * @param attributes what few scenes have; null if no mesh has any
     * @param firstTriangle first triangle of each mesh, ascending
     * @param shapeOfRun shape of each mesh
     * @param frameOfRun what the shading frames of each mesh must lie along; null if they are arbitrary everywhere
     */
    LevelGeometry(
            float[] positions,
            int[] triangles,
            float @Nullable [] normals,
            float @Nullable [] uvs,
            @Nullable VertexAttributes attributes,
            int[] firstTriangle,
            int[] shapeOfRun,
            TangentFrame @Nullable [] frameOfRun,
            Quadric[] quadrics,
            QuadricShape[] quadricShapes) {
        this.positions = positions;
        this.triangles = triangles;
        this.normals = normals;
        this.uvs = uvs;
        this.attributes = attributes;
        this.firstTriangle = firstTriangle;
        this.shapeOfRun = shapeOfRun;
        this.frameOfRun = frameOfRun;
        this.quadrics = quadrics;
        this.quadricShapes = quadricShapes;
    }

    PrimitiveSet primitives(Instance[] instances) {
        return new PrimitiveSet(positions, triangles, quadrics, instances);
    }

    int triangleCount() {
        return triangles.length / 3;
    }

    /**
     * Completes a surface point from a refined hit.
     *
     * @param primitive number of the primitive in this level
     * @param instance transform of the instance, null outside instances
     */
    void complete(HitRefinement refined, int primitive, @Nullable Instance instance, SurfacePoint hit) {
        hit.x = refined.x;
        hit.y = refined.y;
        hit.z = refined.z;
        hit.gx = refined.normalX;
        hit.gy = refined.normalY;
        hit.gz = refined.normalZ;
        hit.offset = refined.offset;
        hit.primitive = primitive;
        int triangleCount = triangles.length / 3;
        if (primitive < triangleCount) {
            completeTriangle(refined, primitive, instance, hit);
        } else {
            completeQuadric(refined, primitive - triangleCount, instance, hit);
        }
    }

    private void completeTriangle(HitRefinement refined, int triangle, @Nullable Instance instance, SurfacePoint hit) {
        int run = runOf(triangle);
        hit.shape = shapeOfRun[run];
        int a = triangles[3 * triangle];
        int b = triangles[3 * triangle + 1];
        int c = triangles[3 * triangle + 2];
        double v = refined.u;
        double w = refined.v;
        double u = 1 - v - w;
        float[] st = uvs;
        if (st != null) {
            hit.u = u * st[2 * a] + v * st[2 * b] + w * st[2 * c];
            hit.v = u * st[2 * a + 1] + v * st[2 * b + 1] + w * st[2 * c + 1];
        } else {
            hit.u = v;
            hit.v = w;
        }
        VertexAttributes more = attributes;
        if (more == null) {
            hit.setNoAttributes();
        } else {
            more.set(a, b, c, u, v, w, hit);
        }
        setTriangleFrame(a, b, c, u, v, w, instance, hit);
        TangentFrame[] frames = frameOfRun;
        if (frames != null && frames[run] != TangentFrame.ARBITRARY) {
            alignFrame(frames[run], a, b, c, u, v, w, instance, hit);
        }
    }

    /**
     * Fills in how the surface goes on around a point of this level.
     *
     * @param instance transform of the instance, null outside instances
     * @return false if the point is on no surface of this level, or one without a normal
     */
    boolean differential(SurfacePoint point, @Nullable Instance instance, SurfaceDifferential out) {
        out.setFlat(point);
        int triangle = point.primitive;
        int quadric = triangle - triangles.length / 3;
        if (quadric >= 0) {
            if (quadric >= quadrics.length || quadricShapes[quadric].shape() != point.shape) {
                return false;
            }
            return Curvature.ofQuadric(quadrics[quadric], quadricShapes[quadric].flipped(), instance, point, out);
        }
        if (triangle < 0 || shapeOfRun[runOf(triangle)] != point.shape) {
            return false;
        }
        float[] n = normals;
        int a = 3 * triangles[3 * triangle];
        if (n == null || (n[a] == 0 && n[a + 1] == 0 && n[a + 2] == 0)) {
            return true;
        }
        int b = 3 * triangles[3 * triangle + 1];
        int c = 3 * triangles[3 * triangle + 2];
        return Curvature.ofVertexNormals(positions, n, a, b, c, instance, point, out);
    }

    /** Turns the frame along the texture coordinates, and from there along the tangents of the vertices where there are some. */
    private void alignFrame(
            TangentFrame frame,
            int a,
            int b,
            int c,
            double u,
            double v,
            double w,
            @Nullable Instance instance,
            SurfacePoint hit) {
        VertexAttributes more = attributes;
        float[] second = more == null ? null : more.secondUvs();
        float[] st = frame == TangentFrame.SECOND_UVS && second != null ? second : uvs;
        if (st != null) {
            Tangents.ofTriangle(positions, st, a, b, c, instance, hit);
        } else {
            hit.alignFrame(0, 0, 0, 0, 0, 0);
        }
        float[] tangents = more == null ? null : more.tangents();
        if (tangents != null) {
            Tangents.turnToVertices(tangents, a, b, c, u, v, w, instance, hit);
        }
    }

    private void setTriangleFrame(
            int a, int b, int c, double u, double v, double w, @Nullable Instance instance, SurfacePoint hit) {
        float[] n = normals;
        if (n == null || (n[3 * a] == 0 && n[3 * a + 1] == 0 && n[3 * a + 2] == 0)) {
            setFrame(hit, hit.gx, hit.gy, hit.gz);
            return;
        }
        double nx = u * n[3 * a] + v * n[3 * b] + w * n[3 * c];
        double ny = u * n[3 * a + 1] + v * n[3 * b + 1] + w * n[3 * c + 1];
        double nz = u * n[3 * a + 2] + v * n[3 * b + 2] + w * n[3 * c + 2];
        if (instance != null) {
            double ox = nx;
            double oy = ny;
            double oz = nz;
            nx = instance.worldToObject(0) * ox + instance.worldToObject(4) * oy + instance.worldToObject(8) * oz;
            ny = instance.worldToObject(1) * ox + instance.worldToObject(5) * oy + instance.worldToObject(9) * oz;
            nz = instance.worldToObject(2) * ox + instance.worldToObject(6) * oy + instance.worldToObject(10) * oz;
        }
        double scale = 1 / Math.sqrt(nx * nx + ny * ny + nz * nz);
        nx *= scale;
        ny *= scale;
        nz *= scale;
        if (nx * hit.gx + ny * hit.gy + nz * hit.gz > 0) {
            setFrame(hit, nx, ny, nz);
        } else {
            setFrame(hit, hit.gx, hit.gy, hit.gz);
        }
    }

    private void completeQuadric(HitRefinement refined, int index, @Nullable Instance instance, SurfacePoint hit) {
        QuadricShape shape = quadricShapes[index];
        hit.shape = shape.shape();
        if (shape.flipped()) {
            hit.gx = -hit.gx;
            hit.gy = -hit.gy;
            hit.gz = -hit.gz;
        }
        setFrame(hit, hit.gx, hit.gy, hit.gz);
        if (shape.needs().frame() != TangentFrame.ARBITRARY) {
            Tangents.ofQuadric(quadrics[index], shape.reversed(), refined, instance, hit);
        }
        if (!shape.needs().textured()) {
            hit.u = 0;
            hit.v = 0;
            hit.setNoAttributes();
            return;
        }
        double phi = Math.atan2(refined.objectY, refined.objectX) / TWO_PI;
        double turn = phi < 0 ? phi + 1 : phi;
        switch (quadrics[index].kind()) {
            case SPHERE -> {
                hit.u = turn;
                hit.v = Math.acos(Math.max(-1, Math.min(1, refined.objectZ))) / Math.PI;
            }
            case DISK -> {
                hit.u = Math.sqrt(refined.objectX * refined.objectX + refined.objectY * refined.objectY);
                hit.v = turn;
            }
            case CYLINDER -> {
                hit.u = turn;
                hit.v = refined.objectZ;
            }
            case CONE -> {
                hit.u = shape.reversed() && turn > 0 ? 1 - turn : turn;
                hit.v = shape.reversed() ? 1 - refined.objectZ : refined.objectZ;
            }
        }
        hit.setNoAttributes();
    }

    /**
     * The last mesh that starts at or before the triangle. Empty meshes share their start with the next one; the last of
     * equal starts is the one that holds the triangle. Halves without branches on the outcome, which would be mispredicted.
     */
    private int runOf(int triangle) {
        int[] first = firstTriangle;
        int run = 0;
        for (int count = first.length; count > 1; ) {
            int half = count >>> 1;
            // 0 if that mesh starts at or before the triangle, else -1.
            int beyond = (triangle - first[run + half]) >> 31;
            run += half & ~beyond;
            count -= half;
        }
        return run;
    }

    /** Right-handed frame about a unit normal, without branches on its direction (Duff et al. 2017). */
    private static void setFrame(SurfacePoint p, double nx, double ny, double nz) {
        double sign = Math.copySign(1, nz);
        double a = -1 / (sign + nz);
        double b = nx * ny * a;
        p.sx = 1 + sign * nx * nx * a;
        p.sy = sign * b;
        p.sz = -sign * nx;
        p.tx = b;
        p.ty = sign + ny * ny * a;
        p.tz = -ny;
        p.nx = nx;
        p.ny = ny;
        p.nz = nz;
    }
}
