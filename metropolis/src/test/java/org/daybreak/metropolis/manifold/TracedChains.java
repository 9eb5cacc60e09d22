package org.daybreak.metropolis.manifold;

import static org.daybreak.metropolis.manifold.SpecularScenes.REFLECT;
import static org.daybreak.metropolis.manifold.SpecularScenes.REFRACT;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.BsdfSample;
import org.daybreak.core.material.Scattering;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.RayKind;

/** Chains of delta lobes that rays were traced along. */
final class TracedChains {
    /** Chains that the balls of {@link SpecularScenes} have. */
    static final int[][] CHAINS = {
        {REFRACT, REFRACT},
        {REFLECT},
        {REFRACT, REFLECT, REFRACT},
        {REFRACT, REFLECT, REFLECT, REFRACT},
        {REFRACT, REFRACT, REFLECT},
        {REFLECT, REFLECT}
    };

    private final ManifoldTangents tangents = new ManifoldTangents();
    private final BsdfSample scattered = new BsdfSample();

    /** Traces a chain from its start along a direction, and sets its end where the last ray is at a distance. */
    boolean trace(RayCaster caster, SpecularChain c, double dx, double dy, double dz, double distance, int... lobes) {
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        double x = dx / length;
        double y = dy / length;
        double z = dz / length;
        c.setLength(lobes.length);
        SurfacePoint from = c.start.point;
        for (int i = 0; i < lobes.length; i++) {
            SurfacePoint here = c.points[i];
            c.lobes[i] = lobes[i];
            if (!caster.trace(from, x, y, z, RayKind.SCATTERED, here)
                    || !Scattering.deltaLobe(
                            caster.scene().bsdf(here.shape), here, -x, -y, -z, lobes[i], c.mode, scattered)) {
                return false;
            }
            x = scattered.wiX;
            y = scattered.wiY;
            z = scattered.wiZ;
            from = here;
        }
        c.end.setFree(from.x + distance * x, from.y + distance * y, from.z + distance * z);
        return true;
    }

    /** Sets a chain to a random one, its end on a random plane; false if the rays went another way. */
    boolean random(RayCaster caster, SpecularChain chain, RandomStream random, int... lobes) {
        chain.mode = random.nextDouble() < 0.5 ? TransportMode.RADIANCE : TransportMode.IMPORTANCE;
        chain.start.setFree(random.nextDouble() - 0.5, random.nextDouble() - 0.5, 3 + random.nextDouble());
        double x = 4 * random.nextDouble() - 2;
        double y = 4 * random.nextDouble() - 2;
        if (!trace(caster, chain, x, y, -3, 1 + random.nextDouble(), lobes)) {
            return false;
        }
        endOnPlane(chain, random.nextDouble() - 0.5, random.nextDouble() - 0.5, 1);
        return true;
    }

    /** By the tangents: solid angle at the start per area at the end; of parallel rays area and solid angle. */
    double startPerEnd(RayCaster caster, SpecularChain c) {
        assertTrue(new SpecularManifold(caster).follow(c));
        assertTrue(tangents.set(caster.scene(), c));
        return tangents.startPerEnd();
    }

    /** Makes a plane through the end of a chain the surface that it lies on. */
    static void endOnPlane(SpecularChain c, double nx, double ny, double nz) {
        SurfacePoint p = new SurfacePoint();
        p.set(c.end.point);
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        p.gx = nx / length;
        p.gy = ny / length;
        p.gz = nz / length;
        c.end.setSurface(p);
    }

    /** Sets a chain to another one as seen from its other end. */
    static void reverse(SpecularChain c, SpecularChain into) {
        int n = c.length();
        into.setLength(n);
        into.start.set(c.end);
        into.end.set(c.start);
        into.mode = c.mode == TransportMode.RADIANCE ? TransportMode.IMPORTANCE : TransportMode.RADIANCE;
        for (int i = 0; i < n; i++) {
            into.points[i].set(c.points[n - 1 - i]);
            into.lobes[i] = c.lobes[n - 1 - i];
        }
    }

    /** A vector divided by its length. */
    static double[] unit(double x, double y, double z) {
        double length = Math.sqrt(x * x + y * y + z * z);
        return new double[] {x / length, y / length, z / length};
    }

    /** What lobes a chain has, for messages. */
    static String name(int... lobes) {
        return Arrays.toString(lobes);
    }
}
