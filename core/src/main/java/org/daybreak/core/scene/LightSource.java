package org.daybreak.core.scene;

import javax.vecmath.Color3f;
import org.daybreak.core.light.PhotometricProfile;
import org.daybreak.core.light.RadianceMap;
import org.daybreak.core.light.SkySettings;
import org.daybreak.core.material.Texture;
import org.jspecify.annotations.Nullable;

/**
 * Lights as scenes describe them, other than emitting shapes. Position and direction come from the node's transform.
 * Colours are linear RGB in radiometric units.
 */
public sealed interface LightSource {
    /**
     * An isotropic point light at the origin.
     *
     * @param intensity radiant intensity in W/sr
     */
    record Point(Color3f intensity) implements LightSource {}

    /**
     * A spot at the origin that shines along +z.
     *
     * @param intensity radiant intensity along the axis in W/sr
     * @param cutoffDegrees angle from the axis beyond which there is no light
     * @param beamDegrees angle up to which the intensity is full; linear fall-off in angle from there to the cutoff
     * @param slide factor on the intensity as {@link org.daybreak.core.light.SpotLight} projects it; null for none
     */
    record Spot(
            Color3f intensity,
            double cutoffDegrees,
            double beamDegrees,
            @Nullable Texture slide) implements LightSource {
        /** A spot without a slide. */
        public Spot(Color3f intensity, double cutoffDegrees, double beamDegrees) {
            this(intensity, cutoffDegrees, beamDegrees, null);
        }
    }

    /**
     * A point with the measured distribution of a luminaire, whose axis is +z.
     *
     * @param profile luminous intensity over directions
     * @param color factor on it; of luminance 1, it leaves the intensity as measured
     */
    record Photometric(PhotometricProfile profile, Color3f color) implements LightSource {}

    /**
     * Parallel light from infinity that travels along +z.
     *
     * @param irradiance irradiance of a surface that faces the light in W/m²
     */
    record Directional(Color3f irradiance) implements LightSource {}

    /**
     * The same radiance from all directions.
     *
     * @param radiance radiance in W/(m²·sr)
     */
    record ConstantEnvironment(Color3f radiance) implements LightSource {}

    /**
     * An equirectangular panorama around the scene, up is +y; orientation as in
     * {@link RadianceMap}.
     *
     * @param image the panorama
     * @param scale factor on its values
     */
    record ImageEnvironment(RadianceMap image, double scale) implements LightSource {}

    /**
     * A clear sky without the sun; the zenith is +z.
     *
     * @param settings atmosphere and sun
     * @param scale factor on the radiance
     */
    record Sky(SkySettings settings, double scale) implements LightSource {}

    /**
     * The disk of the sun in a clear sky; the zenith is +z.
     *
     * @param settings atmosphere and sun
     * @param apertureDegrees angular diameter in degrees
     * @param scale factor on the radiance
     */
    record Sun(SkySettings settings, double apertureDegrees, double scale) implements LightSource {}
}
