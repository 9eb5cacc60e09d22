package org.daybreak.core.light;

import org.daybreak.core.color.Spectrum;

/** Radiance of a clear sky for one position of the sun. Immutable and thread-safe. */
interface SkyModel {
    /**
     * Writes the radiance in linear RGB, not negative; its luminance is the mean spectral radiance of visible light in
     * W/(m²·sr·nm).
     *
     * @param cosTheta cosine between the direction looked in and the zenith, from 0 to 1
     * @param gamma angle between that direction and the sun in radians
     */
    void radiance(double cosTheta, double gamma, Spectrum out);
}
