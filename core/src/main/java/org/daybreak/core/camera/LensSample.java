package org.daybreak.core.camera;

import org.daybreak.core.geometry.SurfacePoint;

/** A point of the lens as seen from a scene point, and where that line meets the film (technique t = 1). */
public final class LensSample {
    /** Unit direction from the scene point to the lens. */
    public double wiX;

    public double wiY;
    public double wiZ;

    /** Distance to the lens point. */
    public double distance;

    /** The lens point; its geometric normal is the viewing direction. */
    public final SurfacePoint point = new SurfacePoint();

    /** Film position in pixels; (0,0) is the upper left corner of the upper left pixel. */
    public double filmX;

    public double filmY;

    /**
     * Importance divided by the density of the lens point: film area in pixels² per solid angle at the lens, over d². Multiply
     * with {@code f·|cos θ|} at the scene point, the subpath's throughput and visibility, and divide by the number
     * of light subpaths traced: the sum of such splats over a pixel is its mean radiance.
     */
    public double weight;

    /** Density of the lens point per solid angle at the scene point; 1 if the lens is a single point. */
    public double density;

    /** The same per area on the lens; 1 if the lens is a single point. */
    public double densityPosition;

    /** True if the lens is a single point: no scattered ray can hit it. */
    public boolean delta;

    /** Room for intermediate results of the cameras, so that they need not allocate. */
    final double[] scratch = new double[3];
}
