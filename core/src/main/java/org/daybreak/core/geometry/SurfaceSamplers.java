package org.daybreak.core.geometry;

import org.daybreak.core.math.Transform;
import org.jspecify.annotations.Nullable;

/** Makes the sampler for a shape. */
public final class SurfaceSamplers {
    private SurfaceSamplers() {}

    /**
     * The sampler of a shape in its place. A mirroring transform keeps the outer side outer.
     *
     * @param toWorld map from the shape's to world coordinates
     * @param flipNormals whether front and back are exchanged
     */
    public static SurfaceSampler of(Shape shape, Transform toWorld, boolean flipNormals) {
        return of(shape, toWorld, flipNormals, 0, null);
    }

    /**
     * The sampler of a shape in its place. A mirroring transform keeps the outer side outer.
     *
     * @param toWorld map from the shape's to world coordinates
     * @param flipNormals whether front and back are exchanged
     * @param firstPrimitive number of the shape's first primitive in its level, for {@link SurfacePoint#primitive}
     * @param brightness what rectangles and meshes draw points in proportion to; null if it is the same everywhere
     */
    public static SurfaceSampler of(
            Shape shape,
            Transform toWorld,
            boolean flipNormals,
            int firstPrimitive,
            @Nullable SurfaceBrightness brightness) {
        if (shape instanceof TriangleMesh mesh) {
            return new MeshSampler(mesh, toWorld, flipNormals, firstPrimitive, brightness);
        }
        if (shape instanceof Sphere sphere) {
            return new SphereSampler(toWorld.multiply(ShapeFrames.of(sphere)), flipNormals);
        }
        if (shape instanceof Rectangle) {
            ParallelogramSampler plain = new ParallelogramSampler(toWorld, flipNormals);
            return brightness == null ? plain : new PatternSampler(plain, brightness);
        }
        if (shape instanceof Disk) {
            return new DiskSampler(toWorld, flipNormals);
        }
        if (shape instanceof Cube) {
            return new MeshSampler(CubeMesh.MESH, toWorld, flipNormals, firstPrimitive, brightness);
        }
        if (shape instanceof Cylinder cylinder) {
            return new CylinderSampler(toWorld.multiply(ShapeFrames.of(cylinder)), 0, false, flipNormals);
        }
        if (shape instanceof Cone cone) {
            return new CylinderSampler(
                    toWorld.multiply(ShapeFrames.of(cone)), cone.taper(), cone.widens(), flipNormals);
        }
        throw new AssertionError("no sampler for " + shape.getClass());
    }
}
