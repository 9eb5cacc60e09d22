package org.daybreak.core.camera;

import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.math.Transform;

/**
 * A camera that sees all directions from a point, as an equirectangular panorama (Mitsuba 0.6's {@code spherical}). Film
 * position (x, y) of a film of W×H pixels looks along (sin φ·sin θ, cos θ, −cos φ·sin θ) in camera coordinates, with
 * φ = 2πx/W and θ = πy/H: the mapping of environment images.
 */
public final class EnvironmentCamera implements Camera {
    /** Least sine of the polar angle in densities, which are singular at the poles. */
    private static final double LEAST_SINE = 1e-12;

    private final int width;
    private final int height;
    private final double originX;
    private final double originY;
    private final double originZ;
    /** Rotation (or reflection) to the world, row by row. */
    private final double[] m;

    /**
     * Creates a camera.
     *
     * @param cameraToWorld map without scale and shear; mirroring is allowed
     * @param width film width in pixels
     * @param height film height in pixels
     * @throws IllegalArgumentException if the film is empty or the transform scales or shears
     */
    public EnvironmentCamera(Transform cameraToWorld, int width, int height) {
        if (width < 1 || height < 1) {
            throw new IllegalArgumentException("the film must not be empty but is " + width + "x" + height);
        }
        double[] r = cameraToWorld.rows();
        m = new double[] {r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10]};
        for (int i = 0; i < 3; i++) {
            for (int j = i; j < 3; j++) {
                double dot = m[i] * m[j] + m[3 + i] * m[3 + j] + m[6 + i] * m[6 + j];
                if (!(Math.abs(dot - (i == j ? 1 : 0)) < 1e-4)) {
                    throw new IllegalArgumentException(
                            "the transform of an environment camera must not scale or shear");
                }
            }
        }
        this.width = width;
        this.height = height;
        originX = r[3];
        originY = r[7];
        originZ = r[11];
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
        double phi = 2 * Math.PI * filmX / width;
        double theta = Math.PI * filmY / height;
        double sine = Math.sin(theta);
        double x = Math.sin(phi) * sine;
        double y = Math.cos(theta);
        double z = -Math.cos(phi) * sine;
        double wx = m[0] * x + m[1] * y + m[2] * z;
        double wy = m[3] * x + m[4] * y + m[5] * z;
        double wz = m[6] * x + m[7] * y + m[8] * z;
        double length = Math.sqrt(wx * wx + wy * wy + wz * wz);
        out.ox = originX;
        out.oy = originY;
        out.oz = originZ;
        out.dx = wx / length;
        out.dy = wy / length;
        out.dz = wz / length;
        out.normalX = out.dx;
        out.normalY = out.dy;
        out.normalZ = out.dz;
        out.weight = 1;
        out.densityPosition = 1;
        out.densityDirection = density(Math.abs(sine));
        return true;
    }

    @Override
    public boolean sampleLens(double px, double py, double pz, double u, double v, LensSample out) {
        double dx = px - originX;
        double dy = py - originY;
        double dz = pz - originZ;
        double squared = dx * dx + dy * dy + dz * dz;
        if (!(squared > 0)) {
            return false;
        }
        double distance = Math.sqrt(squared);
        double x = m[0] * dx + m[3] * dy + m[6] * dz;
        double y = m[1] * dx + m[4] * dy + m[7] * dz;
        double z = m[2] * dx + m[5] * dy + m[8] * dz;
        double across = Math.sqrt(x * x + z * z);
        double phi = Math.atan2(x, -z);
        out.filmX = width * (phi < 0 ? phi + 2 * Math.PI : phi) / (2 * Math.PI);
        out.filmY = height * Math.atan2(across, y) / Math.PI;
        out.wiX = -dx / distance;
        out.wiY = -dy / distance;
        out.wiZ = -dz / distance;
        out.distance = distance;
        out.weight = (double) width * height * density(across / distance) / squared;
        out.delta = true;
        out.density = 1;
        out.densityPosition = 1;
        SurfacePoint point = out.point;
        point.x = originX;
        point.y = originY;
        point.z = originZ;
        point.gx = -out.wiX;
        point.gy = -out.wiY;
        point.gz = -out.wiZ;
        point.offset = 0;
        point.shape = -1;
        point.primitive = -1;
        point.instance = -1;
        return true;
    }

    @Override
    public boolean rayDensity(double ox, double oy, double oz, double dx, double dy, double dz, CameraRay out) {
        double x = m[0] * dx + m[3] * dy + m[6] * dz;
        double z = m[2] * dx + m[5] * dy + m[8] * dz;
        out.weight = 1;
        out.densityPosition = 1;
        out.densityDirection = density(Math.sqrt(x * x + z * z));
        return true;
    }

    @Override
    public boolean hasLensArea() {
        return false;
    }

    /** Density per solid angle at a sine of the polar angle. */
    private static double density(double sine) {
        return 1 / (2 * Math.PI * Math.PI * Math.max(sine, LEAST_SINE));
    }
}
