package org.daybreak.metropolis.manifold;

import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.BsdfSample;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;

/**
 * Walks on specular manifolds (Jakob and Marschner 2012): moves one end of a chain of delta lobes while the other one stays.
 * Owned by one worker; holds all scratch space, so that a walk allocates nothing once chains of that length have been met.
 *
 * <p>A step predicts x₁ by the {@linkplain ManifoldTangents tangents} of the chain and comes back to the manifold by tracing a ray from x_a
 * through the prediction and following the same lobes. It counts if it leads nearer to the target; otherwise half of it is
 * tried. As in Newton's method the error is squared with each step once it is small.
 *
 * <p>Error is measured where the target is: across the ray that leaves the last vertex, as a part of the distance along it, which for a
 * direction is the tangent of an angle. It does not depend on the scale of the scene nor on the surface that the target lies on. Whether that
 * last edge is free is left to the caller. Alpha masks are met as they are: only holes are passed.
 */
public final class SpecularManifold {
    /**
     * Largest number of steps and halved steps of a walk. Of the walks that arrive within 30, some 99 % need no more than this, in
     * scenes with caustics; most need 2 to 4. Those that do not arrive, as no chain leads to the target, would cost more than all others.
     */
    public static final int MOST_ITERATIONS = 10;

    /** Error at which a walk has arrived. */
    public static final double TOLERANCE = 1e-8;

    /**
     * Distance between vertices of a chain and of the walk back to it, as a part of the edges around, that still counts as
     * the same: far more than walks leave, whose vertices are as exact as the root of the tolerance even at a caustic, and far
     * less than the distance of different chains.
     */
    private static final double SAME = 1e-3;

    /**
     * What may be added to that, as a multiple of how far rays start off the surfaces of the chain: one that was traced from the other
     * end differs by this at slanting angles, which matters in narrow corners of large triangles.
     */
    private static final double SLACK = 10;

    private final Scene scene;
    private final RayCaster caster;
    private final ManifoldTangents tangents = new ManifoldTangents();
    private final BsdfSample scattered = new BsdfSample();
    private SpecularChain current = new SpecularChain();
    private SpecularChain trial = new SpecularChain();
    private final SpecularChain back = new SpecularChain();
    private int iterations;
    /** Why the trial in hand has failed. */
    private WalkOutcome failure = WalkOutcome.STALLED;

    /** What is left to the target from the chain last looked at: a vector across its last ray, and its length relative. */
    private double restX;

    private double restY;
    private double restZ;
    private double error;

    /** Distance of the target along that ray; of a direction the cosine. */
    private double along;

    /** Creates a solver that traces with the caster of its worker. */
    public SpecularManifold(RayCaster caster) {
        this.caster = caster;
        scene = caster.scene();
    }

    /** Number of steps and halved steps of the last walk, the walk back of {@link #walkReversibly} included. */
    public int iterations() {
        return iterations;
    }

    /**
     * Completes a chain whose ends, vertices, lobes and mode are set: follows the lobes at the given vertices, without tracing.
     *
     * @return false if a lobe is black or leads nowhere
     */
    public boolean follow(SpecularChain chain) {
        chain.throughput.set(1);
        double x = chain.start.dx;
        double y = chain.start.dy;
        double z = chain.start.dz;
        SurfacePoint before = chain.start.point;
        for (int i = 0; i < chain.length(); i++) {
            SurfacePoint here = chain.points[i];
            if (i > 0 || !chain.start.parallel) {
                x = before.x - here.x;
                y = before.y - here.y;
                z = before.z - here.z;
                double inverse = 1 / Math.sqrt(x * x + y * y + z * z);
                x *= inverse;
                y *= inverse;
                z *= inverse;
            }
            if (!scatter(chain, i, x, y, z)) {
                return false;
            }
            chain.transmits[i] =
                    here.geometricCosine(x, y, z) * here.geometricCosine(chain.lastX, chain.lastY, chain.lastZ) < 0;
            before = here;
        }
        return true;
    }

    /** Follows the lobe of a vertex from a direction that points to the vertex before. */
    private boolean scatter(SpecularChain chain, int i, double x, double y, double z) {
        SurfacePoint here = chain.points[i];
        Bsdf bsdf = scene.bsdf(here.shape);
        if (!Scattering.deltaLobe(bsdf, here, x, y, z, chain.lobes[i], chain.mode, scattered)) {
            return false;
        }
        chain.eta[i] = scattered.eta;
        chain.throughput.mul(scattered.weight);
        chain.lastX = scattered.wiX;
        chain.lastY = scattered.wiY;
        chain.lastZ = scattered.wiZ;
        return true;
    }

    /**
     * Moves the end of a chain.
     *
     * @param from a chain that {@link #follow} has completed; not changed
     * @param target the new end
     * @param to receives the chain to the target, with the same lobes; undefined unless the walk converges. Not {@code from}
     */
    public WalkOutcome walk(SpecularChain from, ChainEnd target, SpecularChain to) {
        iterations = 0;
        return continueWalk(from, target, to);
    }

    /**
     * Moves the end of a chain as {@link #walk} does, and fails if the same walk from there back does not find the old
     * chain. A proposal that cannot be undone must not be made.
     */
    public WalkOutcome walkReversibly(SpecularChain from, ChainEnd target, SpecularChain to) {
        WalkOutcome outcome = walk(from, target, to);
        return outcome == WalkOutcome.CONVERGED && !leadsBack(from, to) ? WalkOutcome.NOT_REVERSIBLE : outcome;
    }

    /** True if the walk back from where a walk has led finds the old chain. */
    public boolean leadsBack(SpecularChain from, SpecularChain to) {
        return continueWalk(to, from.end, back) == WalkOutcome.CONVERGED && isSame(from, back);
    }

    private WalkOutcome continueWalk(SpecularChain from, ChainEnd target, SpecularChain to) {
        current.set(from);
        if (!measure(current, target)) {
            return WalkOutcome.BEHIND;
        }
        double size = 1;
        double stepX = 0;
        double stepY = 0;
        double stepZ = 0;
        boolean predicted = false;
        WalkOutcome lastFailure = WalkOutcome.STALLED;
        for (int left = MOST_ITERATIONS; error > TOLERANCE; left--) {
            if (left == 0) {
                return lastFailure;
            }
            iterations++;
            if (!predicted) {
                aim(current, target);
                if (!tangents.set(scene, current)) {
                    return WalkOutcome.SINGULAR;
                }
                tangents.solve(restX, restY, restZ);
                stepX = tangents.step(0);
                stepY = tangents.step(1);
                stepZ = tangents.step(2);
                predicted = true;
            }
            double before = error;
            SurfacePoint first = current.points[0];
            trial.set(current);
            failure = WalkOutcome.STALLED;
            boolean nearer = trace(trial, first.x + size * stepX, first.y + size * stepY, first.z + size * stepZ)
                    && measure(trial, target)
                    && error < before;
            if (nearer) {
                SpecularChain swapped = current;
                current = trial;
                trial = swapped;
                size = Math.min(1, 2 * size);
                predicted = false;
            } else {
                lastFailure = failure;
                error = before;
                size *= 0.5;
            }
        }
        to.set(current);
        to.end.set(target);
        return WalkOutcome.CONVERGED;
    }

    /**
     * Measures what is left to the target across the last ray of a chain.
     *
     * @return false if the target lies behind
     */
    private boolean measure(SpecularChain chain, ChainEnd target) {
        double x = target.dx;
        double y = target.dy;
        double z = target.dz;
        if (!target.parallel) {
            SurfacePoint last = chain.points[chain.length() - 1];
            x = target.point.x - last.x;
            y = target.point.y - last.y;
            z = target.point.z - last.z;
        }
        double distance = x * chain.lastX + y * chain.lastY + z * chain.lastZ;
        if (!(distance > 0)) {
            failure = WalkOutcome.BEHIND;
            return false;
        }
        along = distance;
        restX = x - distance * chain.lastX;
        restY = y - distance * chain.lastY;
        restZ = z - distance * chain.lastZ;
        error = Math.sqrt(restX * restX + restY * restY + restZ * restZ) / distance;
        return true;
    }

    /**
     * Puts the end of the chain that was measured last on its last ray, as far away as the target: tangents are those of the
     * plane across the ray.
     */
    private void aim(SpecularChain chain, ChainEnd target) {
        SurfacePoint last = chain.points[chain.length() - 1];
        if (target.parallel) {
            chain.end.setParallel(last.x, last.y, last.z, chain.lastX, chain.lastY, chain.lastZ);
        } else {
            chain.end.setFree(last.x + along * chain.lastX, last.y + along * chain.lastY, last.z + along * chain.lastZ);
        }
    }

    /** Traces a chain anew from its start through a point near its first vertex. */
    private boolean trace(SpecularChain chain, double px, double py, double pz) {
        ChainEnd start = chain.start;
        SurfacePoint o = start.point;
        double dx;
        double dy;
        double dz;
        chain.throughput.set(1);
        SurfacePoint first = chain.points[0];
        boolean found;
        if (start.parallel) {
            dx = -start.dx;
            dy = -start.dy;
            dz = -start.dz;
            double height = (o.x - px) * start.dx + (o.y - py) * start.dy + (o.z - pz) * start.dz;
            double ox = px + height * start.dx;
            double oy = py + height * start.dy;
            double oz = pz + height * start.dz;
            found = caster.trace(ox, oy, oz, dx, dy, dz, RayKind.SCATTERED, first);
        } else {
            dx = px - o.x;
            dy = py - o.y;
            dz = pz - o.z;
            double inverse = 1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
            dx *= inverse;
            dy *= inverse;
            dz *= inverse;
            found = caster.trace(o, dx, dy, dz, RayKind.SCATTERED, first);
        }
        for (int i = 0; found; i++) {
            SurfacePoint here = chain.points[i];
            if (!scatter(chain, i, -dx, -dy, -dz)
                    || here.geometricCosine(-dx, -dy, -dz) * here.geometricCosine(chain.lastX, chain.lastY, chain.lastZ)
                                    < 0
                            != chain.transmits[i]) {
                failure = WalkOutcome.KIND_CHANGED;
                return false;
            }
            if (i + 1 == chain.length()) {
                return true;
            }
            dx = chain.lastX;
            dy = chain.lastY;
            dz = chain.lastZ;
            found = caster.trace(here, dx, dy, dz, RayKind.SCATTERED, chain.points[i + 1]);
        }
        failure = WalkOutcome.MISSED;
        return false;
    }

    private static boolean isSame(SpecularChain a, SpecularChain b) {
        int n = a.length();
        double slack = a.start.point.offset;
        for (int i = 0; i < n; i++) {
            slack += a.points[i].offset;
        }
        for (int i = 0; i < n; i++) {
            SurfacePoint here = a.points[i];
            double before = distance(here, i > 0 ? a.points[i - 1] : a.start.point);
            double after = distance(here, i + 1 < n ? a.points[i + 1] : a.end.point);
            if (!(distance(here, b.points[i]) <= SAME * Math.min(before, after) + SLACK * slack)) {
                return false;
            }
        }
        return true;
    }

    private static double distance(SurfacePoint a, SurfacePoint b) {
        double x = a.x - b.x;
        double y = a.y - b.y;
        double z = a.z - b.z;
        return Math.sqrt(x * x + y * y + z * z);
    }
}
