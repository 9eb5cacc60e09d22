package org.daybreak.tracing;

import java.util.List;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.BoundingSphere;
import org.daybreak.core.geometry.EmissionBounds;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.light.EmissionDensity;
import org.daybreak.core.light.EmissionSample;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightSample;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Frame;
import org.daybreak.core.sampling.SobolSampler;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.sampling.Warps;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;

/**
 * Starts light subpaths, a share of them aimed at mirrors and glass: what these throw on other surfaces (caustics) is found
 * well by light subpaths alone, and few of those that leave a light anyhow meet a small object. The idea is that of the projection
 * maps of photon mapping (Jensen 2001, §5.3), with spheres for projections and a mixture density in place of tables.
 *
 * <p>Which spheres a light aims at is found out by a few test rays: not those that hardly any ray meets, as they are small in their
 * sphere or behind others, and none at all if the light's ordinary rays meet mirrors and glass often enough.
 *
 * <p>With spheres of solid angles Ωᵢ seen from the point on the light, the density of the direction is
 * (1−a)·p + a·n(ω)/ΣΩᵢ, where p is the light's own, n(ω) counts the spheres that ω meets and a is the share. Lights at infinity
 * aim with the position instead: there Ωᵢ is the area of the disk that the sphere covers.
 *
 * <p>One object per worker; all have the same tables. Without mirrors and glass it adds nothing, and costs nothing.
 */
public final class EmissionGuide {
    /** Share of the subpaths that are aimed. */
    private static final double SHARE = 0.5;

    private static final int TEST_RAYS = 128;
    /** Part of the rays aimed at a sphere that must meet mirror or glass for it to be aimed at. */
    private static final double LEAST_HITS = 0.05;
    /** Part of the ordinary rays that meet mirror or glass with which a light need not aim. */
    private static final double ENOUGH_HITS = 0.1;
    /** With more lights than this each has too small a part in the picture. */
    private static final int MOST_LIGHTS = 64;

    private final Scene scene;
    private final int count;
    /** Whether light l aims at sphere i, at l·count + i; and whether at any. */
    private final boolean[] targets;

    private final boolean[] aims;
    /** Positions of lights that are points. */
    private final double[] origins;

    private final double[] x;
    private final double[] y;
    private final double[] z;
    private final double[] radius;
    /** What each sphere covers, as seen from the point in hand: 1 − cos of its half-angle, or its squared radius. */
    private final double[] cover;

    private double totalCover;
    private double rest;
    private final double sceneX;
    private final double sceneY;
    private final double sceneZ;
    private final double sceneRadius;
    private final double[] local = new double[3];
    private final Frame frame = new Frame();
    private final EmissionDensity own = new EmissionDensity();
    private final LightSample probe = new LightSample();
    private final Spectrum emitted = new Spectrum();

    /** Creates a guide for a scene. */
    public EmissionGuide(Scene scene) {
        this.scene = scene;
        List<BoundingSphere> spheres = scene.deltaSpheres();
        count = spheres.size();
        x = new double[count];
        y = new double[count];
        z = new double[count];
        radius = new double[count];
        cover = new double[count];
        for (int i = 0; i < count; i++) {
            BoundingSphere sphere = spheres.get(i);
            x[i] = sphere.x();
            y[i] = sphere.y();
            z[i] = sphere.z();
            radius[i] = sphere.radius();
        }
        Bounds bounds = scene.bounds();
        sceneX = bounds.isEmpty() ? 0 : bounds.centerX();
        sceneY = bounds.isEmpty() ? 0 : bounds.centerY();
        sceneZ = bounds.isEmpty() ? 0 : bounds.centerZ();
        sceneRadius = bounds.boundingSphereRadius();
        int lights = scene.lightCount();
        targets = new boolean[lights * count];
        aims = new boolean[lights];
        origins = new double[3 * lights];
        if (count > 0 && lights <= MOST_LIGHTS) {
            RayCaster caster = new RayCaster(scene);
            for (int l = 0; l < lights; l++) {
                if (!scene.light(l).isInfinite() || sceneRadius > 0) {
                    chooseTargets(l, caster);
                }
            }
        }
    }

    private void chooseTargets(int index, RayCaster caster) {
        EmissionBounds emission = scene.light(index).bounds();
        if (emission != null) {
            origins[3 * index] = emission.box().minX();
            origins[3 * index + 1] = emission.box().minY();
            origins[3 * index + 2] = emission.box().minZ();
        }
        EmissionSample sample = new EmissionSample();
        SurfacePoint hit = new SurfacePoint();
        if (hits(index, false, caster, sample, hit) >= ENOUGH_HITS) {
            return;
        }
        aims[index] = true;
        boolean any = false;
        boolean[] chosen = new boolean[count];
        for (int i = 0; i < count; i++) {
            targets[index * count + i] = true;
            chosen[i] = hits(index, true, caster, sample, hit) >= LEAST_HITS;
            targets[index * count + i] = false;
            any |= chosen[i];
        }
        System.arraycopy(chosen, 0, targets, index * count, count);
        aims[index] = any;
    }

    /** Part of the test rays that meet mirror or glass: aimed rays, or ordinary ones. */
    private double hits(int index, boolean aimed, RayCaster caster, EmissionSample sample, SurfacePoint hit) {
        SobolSampler numbers = new SobolSampler(index, StreamDomain.SELF_CHECK, 4);
        int hits = 0;
        for (int ray = 0; ray < TEST_RAYS; ray++) {
            numbers.start(0, ray);
            double u = numbers.next();
            double v = numbers.next();
            double s = numbers.next();
            double t = numbers.next();
            if (aimed && scene.light(index).isInfinite()) {
                u *= SHARE;
            } else if (aimed) {
                s *= SHARE;
            }
            boolean sampled = aimed
                    ? sample(index, u, v, s, t, sample)
                    : scene.light(index).sampleEmission(u, v, s, t, sample);
            if (sampled
                    && caster.trace(sample.point, sample.dx, sample.dy, sample.dz, RayKind.LIGHT, hit)
                    && !scene.bsdf(hit.shape).connectable()) {
                hits++;
            }
        }
        return (double) hits / TEST_RAYS;
    }

    /**
     * Samples a ray that leaves a light, as {@link Light#sampleEmission} does, but by the mixture of densities.
     *
     * @param index the light
     * @param u first number for the position, with {@code v}
     * @param s first number for the direction, with {@code t}
     */
    public boolean sample(int index, double u, double v, double s, double t, EmissionSample out) {
        Light light = scene.light(index);
        if (!aims[index]) {
            return light.sampleEmission(u, v, s, t, out);
        }
        return light.isInfinite()
                ? sampleInfinite(index, light, u, v, s, t, out)
                : sampleFinite(index, light, u, v, s, t, out);
    }

    private boolean sampleFinite(int index, Light light, double u, double v, double s, double t, EmissionSample out) {
        boolean aimed = s < SHARE;
        double left = aimed ? s / SHARE : (s - SHARE) / (1 - SHARE);
        if (!aimed || !light.isDelta()) {
            if (!light.sampleEmission(u, v, left, t, out)) {
                return false;
            }
        } else {
            startAtPoint(index, out);
        }
        SurfacePoint origin = out.point;
        look(index, origin);
        if (totalCover == 0) {
            // Nothing to aim at from here: all goes by the light's own density.
            return light.sampleEmission(u, v, s, t, out);
        }
        if (!aimed) {
            double mixed = mixed(out.densityDirection, out.dx, out.dy, out.dz, origin);
            out.weight.scale(out.densityDirection / mixed);
            out.densityDirection = mixed;
            return true;
        }
        double perPosition = out.densityPosition;
        aim(origin, left, t);
        double dx = local[0];
        double dy = local[1];
        double dz = local[2];
        if (!emitted(light, origin, dx, dy, dz)) {
            return false;
        }
        light.emissionDensity(origin, dx, dy, dz, own);
        double mixed = mixed(own.direction, dx, dy, dz, origin);
        out.dx = dx;
        out.dy = dy;
        out.dz = dz;
        out.weight.set(emitted);
        out.weight.scale(1 / (perPosition * mixed));
        out.densityDirection = mixed;
        return true;
    }

    /** Seats the origin of a light at a single point; what else a light sets there is set anew for the direction. */
    private void startAtPoint(int index, EmissionSample out) {
        SurfacePoint point = out.point;
        point.x = origins[3 * index];
        point.y = origins[3 * index + 1];
        point.z = origins[3 * index + 2];
        point.offset = 0;
        point.shape = -1;
        point.primitive = -1;
        point.instance = -1;
        out.densityPosition = 1;
        out.deltaPosition = true;
        out.deltaDirection = false;
    }

    /** Sets the radiance times the cosine, or the intensity of a point, in a direction; false if there is none. */
    private boolean emitted(Light light, SurfacePoint origin, double dx, double dy, double dz) {
        if (light.isDelta()) {
            origin.gx = dx;
            origin.gy = dy;
            origin.gz = dz;
            // At unit distance irradiance is intensity.
            if (!light.sampleIncident(origin.x + dx, origin.y + dy, origin.z + dz, 0.5, 0.5, probe)) {
                return false;
            }
            emitted.set(probe.weight);
            emitted.scale(probe.distance * probe.distance);
        } else {
            light.radiance(origin, dx, dy, dz, emitted);
            emitted.scale(Math.abs(origin.geometricCosine(dx, dy, dz)));
        }
        return !emitted.isBlack();
    }

    private boolean sampleInfinite(int index, Light light, double u, double v, double s, double t, EmissionSample out) {
        boolean aimed = u < SHARE;
        double left = aimed ? u / SHARE : (u - SHARE) / (1 - SHARE);
        if (!light.sampleEmission(left, v, s, t, out)) {
            return false;
        }
        lookFromInfinity(index);
        if (aimed) {
            int i = choose(left);
            Warps.toConcentricDisk(rest, v, local);
            frame.set(out.dx, out.dy, out.dz);
            double px = x[i] + radius[i] * (local[0] * frame.sx + local[1] * frame.tx);
            double py = y[i] + radius[i] * (local[0] * frame.sy + local[1] * frame.ty);
            double pz = z[i] + radius[i] * (local[0] * frame.sz + local[1] * frame.tz);
            // All rays of the light start on one plane before the scene.
            double along = (px - sceneX) * out.dx + (py - sceneY) * out.dy + (pz - sceneZ) * out.dz + sceneRadius;
            out.point.x = px - along * out.dx;
            out.point.y = py - along * out.dy;
            out.point.z = pz - along * out.dz;
        }
        double ordinary = out.densityPosition;
        double mixed = mixedPosition(ordinary, out.point, out.dx, out.dy, out.dz);
        out.weight.scale(ordinary / mixed);
        out.densityPosition = mixed;
        return true;
    }

    /**
     * Densities with which {@link #sample} draws a ray of a light.
     *
     * @param index the light
     * @param onLight origin on the light; for lights at infinity it plays no part
     * @param onRay any point on the ray; for other lights it plays no part
     * @param dx unit direction of travel
     */
    public void density(
            int index, SurfacePoint onLight, SurfacePoint onRay, double dx, double dy, double dz, EmissionDensity out) {
        Light light = scene.light(index);
        light.emissionDensity(onLight, dx, dy, dz, out);
        if (!aims[index]) {
            return;
        }
        if (light.isInfinite()) {
            lookFromInfinity(index);
            out.position = mixedPosition(out.position, onRay, dx, dy, dz);
        } else {
            look(index, onLight);
            if (totalCover > 0) {
                out.direction = mixed(out.direction, dx, dy, dz, onLight);
            }
        }
    }

    /** Sees what the spheres cover from a point that is in none of them. */
    private void look(int index, SurfacePoint origin) {
        totalCover = 0;
        for (int i = 0; i < count; i++) {
            double dx = x[i] - origin.x;
            double dy = y[i] - origin.y;
            double dz = z[i] - origin.z;
            double sine = radius[i] * radius[i] / (dx * dx + dy * dy + dz * dz);
            cover[i] = targets[index * count + i] && sine < 1 ? sine / (1 + Math.sqrt(1 - sine)) : 0;
            totalCover += cover[i];
        }
    }

    private void lookFromInfinity(int index) {
        totalCover = 0;
        for (int i = 0; i < count; i++) {
            cover[i] = targets[index * count + i] ? radius[i] * radius[i] : 0;
            totalCover += cover[i];
        }
    }

    /** Chooses a sphere in proportion to what it covers, and leaves in {@link #rest} what is then a uniform number again. */
    private int choose(double u) {
        double left = u * totalCover;
        int last = 0;
        for (int i = 0; i < count; i++) {
            if (cover[i] > 0) {
                last = i;
                if (left < cover[i]) {
                    break;
                }
                left -= cover[i];
            }
        }
        rest = Math.min(left / cover[last], Math.nextDown(1.0));
        return last;
    }

    /** Chooses a direction to a sphere, uniform in the solid angle that it covers. */
    private void aim(SurfacePoint origin, double s, double t) {
        int i = choose(s);
        Warps.toUniformCone(rest, t, cover[i], local);
        double dx = x[i] - origin.x;
        double dy = y[i] - origin.y;
        double dz = z[i] - origin.z;
        double inverse = 1 / Math.sqrt(dx * dx + dy * dy + dz * dz);
        frame.set(dx * inverse, dy * inverse, dz * inverse);
        frame.toWorld(local[0], local[1], local[2], local);
    }

    /** The mixture for a direction from a point that was {@link #look looked} from. */
    private double mixed(double ordinary, double dx, double dy, double dz, SurfacePoint origin) {
        int met = 0;
        for (int i = 0; i < count; i++) {
            if (cover[i] > 0) {
                double cx = x[i] - origin.x;
                double cy = y[i] - origin.y;
                double cz = z[i] - origin.z;
                double along = cx * dx + cy * dy + cz * dz;
                double squared = cx * cx + cy * cy + cz * cz;
                // Inside the cone: the ray passes the centre closer than the radius.
                if (along > 0 && squared - along * along <= radius[i] * radius[i]) {
                    met++;
                }
            }
        }
        return (1 - SHARE) * ordinary + SHARE * met / (2 * Math.PI * totalCover);
    }

    private double mixedPosition(double ordinary, SurfacePoint onRay, double dx, double dy, double dz) {
        int met = 0;
        for (int i = 0; i < count; i++) {
            double cx = x[i] - onRay.x;
            double cy = y[i] - onRay.y;
            double cz = z[i] - onRay.z;
            double along = cx * dx + cy * dy + cz * dz;
            if (cover[i] > 0 && cx * cx + cy * cy + cz * cz - along * along <= cover[i]) {
                met++;
            }
        }
        return (1 - SHARE) * ordinary + SHARE * met / (Math.PI * totalCover);
    }
}
