package org.daybreak.core.scene;

import javax.vecmath.Color3f;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.light.ConstantEnvironment;
import org.daybreak.core.light.DirectionalLight;
import org.daybreak.core.light.ImageEnvironment;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.PhotometricLight;
import org.daybreak.core.light.PointLight;
import org.daybreak.core.light.SkyLight;
import org.daybreak.core.light.SpotLight;
import org.daybreak.core.light.SunLight;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Transform;

/** Turns light descriptions into lights. */
final class LightCompiler {
    private LightCompiler() {}

    /**
     * A light that is no shape.
     *
     * @param scene bounds of all geometry
     */
    static Light light(LightSource source, Transform toWorld, Bounds scene) {
        if (source instanceof LightSource.Point point) {
            double[] p = new double[3];
            toWorld.applyPoint(0, 0, 0, p);
            return new PointLight(p[0], p[1], p[2], spectrum(point.intensity()));
        }
        if (source instanceof LightSource.Spot spot) {
            return new SpotLight(
                    toWorld, spectrum(spot.intensity()), spot.cutoffDegrees(), spot.beamDegrees(), spot.slide());
        }
        if (source instanceof LightSource.Photometric lamp) {
            return new PhotometricLight(lamp.profile(), spectrum(lamp.color()), toWorld);
        }
        double x = scene.isEmpty() ? 0 : scene.centerX();
        double y = scene.isEmpty() ? 0 : scene.centerY();
        double z = scene.isEmpty() ? 0 : scene.centerZ();
        double radius = scene.boundingSphereRadius();
        if (source instanceof LightSource.Directional directional) {
            double[] d = new double[3];
            toWorld.applyVector(0, 0, 1, d);
            return new DirectionalLight(d[0], d[1], d[2], spectrum(directional.irradiance()), x, y, z, radius);
        }
        if (source instanceof LightSource.ConstantEnvironment constant) {
            return new ConstantEnvironment(spectrum(constant.radiance()), x, y, z, radius);
        }
        if (source instanceof LightSource.ImageEnvironment image) {
            return new ImageEnvironment(image.image(), image.scale(), toWorld, x, y, z, radius);
        }
        if (source instanceof LightSource.Sky sky) {
            return new SkyLight(sky.settings(), sky.scale(), toWorld, x, y, z, radius);
        }
        if (source instanceof LightSource.Sun sun) {
            return new SunLight(sun.settings(), sun.apertureDegrees(), sun.scale(), toWorld, x, y, z, radius);
        }
        throw new AssertionError(source);
    }

    private static Spectrum spectrum(Color3f color) {
        return new Spectrum(color.x, color.y, color.z);
    }
}
