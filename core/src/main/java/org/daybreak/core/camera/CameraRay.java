package org.daybreak.core.camera;

/** A ray leaving the lens: the start of an eye subpath. Mutable, owned by one worker. */
public final class CameraRay {
    /** Origin on the lens, world space. */
    public double ox;

    public double oy;
    public double oz;

    /** Unit direction into the scene. */
    public double dx;

    public double dy;
    public double dz;

    /** Unit normal of the lens at the origin, on the side of the scene; the direction if it is a single point for all directions. */
    public double normalX;

    public double normalY;
    public double normalZ;

    /**
     * Throughput factor We·cos/(densities), with the film point uniform in its pixel: 1 for all cameras whose pixels
     * measure mean radiance.
     */
    public double weight;

    /** Density of the origin per area on the lens; 1 if the lens is a single point. */
    public double densityPosition;

    /**
     * Density of the direction per solid angle, given the origin, when one film point is drawn uniformly over the whole
     * film; 1 where the direction is a single one.
     */
    public double densityDirection;

    /** Room for intermediate results of the cameras, so that they need not allocate. */
    final double[] scratch = new double[3];
}
