package org.daybreak.core.geometry;

import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Densities;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.DiscreteDistribution;
import org.daybreak.core.sampling.Warps;
import org.jspecify.annotations.Nullable;

/**
 * A triangle mesh under an affine map. By area, points are drawn uniformly, or triangles in proportion to their brightness if
 * that varies; by direction, triangles are chosen by an {@link EmitterTree}, so that of many the near ones that face the
 * point are preferred. The first number chooses the triangle, and what is left of it the point, so neighbouring numbers stay
 * neighbouring points. Triangles without area are never chosen.
 */
final class MeshSampler implements SurfaceSampler {
    /** Part of the points that does not follow the brightness. */
    private static final double UNIFORM_SHARE = 0.02;

    /** Bounds of the samples along each side of a triangle that its brightness is averaged over. */
    private static final int LEAST_STEPS = 2;

    private static final int MOST_STEPS = 64;

    private final TriangleMesh mesh;
    private final Transform toWorld;
    private final double side;
    /** World position of each vertex. */
    private final double[] positions;

    private final int firstPrimitive;
    private final @Nullable DiscreteDistribution triangles;
    private final EmitterTree tree;
    private final boolean patterned;
    private final SurfaceMoments moments;
    private final double offset;

    MeshSampler(
            TriangleMesh mesh,
            Transform toWorld,
            boolean flipNormals,
            int firstPrimitive,
            @Nullable SurfaceBrightness brightness) {
        this.mesh = mesh;
        this.toWorld = toWorld;
        this.firstPrimitive = firstPrimitive;
        patterned = brightness != null;
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
        double[] weights = brightness == null ? areas : weights(areas, brightness);
        tree = EmitterTree.of(emissionBounds(areas, weights), 1);
        if (bounds.isEmpty()) {
            triangles = null;
            moments = builder.build(0, 0, 0, 0);
            offset = 0;
            return;
        }
        triangles = new DiscreteDistribution(weights);
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

    /** Area times brightness of each triangle, with a small share of the mean brightness for what the samples miss. */
    private double[] weights(double[] areas, SurfaceBrightness brightness) {
        double[] weights = new double[areas.length];
        double[] work = new double[2];
        double total = 0;
        double area = 0;
        for (int i = 0; i < areas.length; i++) {
            int steps = steps(i, brightness.detail());
            double sum = 0;
            for (int k = 0; k < steps * steps; k++) {
                Warps.toTriangle((k % steps + 0.5) / steps, (Math.floorDiv(k, steps) + 0.5) / steps, work);
                double b0 = 1 - work[0] - work[1];
                sum += brightness.at(
                        textureCoordinate(i, 0, b0, work[0], work[1]), textureCoordinate(i, 1, b0, work[0], work[1]));
            }
            weights[i] = areas[i] * sum / (steps * steps);
            total += weights[i];
            area += areas[i];
        }
        double floor = area > 0 ? UNIFORM_SHARE / (1 - UNIFORM_SHARE) * total / area : 0;
        for (int i = 0; i < areas.length; i++) {
            weights[i] += floor * areas[i];
        }
        return weights;
    }

    /** Number of samples along each side of a triangle, by the share of the texture that it covers. */
    private int steps(int triangle, int detail) {
        double u0 = textureCoordinate(triangle, 0, 1, 0, 0);
        double v0 = textureCoordinate(triangle, 1, 1, 0, 0);
        double cross = (textureCoordinate(triangle, 0, 0, 1, 0) - u0) * (textureCoordinate(triangle, 1, 0, 0, 1) - v0)
                - (textureCoordinate(triangle, 0, 0, 0, 1) - u0) * (textureCoordinate(triangle, 1, 0, 1, 0) - v0);
        double steps = Math.ceil(detail * Math.sqrt(0.5 * Math.abs(cross)));
        return (int) Math.max(LEAST_STEPS, Math.min(MOST_STEPS, steps));
    }

    private EmissionBounds[] emissionBounds(double[] areas, double[] weights) {
        EmissionBounds[] all = new EmissionBounds[areas.length];
        double[] n = new double[3];
        double area = 0;
        double weight = 0;
        for (int i = 0; i < areas.length; i++) {
            area += areas[i];
            weight += weights[i];
        }
        // Intensities are those of unit radiance in the mean.
        double scale = weight > 0 ? area / weight : 0;
        for (int i = 0; i < areas.length; i++) {
            Bounds.Builder box = new Bounds.Builder();
            for (int corner = 0; corner < 3; corner++) {
                int at = vertex(i, corner);
                box.include(positions[at], positions[at + 1], positions[at + 2]);
            }
            double turn = areas[i] > 0 ? side / cross(i, n) : 0;
            all[i] = new EmissionBounds(
                    box.build(), turn * n[0], turn * n[1], turn * n[2], 0, Math.PI / 2, scale * weights[i]);
        }
        return all;
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
        double area = 0.5 * fill(triangle, triangles.remainder(u, triangle), v, out);
        return triangles.probability(triangle) / area;
    }

    /** Sets a point of a triangle and returns the double of its area. */
    private double fill(int triangle, double u, double v, SurfacePoint out) {
        double[] work = out.scratch;
        Warps.toTriangle(u, v, work);
        double b1 = work[0];
        double b2 = work[1];
        double b0 = 1 - b1 - b2;
        int i0 = vertex(triangle, 0);
        int i1 = vertex(triangle, 1);
        int i2 = vertex(triangle, 2);
        out.x = b0 * positions[i0] + b1 * positions[i1] + b2 * positions[i2];
        out.y = b0 * positions[i0 + 1] + b1 * positions[i1 + 1] + b2 * positions[i2 + 1];
        out.z = b0 * positions[i0 + 2] + b1 * positions[i1 + 2] + b2 * positions[i2 + 2];
        double twiceArea = cross(triangle, work);
        double scale = side / twiceArea;
        SurfaceFrames.set(out, scale * work[0], scale * work[1], scale * work[2]);
        float[] normals = mesh.normals();
        if (normals != null) {
            setShadingNormal(normals, i0, i1, i2, b0, b1, b2, out);
        }
        out.u = textureCoordinate(triangle, 0, b0, b1, b2);
        out.v = textureCoordinate(triangle, 1, b0, b1, b2);
        setAttributes(triangle, b0, b1, b2, out);
        out.offset = offset;
        out.primitive = firstPrimitive + triangle;
        return twiceArea;
    }

    private double textureCoordinate(int triangle, int axis, double b0, double b1, double b2) {
        float[] uvs = mesh.uvs();
        if (uvs == null) {
            return axis == 0 ? b1 : b2;
        }
        int[] indices = mesh.triangles();
        return b0 * uvs[2 * indices[3 * triangle] + axis]
                + b1 * uvs[2 * indices[3 * triangle + 1] + axis]
                + b2 * uvs[2 * indices[3 * triangle + 2] + axis];
    }

    @Override
    public double areaDensity(SurfacePoint on) {
        if (triangles == null) {
            return 0;
        }
        if (!patterned) {
            return 1 / moments.area();
        }
        int triangle = on.primitive - firstPrimitive;
        return triangles.probability(triangle) / (0.5 * cross(triangle, on.scratch));
    }

    @Override
    public double sampleDirection(double px, double py, double pz, double u, double v, SurfacePoint out) {
        double[] choice = out.scratch;
        int leaf = tree.choose(px, py, pz, 0, 0, 0, u, choice);
        if (leaf < 0) {
            return 0;
        }
        double probability = choice[0];
        double twiceArea = fill(tree.emitter(tree.leafStart(leaf)), choice[1], v, out);
        return SurfaceSampler.perSolidAngle(2 * probability / twiceArea, px, py, pz, out);
    }

    @Override
    public double directionDensity(
            double px, double py, double pz, SurfacePoint on, double wiX, double wiY, double wiZ) {
        int triangle = on.primitive - firstPrimitive;
        int leaf = tree.leafOf(triangle);
        double cosine = -on.geometricCosine(wiX, wiY, wiZ);
        if (leaf < 0 || !(cosine > 0)) {
            return 0;
        }
        double probability = tree.probability(leaf, px, py, pz, 0, 0, 0);
        double dx = on.x - px;
        double dy = on.y - py;
        double dz = on.z - pz;
        double perArea = 2 * probability / cross(triangle, on.scratch);
        return Densities.areaToSolidAngle(perArea, dx * dx + dy * dy + dz * dz, cosine);
    }

    @Override
    public @Nullable EmissionBounds bounds() {
        return tree.bounds();
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
