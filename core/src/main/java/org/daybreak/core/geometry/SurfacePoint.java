package org.daybreak.core.geometry;

/**
 * A point on a surface with everything shading needs to know about the geometry there. Mutable and owned by one worker:
 * the intersection code fills it, path code copies it with {@link #set(SurfacePoint)}.
 *
 * <p>All directions are unit vectors in world space. The geometric normal points to the outer side of the shape (as its
 * winding, its definition or a flip says), not towards the ray; mirroring transforms keep "outer" outer.
 * The shading normal lies on the same side as the geometric normal.
 */
public final class SurfacePoint {
    /** Position in world space. */
    public double x;

    public double y;
    public double z;

    /** Geometric normal {@code n_g}. */
    public double gx;

    public double gy;
    public double gz;

    /** Shading frame: tangent {@code s}, bitangent {@code t}, shading normal {@code n_s}; right-handed, orthonormal. */
    public double sx;

    public double sy;
    public double sz;
    public double tx;
    public double ty;
    public double tz;
    public double nx;
    public double ny;
    public double nz;

    /** Texture coordinates. */
    public double u;

    public double v;

    /**
     * How far along {@code ±n_g} a spawned ray must start so that it neither hits this surface again nor skips a
     * neighbour: a bound of all rounding errors of position and traversal, in world units. It scales with the scene.
     */
    public double offset;

    /** Index of the shape in the scene's shape table: selects BSDF and area light. */
    public int shape;

    /** Primitive within the shape's level of the acceleration structure (a triangle index for meshes). */
    public int primitive;

    /** Index of the instance the point belongs to, or -1 for geometry that is not instanced. */
    public int instance;

    /** Room for intermediate results of the code that fills this point, so that it need not allocate. No state. */
    final double[] scratch = new double[5];

    /** Copies all values of another point. */
    public void set(SurfacePoint o) {
        x = o.x;
        y = o.y;
        z = o.z;
        gx = o.gx;
        gy = o.gy;
        gz = o.gz;
        sx = o.sx;
        sy = o.sy;
        sz = o.sz;
        tx = o.tx;
        ty = o.ty;
        tz = o.tz;
        nx = o.nx;
        ny = o.ny;
        nz = o.nz;
        u = o.u;
        v = o.v;
        offset = o.offset;
        shape = o.shape;
        primitive = o.primitive;
        instance = o.instance;
    }

    /** First shading-frame component of a world-space direction: {@code d·s}. */
    public double localX(double dx, double dy, double dz) {
        return dx * sx + dy * sy + dz * sz;
    }

    /** Second shading-frame component of a world-space direction: {@code d·t}. */
    public double localY(double dx, double dy, double dz) {
        return dx * tx + dy * ty + dz * tz;
    }

    /** Third shading-frame component of a world-space direction: {@code d·n_s}. */
    public double localZ(double dx, double dy, double dz) {
        return dx * nx + dy * ny + dz * nz;
    }

    /** Cosine between a world-space direction and the geometric normal: {@code d·n_g}. */
    public double geometricCosine(double dx, double dy, double dz) {
        return dx * gx + dy * gy + dz * gz;
    }
}
