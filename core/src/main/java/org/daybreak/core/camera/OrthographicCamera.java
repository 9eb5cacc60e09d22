package org.daybreak.core.camera;

import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.math.Transform;

/**
 * A camera of parallel rays (Mitsuba's {@code orthographic}). In camera coordinates it looks along +z from the plane z = 0,
 * +y is up, and +x points to the left of the image. The film shows −1 to 1 across its width; the transform scales it.
 *
 * <p>Rays are single in direction and have a density of their origins on that plane. What lies behind it is not seen.
 */
public final class OrthographicCamera implements Camera {
    /** Sine of the angle up to which rounding can turn a ray of this camera. */
    private static final double ROUNDING = 1e-7;

    private final int width;
    private final int height;
    private final double halfHeight;
    private final Transform toWorld;
    private final double dx;
    private final double dy;
    private final double dz;
    /** Length of the image of a unit of depth. */
    private final double depthScale;
    /** Unit normal of the plane of origins on the side of the scene. */
    private final double viewX;

    private final double viewY;
    private final double viewZ;
    /** Density per area on the plane of origins of a film point drawn uniformly. */
    private final double originDensity;

    /**
     * Creates a camera.
     *
     * @param cameraToWorld affine map; mirroring is allowed
     * @param width film width in pixels
     * @param height film height in pixels
     * @param pixelAspect width of a pixel over its height, positive
     * @throws IllegalArgumentException if a number is out of range
     */
    public OrthographicCamera(Transform cameraToWorld, int width, int height, double pixelAspect) {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("the film must not be empty but is " + width + "x" + height);
        }
        if (!(pixelAspect > 0 && pixelAspect < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("the aspect of pixels must be positive but is " + pixelAspect);
        }
        this.width = width;
        this.height = height;
        halfHeight = height / (width * pixelAspect);
        toWorld = cameraToWorld;
        double[] a = new double[3];
        double[] b = new double[3];
        double[] c = new double[3];
        toWorld.applyVector(1, 0, 0, a);
        toWorld.applyVector(0, 1, 0, b);
        toWorld.applyVector(0, 0, 1, c);
        depthScale = Math.sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]);
        dx = c[0] / depthScale;
        dy = c[1] / depthScale;
        dz = c[2] / depthScale;
        double nx = a[1] * b[2] - a[2] * b[1];
        double ny = a[2] * b[0] - a[0] * b[2];
        double nz = a[0] * b[1] - a[1] * b[0];
        double stretch = Math.sqrt(nx * nx + ny * ny + nz * nz);
        double side = nx * dx + ny * dy + nz * dz < 0 ? -1 : 1;
        viewX = side * nx / stretch;
        viewY = side * ny / stretch;
        viewZ = side * nz / stretch;
        originDensity = 1 / (4 * halfHeight * stretch);
    }

    @Override
    public int width() {
        return width;
    }

    @Override
    public int height() {
        return height;
    }

    @Override
    public boolean sampleRay(double filmX, double filmY, double u, double v, CameraRay out) {
        double[] o = out.scratch;
        toWorld.applyPoint(1 - 2 * filmX / width, halfHeight * (1 - 2 * filmY / height), 0, o);
        out.ox = o[0];
        out.oy = o[1];
        out.oz = o[2];
        out.dx = dx;
        out.dy = dy;
        out.dz = dz;
        out.normalX = viewX;
        out.normalY = viewY;
        out.normalZ = viewZ;
        setDensities(out);
        return true;
    }

    @Override
    public boolean sampleLens(double px, double py, double pz, double u, double v, LensSample out) {
        double[] local = out.scratch;
        toWorld.applyInversePoint(px, py, pz, local);
        double depth = local[2];
        double filmX = filmX(local[0]);
        double filmY = filmY(local[1]);
        if (!(depth > 0) || !onFilm(filmX, filmY)) {
            return false;
        }
        out.wiX = -dx;
        out.wiY = -dy;
        out.wiZ = -dz;
        out.distance = depth * depthScale;
        out.filmX = filmX;
        out.filmY = filmY;
        // Pixels per area across the rays: there is no distance in it.
        out.weight = (double) width * height * originDensity / (dx * viewX + dy * viewY + dz * viewZ);
        out.delta = true;
        out.density = 1;
        out.densityPosition = 1;
        SurfacePoint point = out.point;
        point.x = px - out.distance * dx;
        point.y = py - out.distance * dy;
        point.z = pz - out.distance * dz;
        point.gx = viewX;
        point.gy = viewY;
        point.gz = viewZ;
        point.offset = 0;
        point.shape = -1;
        point.primitive = -1;
        point.instance = -1;
        return true;
    }

    @Override
    public boolean rayDensity(double ox, double oy, double oz, double rayX, double rayY, double rayZ, CameraRay out) {
        double cosine = rayX * dx + rayY * dy + rayZ * dz;
        double x = rayX - cosine * dx;
        double y = rayY - cosine * dy;
        double z = rayZ - cosine * dz;
        if (!(cosine > 0) || x * x + y * y + z * z > ROUNDING * ROUNDING) {
            return false;
        }
        double[] local = out.scratch;
        toWorld.applyInversePoint(ox, oy, oz, local);
        if (!onFilm(filmX(local[0]), filmY(local[1]))) {
            return false;
        }
        setDensities(out);
        return true;
    }

    /** False: a ray hits the plane of origins in the one direction that counts with probability 0. */
    @Override
    public boolean hasLensArea() {
        return false;
    }

    @Override
    public boolean isParallel() {
        return true;
    }

    private void setDensities(CameraRay out) {
        out.weight = 1;
        out.densityPosition = originDensity;
        out.densityDirection = 1;
    }

    private double filmX(double x) {
        return 0.5 * width * (1 - x);
    }

    private double filmY(double y) {
        return 0.5 * height * (1 - y / halfHeight);
    }

    private boolean onFilm(double filmX, double filmY) {
        return filmX >= 0 && filmX < width && filmY >= 0 && filmY < height;
    }
}
