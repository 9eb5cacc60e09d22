package org.daybreak.core.material;

/**
 * What flows along a subpath (Veach 1997, §4.5 and ch. 5). It matters wherever scattering is not symmetric: refraction
 * scales radiance but not importance, and shading normals need an adjoint factor on light subpaths.
 */
public enum TransportMode {
    /** Eye subpaths: the walk carries importance outwards and gathers radiance; {@code f_s(wi→wo)} is evaluated. */
    RADIANCE,
    /** Light subpaths: the walk carries flux; the adjoint {@code f_s*(wo→wi)} is evaluated. */
    IMPORTANCE
}
