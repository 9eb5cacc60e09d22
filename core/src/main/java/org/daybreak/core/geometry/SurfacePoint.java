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

    /**
     * Shading frame: tangent {@code s}, bitangent {@code t}, shading normal {@code n_s}; right-handed, orthonormal. For
     * materials that need tangents ({@code Bsdf.tangentFrame}) s lies along the derivative of the position by u, or along
     * the tangents of the vertices where a mesh has some, made orthogonal to the shading normal; for others, and where there
     * are no usable texture coordinates, it is arbitrary.
     */
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
     * Derivatives of the position by the texture coordinates in the shading frame, in world units per unit of u or v:
     * ∂p/∂u = {@code uAlongS}·s + {@code uAlongT}·t, ∂p/∂v = {@code vAlongS}·s + {@code vAlongT}·t, their parts along the
     * shading normal left out; {@code uAlongT} is 0 except on meshes with tangents of their own. All zero where there are no
     * usable texture coordinates; set only for materials that need tangents, by the texture coordinates that they name.
     */
    public double uAlongS;

    public double uAlongT;
    public double vAlongS;
    public double vAlongT;

    /** Second texture coordinates; the first ones on meshes without. */
    public double u2;

    public double v2;

    /** Colour of the vertices, interpolated, linear RGB; white on meshes without. */
    public double colorR = 1;

    public double colorG = 1;
    public double colorB = 1;

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
        uAlongS = o.uAlongS;
        uAlongT = o.uAlongT;
        vAlongS = o.vAlongS;
        vAlongT = o.vAlongT;
        u2 = o.u2;
        v2 = o.v2;
        colorR = o.colorR;
        colorG = o.colorG;
        colorB = o.colorB;
        offset = o.offset;
        shape = o.shape;
        primitive = o.primitive;
        instance = o.instance;
    }

    /** Sets what comes from optional vertex attributes to what it is without them: call it after u and v are set. */
    public void setNoAttributes() {
        u2 = u;
        v2 = v;
        colorR = 1;
        colorG = 1;
        colorB = 1;
    }

    /**
     * Turns the shading frame about the shading normal so that s lies along ∂p/∂u, and sets the derivatives by u and v.
     * Where the derivatives are not finite or have no area across the normal, the frame stays as it is and the derivatives
     * become 0.
     *
     * @param ux ∂p/∂u in world space, x
     * @param vx ∂p/∂v in world space, x
     */
    public void alignFrame(double ux, double uy, double uz, double vx, double vy, double vz) {
        double along = ux * nx + uy * ny + uz * nz;
        double px = ux - along * nx;
        double py = uy - along * ny;
        double pz = uz - along * nz;
        double length = Math.sqrt(px * px + py * py + pz * pz);
        double qx = px / length;
        double qy = py / length;
        double qz = pz / length;
        double rx = ny * qz - nz * qy;
        double ry = nz * qx - nx * qz;
        double rz = nx * qy - ny * qx;
        double across = vx * rx + vy * ry + vz * rz;
        if (!(Math.abs(across) * length > 0) || !(Math.abs(across) * length < Double.POSITIVE_INFINITY)) {
            uAlongS = 0;
            uAlongT = 0;
            vAlongS = 0;
            vAlongT = 0;
            return;
        }
        sx = qx;
        sy = qy;
        sz = qz;
        tx = rx;
        ty = ry;
        tz = rz;
        uAlongS = length;
        uAlongT = 0;
        vAlongS = vx * qx + vy * qy + vz * qz;
        vAlongT = across;
    }

    /**
     * Turns the shading frame about the shading normal so that s lies along a direction, derivatives with it. Does nothing
     * if the direction is that of the normal.
     *
     * @param dx direction in world space, of any length
     */
    public void turnFrame(double dx, double dy, double dz) {
        double alongS = localX(dx, dy, dz);
        double alongT = localY(dx, dy, dz);
        double length = Math.sqrt(alongS * alongS + alongT * alongT);
        double c = alongS / length;
        double d = alongT / length;
        if (!(Math.abs(c) + Math.abs(d) > 0)) {
            return;
        }
        double qx = c * sx + d * tx;
        double qy = c * sy + d * ty;
        double qz = c * sz + d * tz;
        tx = c * tx - d * sx;
        ty = c * ty - d * sy;
        tz = c * tz - d * sz;
        sx = qx;
        sy = qy;
        sz = qz;
        double us = uAlongS;
        uAlongS = c * us + d * uAlongT;
        uAlongT = c * uAlongT - d * us;
        double vs = vAlongS;
        vAlongS = c * vs + d * vAlongT;
        vAlongT = c * vAlongT - d * vs;
    }

    /**
     * Area on the surface per unit area of texture coordinates; negative where the image lies mirrored on the outer side, 0
     * where there are no usable texture coordinates.
     */
    public double uvArea() {
        return uAlongS * vAlongT - uAlongT * vAlongS;
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
