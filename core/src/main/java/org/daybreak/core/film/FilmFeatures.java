package org.daybreak.core.film;

import org.daybreak.core.color.Spectrum;

/** What a sample sees first, for the auxiliary images. Mutable, owned by one worker. */
public final class FilmFeatures {
    /** True if the sample sees a surface; otherwise the other fields are not read. */
    public boolean hit;

    /** Reflectance plus transmittance. */
    public final Spectrum albedo = new Spectrum();

    /** Shading normal, world space. */
    public double nx;

    public double ny;
    public double nz;

    /** Distance from the lens along the ray. */
    public double depth;

    /** Creates features that see nothing. */
    public FilmFeatures() {}

    /** Whether all values that will be read are finite. */
    boolean isFinite() {
        return !hit || (albedo.isFinite() && Double.isFinite(nx + ny + nz) && Double.isFinite(depth));
    }
}
