package org.daybreak.core.scene;

import javax.vecmath.Color3f;
import org.daybreak.core.light.RadianceMap;

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
     */
    record Spot(Color3f intensity, double cutoffDegrees, double beamDegrees) implements LightSource {}

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
}
