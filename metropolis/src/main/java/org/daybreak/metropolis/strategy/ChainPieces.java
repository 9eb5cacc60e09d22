package org.daybreak.metropolis.strategy;

import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.Outcome;
import org.daybreak.metropolis.manifold.ChainEnd;
import org.daybreak.metropolis.manifold.ManifoldTangents;
import org.daybreak.metropolis.manifold.SpecularChain;
import org.daybreak.metropolis.manifold.SpecularManifold;
import org.daybreak.metropolis.manifold.WalkOutcome;

/**
 * Chains of delta lobes between two vertices c and b of a {@link LightPath}: moves them with b while c stays, and knows their density.
 * One object per worker.
 */
final class ChainPieces {
    private final Scene scene;
    private final Failure failure;
    private final SpecularManifold manifold;
    private final ManifoldTangents tangents = new ManifoldTangents();
    private final SpecularChain before = new SpecularChain();
    private final SpecularChain after = new SpecularChain();
    private final ChainEnd target = new ChainEnd();

    /** A sphere around all geometry. */
    private final double centreX;

    private final double centreY;
    private final double centreZ;
    private final double radius;

    ChainPieces(RayCaster caster, Failure failure) {
        this.failure = failure;
        scene = caster.scene();
        manifold = new SpecularManifold(caster);
        Bounds bounds = scene.bounds();
        boolean empty = bounds.isEmpty();
        centreX = empty ? 0 : 0.5 * (bounds.minX() + bounds.maxX());
        centreY = empty ? 0 : 0.5 * (bounds.minY() + bounds.maxY());
        centreZ = empty ? 0 : 0.5 * (bounds.minZ() + bounds.maxZ());
        double x = empty ? 0 : bounds.maxX() - centreX;
        double y = empty ? 0 : bounds.maxY() - centreY;
        double z = empty ? 0 : bounds.maxZ() - centreZ;
        radius = Math.sqrt(x * x + y * y + z * z);
    }

    /** Takes a chain out of a path, from c on. */
    private boolean extract(LightPath path, int c, int b, SpecularChain chain) {
        int step = b > c ? 1 : -1;
        int n = Math.abs(b - c) - 1;
        chain.setLength(n);
        chain.mode = b > c ? TransportMode.IMPORTANCE : TransportMode.RADIANCE;
        for (int i = 0; i < n; i++) {
            chain.points[i].set(path.points[c + step * (i + 1)]);
            chain.lobes[i] = path.lobe[c + step * (i + 1)];
        }
        if (c == 0 && path.infinite) {
            double x = -path.dx[0];
            double y = -path.dy[0];
            double z = -path.dz[0];
            double far = 1.5 * radius;
            chain.start.setParallel(centreX + far * x, centreY + far * y, centreZ + far * z, x, y, z);
        } else {
            chain.start.setSurface(path.points[c]);
        }
        chain.end.setSurface(path.points[b]);
        return manifold.follow(chain);
    }

    /**
     * Moves the chain between c and b so that it leads to the new b, and sets its vertices and edges in the new path but for the clearness
     * of the edge at b, which is to be revealed.
     *
     * @param x the old path
     * @param y the new one, in which c and b are set
     */
    boolean move(LightPath x, LightPath y, int c, int b) {
        if (!extract(x, c, b, before)) {
            return failure.because(Outcome.UNREACHABLE);
        }
        target.setSurface(y.points[b]);
        WalkOutcome outcome = manifold.walk(before, target, after);
        if (outcome != WalkOutcome.CONVERGED) {
            return failure.because(
                    outcome == WalkOutcome.MISSED
                            ? Outcome.MISSED
                            : outcome == WalkOutcome.KIND_CHANGED ? Outcome.KIND_CHANGED : Outcome.UNREACHABLE);
        }
        int step = b > c ? 1 : -1;
        for (int i = 0; i < after.length(); i++) {
            int vertex = c + step * (i + 1);
            SurfacePoint point = after.points[i];
            Bsdf bsdf = scene.bsdf(point.shape);
            y.points[vertex].set(point);
            y.setVertex(vertex, bsdf, bsdf.maybeTransparent() ? 1 - bsdf.transparency(point) : 1);
            y.lobe[vertex] = after.lobes[i];
            setEdge(y, Math.min(vertex, vertex - step));
        }
        setEdge(y, Math.min(b, b - step));
        return true;
    }

    /** Sets the edge between two neighbours that nothing stands between, as far as is known. */
    static void setEdge(LightPath y, int edge) {
        y.clear[edge] = 1;
        if (edge == 0 && y.infinite) {
            y.squared[0] = Double.POSITIVE_INFINITY;
        } else {
            y.setEdge(edge);
        }
    }

    /** True if the walk of the last {@link #move} can be undone, and both densities of it are known. */
    boolean isReversible() {
        return tangents.set(scene, before) && tangents.set(scene, after) && manifold.leadsBack(before, after);
    }

    /**
     * Density of the vertices between c and b, which both stay: c's rays that find b lead over them alone. As a density by which
     * c's rays find them and b in turn, it is that of the vertices after the first one, divided by how much that one moves with b:
     * |det ∂x₁/∂x_b|.
     */
    double density(LightPath path, int c, int b) {
        if (!extract(path, c, b, after) || !tangents.set(scene, after)) {
            return 0;
        }
        double density = 1;
        if (b > c) {
            for (int i = c + 2; i <= b; i++) {
                density *= path.fromLight[i];
            }
        } else {
            for (int i = c - 2; i >= b; i--) {
                density *= path.fromEye[i];
            }
        }
        return density / tangents.firstPerEnd();
    }
}
