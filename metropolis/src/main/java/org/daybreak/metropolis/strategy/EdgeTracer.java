package org.daybreak.metropolis.strategy;

import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.Outcome;

/**
 * What stands between the vertices of a {@link LightPath}: traces edges that lead to a new vertex, and tests those that
 * join two which were there (V(x↔x′) in Veach 1997, eq. 8.2). Alpha masks are passed by chance where a ray is traced,
 * and count with the fraction of light that they let pass where an edge is tested. One object per worker.
 */
final class EdgeTracer {
    private final Scene scene;
    private final RayCaster caster;
    private final Failure failure;
    private final SurfacePoint veil = new SurfacePoint();

    EdgeTracer(RayCaster caster, Failure failure) {
        this.caster = caster;
        this.failure = failure;
        scene = caster.scene();
    }

    /** Number of rays of a kind traced so far. */
    long rays(RayKind kind) {
        return caster.count(kind);
    }

    /**
     * Traces along the edge between two vertices, whose direction is set; passes alpha masks by chance.
     *
     * @param to one more or less than {@code from}
     * @return false if nothing is met
     */
    boolean trace(LightPath y, int from, int to, RayKind kind, RandomStream random) {
        int edge = Math.min(from, to);
        double sign = to > from ? 1 : -1;
        double x = sign * y.dx[edge];
        double yy = sign * y.dy[edge];
        double z = sign * y.dz[edge];
        SurfacePoint a = y.points[from];
        SurfacePoint b = y.points[to];
        double clear = 1;
        boolean found = kind == RayKind.CAMERA
                ? caster.trace(a.x, a.y, a.z, x, yy, z, kind, b)
                : caster.trace(a, x, yy, z, kind, b);
        while (found) {
            Bsdf bsdf = scene.bsdf(b.shape);
            double transparency = bsdf.maybeTransparent() ? bsdf.transparency(b) : 0;
            if (transparency == 0 || random.nextDouble() >= transparency) {
                y.setVertex(to, bsdf, 1 - transparency);
                y.clear[edge] = clear;
                double ex = b.x - a.x;
                double ey = b.y - a.y;
                double ez = b.z - a.z;
                y.squared[edge] = from == 0 && y.infinite ? Double.POSITIVE_INFINITY : ex * ex + ey * ey + ez * ez;
                return true;
            }
            clear *= transparency;
            veil.set(b);
            found = caster.trace(veil, x, yy, z, RayKind.SCATTERED, b);
        }
        y.clear[edge] = clear;
        y.squared[edge] = Double.POSITIVE_INFINITY;
        return failure.becauseRayEscaped();
    }

    /**
     * Tests an edge that was joined, not traced, for occlusion, and multiplies the contribution with the fraction that
     * it lets pass. Its {@code clear} must be 1 so far.
     */
    boolean reveal(LightPath y, int edge) {
        double visible = edge == 0 && y.infinite
                ? caster.transmittanceToInfinity(y.points[1], -y.dx[0], -y.dy[0], -y.dz[0])
                : caster.transmittance(y.points[edge], y.points[edge + 1]);
        if (visible == 0) {
            return failure.because(Outcome.OCCLUDED);
        }
        y.clear[edge] = visible;
        if (visible != 1) {
            y.value.scale(visible);
            y.contribution *= visible;
        }
        return true;
    }

    /** Fraction of light that does not pass straight through the surface at a point. */
    double opacity(SurfacePoint p) {
        Bsdf bsdf = scene.bsdf(p.shape);
        return bsdf.maybeTransparent() ? 1 - bsdf.transparency(p) : 1;
    }
}
