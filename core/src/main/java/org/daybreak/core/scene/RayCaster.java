package org.daybreak.core.scene;

import org.daybreak.core.accel.HitRefinement;
import org.daybreak.core.accel.Intersector;
import org.daybreak.core.accel.Ray;
import org.daybreak.core.geometry.SurfacePoint;

/**
 * Casts rays into a scene for one worker: spawns them robustly, resolves hits and counts by kind. All algorithms trace
 * through here, so self-intersection is handled in one place.
 *
 * <p>Rays that start on a surface are moved by {@link SurfacePoint#offset} along ±n_g, to the side they leave to; rays
 * that end on one are shortened likewise. There is no absolute epsilon.
 */
public final class RayCaster {
    private static final RayKind[] KINDS = RayKind.values();

    /** Occlusion rays end this fraction of their length before the target: float rounding of the ray parameter. */
    private static final double SHADOW_END = 1 - 0x1p-20;

    private final Scene scene;
    private final Intersector intersector;
    private final Ray ray = new Ray();
    private final HitRefinement refinement = new HitRefinement();
    private final SurfacePoint veil = new SurfacePoint();
    private final long[] counts = new long[KINDS.length];

    /** Creates a caster; one per worker. */
    public RayCaster(Scene scene) {
        this.scene = scene;
        this.intersector = scene.intersector();
    }

    /** The scene rays are cast into. */
    public Scene scene() {
        return scene;
    }

    /**
     * Finds the nearest surface seen from a surface point. Holes of alpha masks are no surface.
     *
     * @param from where the ray starts
     * @param dx unit direction
     * @param hit receives the surface point; undefined if nothing is hit; may be the same object as {@code from}
     * @return true if something is hit
     */
    public boolean trace(SurfacePoint from, double dx, double dy, double dz, RayKind kind, SurfacePoint hit) {
        double o = from.geometricCosine(dx, dy, dz) < 0 ? -from.offset : from.offset;
        return trace(from.x + o * from.gx, from.y + o * from.gy, from.z + o * from.gz, dx, dy, dz, kind, hit);
    }

    /** Finds the nearest surface seen from a point in space: {@link #trace(SurfacePoint, double, double, double, RayKind, SurfacePoint)}. */
    public boolean trace(
            double ox, double oy, double oz, double dx, double dy, double dz, RayKind kind, SurfacePoint hit) {
        counts[kind.ordinal()]++;
        ray.set(ox, oy, oz, dx, dy, dz, Double.POSITIVE_INFINITY);
        if (!intersector.intersect(ray)) {
            return false;
        }
        scene.resolve(ray, refinement, hit);
        return !scene.maybeTransparent() || pastHoles(dx, dy, dz, kind, hit);
    }

    /**
     * Goes on from a hit as long as there is a hole: alpha masks of opacity 0 are left behind here, without sampling their
     * material. No random number decides, so the expectation is that of sampling them, which always lets the ray pass.
     */
    private boolean pastHoles(double dx, double dy, double dz, RayKind kind, SurfacePoint hit) {
        while (scene.isHole(hit)) {
            double o = hit.geometricCosine(dx, dy, dz) < 0 ? -hit.offset : hit.offset;
            counts[kind.ordinal()]++;
            ray.set(hit.x + o * hit.gx, hit.y + o * hit.gy, hit.z + o * hit.gz, dx, dy, dz, Double.POSITIVE_INFINITY);
            if (!intersector.intersect(ray)) {
                return false;
            }
            scene.resolve(ray, refinement, hit);
        }
        return true;
    }

    /**
     * Fraction of light that gets from one point to another: 0 if a surface is between, 1 if nothing is, in between only
     * through alpha masks. Points in free space (pinhole, point light) have offset 0.
     */
    public double transmittance(SurfacePoint a, SurfacePoint b) {
        double dx = b.x - a.x;
        double dy = b.y - a.y;
        double dz = b.z - a.z;
        double oa = a.geometricCosine(dx, dy, dz) < 0 ? -a.offset : a.offset;
        double ob = b.geometricCosine(dx, dy, dz) > 0 ? -b.offset : b.offset;
        double ox = a.x + oa * a.gx;
        double oy = a.y + oa * a.gy;
        double oz = a.z + oa * a.gz;
        return between(ox, oy, oz, b.x + ob * b.gx - ox, b.y + ob * b.gy - oy, b.z + ob * b.gz - oz, SHADOW_END);
    }

    /** Fraction of light that gets from infinity to a point against a unit direction that points away from it. */
    public double transmittanceToInfinity(SurfacePoint a, double dx, double dy, double dz) {
        double o = a.geometricCosine(dx, dy, dz) < 0 ? -a.offset : a.offset;
        return between(a.x + o * a.gx, a.y + o * a.gy, a.z + o * a.gz, dx, dy, dz, Double.POSITIVE_INFINITY);
    }

    /** Number of rays of a kind cast so far. */
    public long count(RayKind kind) {
        return counts[kind.ordinal()];
    }

    /** Number of rays of all kinds cast so far. */
    public long total() {
        long sum = 0;
        for (long count : counts) {
            sum += count;
        }
        return sum;
    }

    private double between(double ox, double oy, double oz, double dx, double dy, double dz, double end) {
        counts[RayKind.SHADOW.ordinal()]++;
        ray.set(ox, oy, oz, dx, dy, dz, end);
        if (!scene.maybeTransparent()) {
            return intersector.occluded(ray) ? 0 : 1;
        }
        return throughVeils(dx, dy, dz, end);
    }

    /**
     * Follows an occlusion ray through alpha masks, whose transparencies multiply. Behind each it aims at the same end point
     * anew: the offset from the mask may be longer than the gap that is left before the target.
     */
    private double throughVeils(double dx, double dy, double dz, double end) {
        boolean infinite = end == Double.POSITIVE_INFINITY;
        double endX = ray.ox + end * dx;
        double endY = ray.oy + end * dy;
        double endZ = ray.oz + end * dz;
        double transmittance = 1;
        while (intersector.intersect(ray)) {
            scene.resolve(ray, refinement, veil);
            transmittance *= scene.bsdf(veil.shape).transparency(veil);
            if (transmittance == 0) {
                return 0;
            }
            double o = veil.geometricCosine(dx, dy, dz) < 0 ? -veil.offset : veil.offset;
            double x = veil.x + o * veil.gx;
            double y = veil.y + o * veil.gy;
            double z = veil.z + o * veil.gz;
            counts[RayKind.SHADOW.ordinal()]++;
            if (infinite) {
                ray.set(x, y, z, dx, dy, dz, end);
                continue;
            }
            double leftX = endX - x;
            double leftY = endY - y;
            double leftZ = endZ - z;
            if (!(leftX * dx + leftY * dy + leftZ * dz > 0)) {
                break;
            }
            ray.set(x, y, z, leftX, leftY, leftZ, 1);
        }
        return transmittance;
    }
}
