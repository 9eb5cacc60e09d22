package org.daybreak.metropolis.manifold;

import org.daybreak.core.geometry.SurfacePoint;

/**
 * What a specular chain starts or ends at: a position, or a direction. Mutable, owned by one worker.
 *
 * <p>A position is a vertex on a surface, or a point in free space such as a pinhole or a point light. A direction is that of parallel
 * rays: a light at infinity, or a camera of parallel rays.
 */
public final class ChainEnd {
    /**
     * The position; rays start here as from any surface point. Of a direction any point of the plane across it where rays start.
     * Material and shading frame do not matter.
     */
    public final SurfacePoint point = new SurfacePoint();

    /** True if the direction is fixed and not the position. */
    boolean parallel;

    /** True if areas here are measured across the geometric normal, false if across the last edge. */
    boolean surface;

    /** Unit direction of parallel rays, from the chain to this end. */
    double dx;

    double dy;
    double dz;

    /** Creates an end at the origin. */
    public ChainEnd() {}

    /** Makes this a vertex on a surface, where areas are those of the surface. */
    public void setSurface(SurfacePoint vertex) {
        point.set(vertex);
        parallel = false;
        surface = true;
    }

    /** Makes this a point in free space, where areas are those across the edge that leads here. */
    public void setFree(double x, double y, double z) {
        point.x = x;
        point.y = y;
        point.z = z;
        point.offset = 0;
        parallel = false;
        surface = false;
    }

    /**
     * Makes this a direction.
     *
     * @param x a point of the plane where rays start: the lens, or for lights at infinity beyond all geometry
     * @param toX unit direction from the chain to this end
     */
    public void setParallel(double x, double y, double z, double toX, double toY, double toZ) {
        setFree(x, y, z);
        parallel = true;
        dx = toX;
        dy = toY;
        dz = toZ;
    }

    /** Takes over another end. */
    public void set(ChainEnd o) {
        point.set(o.point);
        parallel = o.parallel;
        surface = o.surface;
        dx = o.dx;
        dy = o.dy;
        dz = o.dz;
    }
}
