package org.daybreak.benchmarks.intersection;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.daybreak.core.accel.HitRefinement;
import org.daybreak.core.accel.Intersector;
import org.daybreak.core.accel.PrimitiveSet;
import org.daybreak.core.accel.Ray;

/** Rays as eight floats each: origin, unused, direction, tMax; what a diffuse path tracer would ask, in its order. */
final class RaySet {
    static final int STRIDE = 8;
    private static final int BOUNCES = 4;

    final String kind;
    final boolean anyHit;
    final float[] data;
    final int count;

    private RaySet(String kind, boolean anyHit, float[] data, int end) {
        this.kind = kind;
        this.anyHit = anyHit;
        this.data = Arrays.copyOf(data, end);
        this.count = end / STRIDE;
    }

    /**
     * Rays from the camera in scan-line order, those of diffuse bounces in path order, and those from the bounces to a
     * random point of the light.
     *
     * @param count number of rays of each kind
     */
    static RaySet[] trace(PrimitiveSet set, Intersector intersector, int count) {
        SplittableRandom random = new SplittableRandom(7);
        float[] primary = new float[STRIDE * count];
        float[] diffuse = new float[STRIDE * count];
        float[] shadow = new float[STRIDE * count];
        int width = (int) Math.sqrt(count);
        int height = count / width;
        int primaryEnd = 0;
        Ray ray = new Ray();
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                cameraRay(ray, (x + random.nextDouble()) / width, (y + random.nextDouble()) / height);
                primaryEnd = store(primary, primaryEnd, ray);
            }
        }
        int diffuseEnd = 0;
        int shadowEnd = 0;
        HitRefinement point = new HitRefinement();
        double[] direction = new double[3];
        for (int pixel = 0; diffuseEnd < diffuse.length || shadowEnd < shadow.length; pixel++) {
            int x = pixel * 4 % width;
            int y = pixel * 4 / width * 4 % height;
            cameraRay(ray, (x + random.nextDouble()) / width, (y + random.nextDouble()) / height);
            for (int bounce = 0; bounce < BOUNCES && intersector.intersect(ray); bounce++) {
                point.refine(set, ray, set);
                double away = ray.dx * point.normalX + ray.dy * point.normalY + ray.dz * point.normalZ < 0 ? 1 : -1;
                double nx = away * point.normalX;
                double ny = away * point.normalY;
                double nz = away * point.normalZ;
                ray.ox = point.x + 4 * point.offset * nx;
                ray.oy = point.y + 4 * point.offset * ny;
                ray.oz = point.z + 4 * point.offset * nz;
                double half = BenchmarkScene.LIGHT_HALF_WIDTH;
                ray.dx = random.nextDouble(-half, half) - ray.ox;
                ray.dy = BenchmarkScene.LIGHT_Y - ray.oy;
                ray.dz = random.nextDouble(-half, half) - ray.oz;
                ray.tMax = 1;
                if (ray.dx * nx + ray.dy * ny + ray.dz * nz > 0 && shadowEnd < shadow.length) {
                    shadowEnd = store(shadow, shadowEnd, ray);
                }
                cosineDirection(random, direction);
                double x2 = nx + direction[0];
                double y2 = ny + direction[1];
                double z2 = nz + direction[2];
                double length = Math.sqrt(x2 * x2 + y2 * y2 + z2 * z2);
                ray.set(ray.ox, ray.oy, ray.oz, x2 / length, y2 / length, z2 / length, Double.POSITIVE_INFINITY);
                if (diffuseEnd < diffuse.length) {
                    diffuseEnd = store(diffuse, diffuseEnd, ray);
                }
            }
        }
        return new RaySet[] {
            new RaySet("primary", false, primary, primaryEnd),
            new RaySet("diffuse", false, diffuse, diffuseEnd),
            new RaySet("shadow", true, shadow, shadowEnd)
        };
    }

    private static void cameraRay(Ray ray, double u, double v) {
        double dx = u - 0.5;
        double dy = 0.5 - v;
        double dz = -0.6;
        double length = Math.sqrt(dx * dx + dy * dy + dz * dz);
        ray.set(
                BenchmarkScene.CAMERA[0],
                BenchmarkScene.CAMERA[1],
                BenchmarkScene.CAMERA[2],
                dx / length,
                dy / length,
                dz / length,
                Double.POSITIVE_INFINITY);
    }

    /** A point on the unit sphere; added to a unit normal it gives the cosine distribution. */
    private static void cosineDirection(SplittableRandom random, double[] direction) {
        double z = random.nextDouble(-0.9999, 0.9999);
        double phi = random.nextDouble(2 * Math.PI);
        double r = Math.sqrt(1 - z * z);
        direction[0] = r * Math.cos(phi);
        direction[1] = r * Math.sin(phi);
        direction[2] = z;
    }

    private static int store(float[] data, int end, Ray ray) {
        data[end] = (float) ray.ox;
        data[end + 1] = (float) ray.oy;
        data[end + 2] = (float) ray.oz;
        data[end + 4] = (float) ray.dx;
        data[end + 5] = (float) ray.dy;
        data[end + 6] = (float) ray.dz;
        data[end + 7] = (float) ray.tMax;
        return end + STRIDE;
    }

    /** Loads one ray. */
    void load(int index, Ray ray) {
        int at = STRIDE * index;
        ray.set(data[at], data[at + 1], data[at + 2], data[at + 4], data[at + 5], data[at + 6], data[at + 7]);
    }
}
