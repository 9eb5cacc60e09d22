package org.daybreak.core.camera;

import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.Warps;

/**
 * A perspective camera with a pinhole or a thin lens. In camera coordinates it looks along +z, +y is up, and +x points to the
 * left of the image.
 *
 * <p>A film position is a point (x, y, 1) of the plane at distance 1. With P pixels per unit of area of that plane and
 * the camera-to-world matrix M, a unit direction of the world that comes from (x, y, 1) is seen by
 * P·|M(x, y, 1)|³/|det M| pixels per steradian; without shear and scale, that is P/cos³θ. The map of plane points
 * to film positions is the same for every point of a thin lens.
 *
 * <p>A uniform scale in the transform is without effect: aperture radius and focus distance are in world units. Unequal scales
 * and shear distort the view and the lens alike.
 */
public final class PerspectiveCamera implements Camera {
    /** Squared radius, relative to the lens, up to which rounding can put a point of its rim. */
    private static final double RIM = 1 + 1e-6;

    private final int width;
    private final int height;
    /** Film position of the axis. */
    private final double middleX;

    private final double middleY;
    private final double pixelsPerX;
    private final double pixelsPerY;
    private final double pixelsPerArea;
    private final double apertureRadius;
    private final double focusDistance;

    private final double originX;
    private final double originY;
    private final double originZ;
    /** Camera-to-world matrix of determinant ±1, row by row. */
    private final double[] toWorld;
    /** Its inverse. */
    private final double[] toCamera;
    /** Unit normal of the lens plane on the side of the scene. */
    private final double viewX;

    private final double viewY;
    private final double viewZ;
    private final double lensDensity;

    /**
     * Creates a camera.
     *
     * @param cameraToWorld affine map; mirroring is allowed
     * @param tanHalfWidth tangent of half the opening angle across the image width, positive;
     *     {@link #tanHalfWidth(double, double, int)} computes it
     * @param width film width in pixels
     * @param height film height in pixels
     * @param apertureRadius radius of the lens in world units; 0 for a pinhole
     * @param focusDistance distance of the plane of focus along the viewing direction in world units; not used by a
     *     pinhole
     * @throws IllegalArgumentException if a number is out of range
     */
    public PerspectiveCamera(
            Transform cameraToWorld,
            double tanHalfWidth,
            int width,
            int height,
            double apertureRadius,
            double focusDistance) {
        this(
                cameraToWorld,
                tanHalfWidth,
                tanHalfWidth * height / width,
                width,
                height,
                apertureRadius,
                focusDistance,
                0,
                0);
    }

    /**
     * Creates a camera whose pixels need not be square and whose axis need not meet the middle of the film.
     *
     * @param cameraToWorld affine map; mirroring is allowed
     * @param tanHalfWidth tangent of half the opening angle across the image width, positive
     * @param tanHalfHeight the same across the height
     * @param width film width in pixels
     * @param height film height in pixels
     * @param apertureRadius radius of the lens in world units; 0 for a pinhole
     * @param focusDistance distance of the plane of focus along the viewing direction in world units; not used by a pinhole
     * @param shiftX how far to the right the film is shifted, in film widths: what was seen at film position
     *     {@code x + shiftX·width} is seen at x
     * @param shiftY how far down the film is shifted, in film heights
     * @throws IllegalArgumentException if a number is out of range
     */
    public PerspectiveCamera(
            Transform cameraToWorld,
            double tanHalfWidth,
            double tanHalfHeight,
            int width,
            int height,
            double apertureRadius,
            double focusDistance,
            double shiftX,
            double shiftY) {
        requirePositive("the tangent of half the opening angle", tanHalfWidth);
        if (!Double.isFinite(shiftX) || !Double.isFinite(shiftY)) {
            throw new IllegalArgumentException("the shift of the film must be finite but is " + shiftX + ", " + shiftY);
        }
        requirePositive("the film width", width);
        requirePositive("the film height", height);
        requirePositive("the tangent of half the opening angle across the height", tanHalfHeight);
        if (!(apertureRadius >= 0 && apertureRadius < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("the aperture radius must not be negative but is " + apertureRadius);
        }
        if (apertureRadius > 0) {
            requirePositive("the focus distance", focusDistance);
        }
        this.width = width;
        this.height = height;
        this.apertureRadius = apertureRadius;
        this.focusDistance = apertureRadius > 0 ? focusDistance : 1;
        middleX = (0.5 - shiftX) * width;
        middleY = (0.5 - shiftY) * height;
        pixelsPerX = width / (2 * tanHalfWidth);
        pixelsPerY = height / (2 * tanHalfHeight);
        pixelsPerArea = pixelsPerX * pixelsPerY;
        double[] m = cameraToWorld.rows();
        double[] r = cameraToWorld.inverse().rows();
        originX = m[3];
        originY = m[7];
        originZ = m[11];
        double unit = Math.cbrt(Math.abs(m[0] * (m[5] * m[10] - m[6] * m[9])
                - m[1] * (m[4] * m[10] - m[6] * m[8])
                + m[2] * (m[4] * m[9] - m[5] * m[8])));
        toWorld = new double[] {m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10]};
        toCamera = new double[] {r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10]};
        for (int i = 0; i < 9; i++) {
            toWorld[i] /= unit;
            toCamera[i] *= unit;
        }
        // The inverse transpose carries the normal of the lens plane. As |det M| = 1, its length is the stretch of
        // areas there.
        double stretch = Math.sqrt(toCamera[6] * toCamera[6] + toCamera[7] * toCamera[7] + toCamera[8] * toCamera[8]);
        viewX = toCamera[6] / stretch;
        viewY = toCamera[7] / stretch;
        viewZ = toCamera[8] / stretch;
        lensDensity = apertureRadius > 0 ? 1 / (Math.PI * apertureRadius * apertureRadius * stretch) : 1;
    }

    /**
     * Tangent of half the opening angle across the image width, from the opening angle along another extent of the image.
     *
     * @param degrees full opening angle, between 0 and 180
     * @param extent length in pixels that the angle spans: the width, the height, the longer, the shorter, or the
     *     diagonal {@code Math.hypot(width, height)}
     * @param width film width in pixels
     */
    public static double tanHalfWidth(double degrees, double extent, int width) {
        return Math.tan(Math.toRadians(0.5 * degrees)) * width / extent;
    }

    private static void requirePositive(String what, double value) {
        if (!(value > 0 && value < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException(what + " must be positive and finite but is " + value);
        }
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
    public boolean hasLensArea() {
        return apertureRadius > 0;
    }

    @Override
    public boolean sampleRay(double filmX, double filmY, double u, double v, CameraRay out) {
        double x = (middleX - filmX) / pixelsPerX;
        double y = (middleY - filmY) / pixelsPerY;
        double lensX = 0;
        double lensY = 0;
        if (apertureRadius > 0) {
            Warps.toConcentricDisk(u, v, out.scratch);
            lensX = apertureRadius * out.scratch[0];
            lensY = apertureRadius * out.scratch[1];
        }
        // From the lens point to the point of the focal plane that the film position is sharp at, per unit of depth.
        double dx = x - lensX / focusDistance;
        double dy = y - lensY / focusDistance;
        double wx = toWorld[0] * dx + toWorld[1] * dy + toWorld[2];
        double wy = toWorld[3] * dx + toWorld[4] * dy + toWorld[5];
        double wz = toWorld[6] * dx + toWorld[7] * dy + toWorld[8];
        double squared = wx * wx + wy * wy + wz * wz;
        double length = Math.sqrt(squared);
        out.ox = originX + toWorld[0] * lensX + toWorld[1] * lensY;
        out.oy = originY + toWorld[3] * lensX + toWorld[4] * lensY;
        out.oz = originZ + toWorld[6] * lensX + toWorld[7] * lensY;
        out.dx = wx / length;
        out.dy = wy / length;
        out.dz = wz / length;
        out.normalX = viewX;
        out.normalY = viewY;
        out.normalZ = viewZ;
        out.weight = 1;
        out.densityPosition = lensDensity;
        out.densityDirection = pixelsPerArea * squared * length / width / height;
        return true;
    }

    @Override
    public boolean sampleLens(double px, double py, double pz, double u, double v, LensSample out) {
        double lensX = 0;
        double lensY = 0;
        if (apertureRadius > 0) {
            Warps.toConcentricDisk(u, v, out.scratch);
            lensX = apertureRadius * out.scratch[0];
            lensY = apertureRadius * out.scratch[1];
        }
        return connect(px, py, pz, lensX, lensY, out);
    }

    @Override
    public boolean hitLens(double ox, double oy, double oz, double dx, double dy, double dz, LensSample out) {
        double lx = ox - originX;
        double ly = oy - originY;
        double lz = oz - originZ;
        double above = depth(lx, ly, lz);
        double descent = -depth(dx, dy, dz);
        if (!(apertureRadius > 0 && above > 0 && descent > 0)) {
            return false;
        }
        double distance = above / descent;
        double lensX = planeX(lx, ly, lz) + distance * planeX(dx, dy, dz);
        double lensY = planeY(lx, ly, lz) + distance * planeY(dx, dy, dz);
        return lensX * lensX + lensY * lensY <= apertureRadius * apertureRadius
                && connect(ox, oy, oz, lensX, lensY, out);
    }

    /** Joins a scene point to a point of the lens. */
    private boolean connect(double px, double py, double pz, double lensX, double lensY, LensSample out) {
        SurfacePoint point = out.point;
        point.x = originX + toWorld[0] * lensX + toWorld[1] * lensY;
        point.y = originY + toWorld[3] * lensX + toWorld[4] * lensY;
        point.z = originZ + toWorld[6] * lensX + toWorld[7] * lensY;
        double dx = px - point.x;
        double dy = py - point.y;
        double dz = pz - point.z;
        double depth = depth(dx, dy, dz);
        if (!(depth > 0)) {
            return false;
        }
        double filmX = filmX(planeX(dx, dy, dz) / depth + lensX / focusDistance);
        double filmY = filmY(planeY(dx, dy, dz) / depth + lensY / focusDistance);
        if (!onFilm(filmX, filmY)) {
            return false;
        }
        double squared = dx * dx + dy * dy + dz * dz;
        double distance = Math.sqrt(squared);
        out.wiX = -dx / distance;
        out.wiY = -dy / distance;
        out.wiZ = -dz / distance;
        out.distance = distance;
        out.filmX = filmX;
        out.filmY = filmY;
        // |M(x, y, 1)| is the distance per unit of depth.
        double perDepth = distance / depth;
        out.weight = pixelsPerArea * perDepth / (depth * depth);
        out.delta = !(apertureRadius > 0);
        double cosine = (dx * viewX + dy * viewY + dz * viewZ) / distance;
        out.density = out.delta ? 1 : lensDensity * squared / cosine;
        out.densityPosition = lensDensity;
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
    public boolean rayDensity(double ox, double oy, double oz, double dx, double dy, double dz, CameraRay out) {
        double depth = depth(dx, dy, dz);
        if (!(depth > 0)) {
            return false;
        }
        double shiftX = 0;
        double shiftY = 0;
        if (apertureRadius > 0) {
            double lx = ox - originX;
            double ly = oy - originY;
            double lz = oz - originZ;
            double lensX = planeX(lx, ly, lz);
            double lensY = planeY(lx, ly, lz);
            if (lensX * lensX + lensY * lensY > RIM * apertureRadius * apertureRadius) {
                return false;
            }
            shiftX = lensX / focusDistance;
            shiftY = lensY / focusDistance;
        }
        double filmX = filmX(planeX(dx, dy, dz) / depth + shiftX);
        double filmY = filmY(planeY(dx, dy, dz) / depth + shiftY);
        if (!onFilm(filmX, filmY)) {
            return false;
        }
        double perDepth = Math.sqrt(dx * dx + dy * dy + dz * dz) / depth;
        out.weight = 1;
        out.densityPosition = lensDensity;
        out.densityDirection = pixelsPerArea * perDepth * perDepth * perDepth / width / height;
        return true;
    }

    private double planeX(double dx, double dy, double dz) {
        return toCamera[0] * dx + toCamera[1] * dy + toCamera[2] * dz;
    }

    private double planeY(double dx, double dy, double dz) {
        return toCamera[3] * dx + toCamera[4] * dy + toCamera[5] * dz;
    }

    private double depth(double dx, double dy, double dz) {
        return toCamera[6] * dx + toCamera[7] * dy + toCamera[8] * dz;
    }

    private double filmX(double x) {
        return middleX - pixelsPerX * x;
    }

    private double filmY(double y) {
        return middleY - pixelsPerY * y;
    }

    private boolean onFilm(double filmX, double filmY) {
        return filmX >= 0 && filmX < width && filmY >= 0 && filmY < height;
    }
}
