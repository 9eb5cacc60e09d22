package org.daybreak.core.geometry;

import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.DiscreteDistribution;
import org.daybreak.core.sampling.Warps;
import org.jspecify.annotations.Nullable;

/**
 * A triangle mesh under an affine map, sampled uniformly by area. The first number chooses the triangle, and what is left of
 * it the point, so neighbouring numbers stay neighbouring points. Triangles without area are never chosen.
 */
final class MeshSampler implements SurfaceSampler {
    private final TriangleMesh mesh;
    private final Transform toWorld;
    private final double side;
    /** World position of each vertex. */
    private final double[] positions;

    private final @Nullable DiscreteDistribution triangles;
    private final SurfaceMoments moments;
    private final double offset;

    MeshSampler(TriangleMesh mesh, Transform toWorld, boolean flipNormals) {
        this.mesh = mesh;
        this.toWorld = toWorld;
        // The winding of the transformed triangle is that of a mirror image.
        side = toWorld.isMirroring() != flipNormals ? -1 : 1;
        positions = worldPositions(mesh, toWorld);
        SurfaceMoments.Builder builder = new SurfaceMoments.Builder();
        double[] areas = new double[mesh.triangleCount()];
        double[] n = new double[3];
        for (int i = 0; i < areas.length; i++) {
            double twice = cross(i, n);
            areas[i] = 0.5 * twice;
            if (twice > 0) {
                double scale = side / twice;
                builder.add(areas[i], scale * n[0], scale * n[1], scale * n[2]);
            }
        }
        Bounds.Builder boundsBuilder = new Bounds.Builder();
        for (int i = 0; i < areas.length; i++) {
            for (int corner = 0; areas[i] > 0 && corner < 3; corner++) {
                int at = vertex(i, corner);
                boundsBuilder.include(positions[at], positions[at + 1], positions[at + 2]);
            }
        }
        Bounds bounds = boundsBuilder.build();
        if (bounds.isEmpty()) {
            triangles = null;
            moments = builder.build(0, 0, 0, 0);
            offset = 0;
            return;
        }
        triangles = new DiscreteDistribution(areas);
        double cx = bounds.centerX();
        double cy = bounds.centerY();
        double cz = bounds.centerZ();
        double squaredRadius = 0;
        for (int i = 0; i < areas.length; i++) {
            for (int corner = 0; areas[i] > 0 && corner < 3; corner++) {
                int at = vertex(i, corner);
                double x = positions[at] - cx;
                double y = positions[at + 1] - cy;
                double z = positions[at + 2] - cz;
                squaredRadius = Math.max(squaredRadius, x * x + y * y + z * z);
            }
        }
        double radius = Math.sqrt(squaredRadius) * (1 + 1e-9);
        moments = builder.build(cx, cy, cz, radius);
        offset = SurfaceFrames.triangleOffset(cx, cy, cz, radius);
    }

    private static double[] worldPositions(TriangleMesh mesh, Transform toWorld) {
        float[] local = mesh.positions();
        double[] world = new double[local.length];
        double[] d = new double[3];
        for (int i = 0; i < local.length; i += 3) {
            toWorld.applyPoint(local[i], local[i + 1], local[i + 2], d);
            world[i] = d[0];
            world[i + 1] = d[1];
            world[i + 2] = d[2];
        }
        return world;
    }

    @Override
    public double area() {
        return moments.area();
    }

    @Override
    public double sampleArea(double u, double v, SurfacePoint out) {
        if (triangles == null) {
            return 0;
        }
        int triangle = triangles.sample(u);
        double[] work = out.scratch;
        Warps.toTriangle(triangles.remainder(u, triangle), v, work);
        double b1 = work[0];
        double b2 = work[1];
        double b0 = 1 - b1 - b2;
        int i0 = vertex(triangle, 0);
        int i1 = vertex(triangle, 1);
        int i2 = vertex(triangle, 2);
        out.x = b0 * positions[i0] + b1 * positions[i1] + b2 * positions[i2];
        out.y = b0 * positions[i0 + 1] + b1 * positions[i1 + 1] + b2 * positions[i2 + 1];
        out.z = b0 * positions[i0 + 2] + b1 * positions[i1 + 2] + b2 * positions[i2 + 2];
        double scale = side / cross(triangle, work);
        SurfaceFrames.set(out, scale * work[0], scale * work[1], scale * work[2]);
        float[] normals = mesh.normals();
        if (normals != null) {
            setShadingNormal(normals, i0, i1, i2, b0, b1, b2, out);
        }
        float[] uvs = mesh.uvs();
        if (uvs != null) {
            int[] indices = mesh.triangles();
            int t0 = 2 * indices[3 * triangle];
            int t1 = 2 * indices[3 * triangle + 1];
            int t2 = 2 * indices[3 * triangle + 2];
            out.u = b0 * uvs[t0] + b1 * uvs[t1] + b2 * uvs[t2];
            out.v = b0 * uvs[t0 + 1] + b1 * uvs[t1 + 1] + b2 * uvs[t2 + 1];
        } else {
            out.u = b1;
            out.v = b2;
        }
        setAttributes(triangle, b0, b1, b2, out);
        out.offset = offset;
        out.primitive = triangle;
        return 1 / moments.area();
    }

    @Override
    public double areaDensity(SurfacePoint on) {
        return triangles == null ? 0 : 1 / moments.area();
    }

    @Override
    public double irradiance(double px, double py, double pz, double nx, double ny, double nz) {
        return triangles == null ? 0 : moments.irradiance(px, py, pz, nx, ny, nz);
    }

    private void setAttributes(int triangle, double b0, double b1, double b2, SurfacePoint out) {
        out.setNoAttributes();
        int[] indices = mesh.triangles();
        int i0 = indices[3 * triangle];
        int i1 = indices[3 * triangle + 1];
        int i2 = indices[3 * triangle + 2];
        float[] second = mesh.secondUvs();
        if (second != null) {
            out.u2 = b0 * second[2 * i0] + b1 * second[2 * i1] + b2 * second[2 * i2];
            out.v2 = b0 * second[2 * i0 + 1] + b1 * second[2 * i1 + 1] + b2 * second[2 * i2 + 1];
        }
        float[] c = mesh.colors();
        if (c != null) {
            out.colorR = b0 * c[3 * i0] + b1 * c[3 * i1] + b2 * c[3 * i2];
            out.colorG = b0 * c[3 * i0 + 1] + b1 * c[3 * i1 + 1] + b2 * c[3 * i2 + 1];
            out.colorB = b0 * c[3 * i0 + 2] + b1 * c[3 * i1 + 2] + b2 * c[3 * i2 + 2];
        }
    }

    private void setShadingNormal(
            float[] normals, int i0, int i1, int i2, double b0, double b1, double b2, SurfacePoint out) {
        double[] work = out.scratch;
        toWorld.applyNormal(
                b0 * normals[i0] + b1 * normals[i1] + b2 * normals[i2],
                b0 * normals[i0 + 1] + b1 * normals[i1 + 1] + b2 * normals[i2 + 1],
                b0 * normals[i0 + 2] + b1 * normals[i1 + 2] + b2 * normals[i2 + 2],
                work);
        double length = Math.sqrt(work[0] * work[0] + work[1] * work[1] + work[2] * work[2]);
        double agreement = out.geometricCosine(work[0], work[1], work[2]);
        if (length > 0 && agreement != 0) {
            double scale = Math.copySign(1 / length, agreement);
            SurfaceFrames.setShading(out, scale * work[0], scale * work[1], scale * work[2]);
        }
    }

    /** Index of the first coordinate of a corner. */
    private int vertex(int triangle, int corner) {
        return 3 * mesh.triangles()[3 * triangle + corner];
    }

    /** Writes the cross product of two edges and returns its length, twice the area. */
    private double cross(int triangle, double[] dest) {
        int i0 = vertex(triangle, 0);
        int i1 = vertex(triangle, 1);
        int i2 = vertex(triangle, 2);
        double ax = positions[i1] - positions[i0];
        double ay = positions[i1 + 1] - positions[i0 + 1];
        double az = positions[i1 + 2] - positions[i0 + 2];
        double bx = positions[i2] - positions[i0];
        double by = positions[i2 + 1] - positions[i0 + 1];
        double bz = positions[i2 + 2] - positions[i0 + 2];
        dest[0] = ay * bz - az * by;
        dest[1] = az * bx - ax * bz;
        dest[2] = ax * by - ay * bx;
        return Math.sqrt(dest[0] * dest[0] + dest[1] * dest[1] + dest[2] * dest[2]);
    }
}
