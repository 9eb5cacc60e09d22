package org.daybreak.core.light;

import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.Cube;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.SurfaceCase;
import org.daybreak.core.math.Transform;

/** Lights of every kind for tests. */
final class LightCases {
    /** A similarity with mirroring, as scene files use for environments. */
    static final Transform TURN = Transform.rotate(1, 2, 3, 70).multiply(Transform.scale(-2, 2, 2));

    private LightCases() {}

    record Case(String name, Light light) {
        @Override
        public String toString() {
            return name;
        }
    }

    static List<Case> all() {
        List<Case> cases = new ArrayList<>();
        cases.addAll(area(false));
        cases.addAll(area(true));
        cases.addAll(points());
        Transform place = Transform.translate(0.4, 0.3, -0.2).multiply(TURN);
        TestTexture pattern = new TestTexture(3, 2, 1, true);
        cases.add(new Case("patterned rectangle", AreaLight.of(new Rectangle(), place, false, 0, pattern, 7)));
        cases.add(new Case("patterned cube", AreaLight.of(new Cube(), place, false, 100, pattern, 7)));
        cases.add(directional());
        cases.add(new Case("setting sun", sun(0.05, 20)));
        cases.addAll(infinite());
        return cases;
    }

    static List<Case> area(boolean textured) {
        List<Case> cases = new ArrayList<>();
        for (SurfaceCase surface : SurfaceCase.all()) {
            cases.add(new Case(
                    surface.name() + (textured ? ", textured" : ""),
                    new AreaLight(surface.sampler(), new TestTexture(3, 2, 1, textured), 7)));
        }
        return cases;
    }

    static List<Case> points() {
        Transform place = Transform.translate(0.4, 0.3, -0.2).multiply(TURN);
        return List.of(
                new Case("point", new PointLight(0.4, 0.3, -0.2, new Spectrum(3, 2, 1))),
                new Case("spot", new SpotLight(place, new Spectrum(3, 2, 1), 40, 15)),
                new Case("spot with sharp edge", new SpotLight(place, new Spectrum(3, 2, 1), 70, 70)),
                new Case("wide spot", new SpotLight(place, new Spectrum(3, 2, 1), 180, 0)),
                new Case(
                        "spot with slide",
                        new SpotLight(place, new Spectrum(3, 2, 1), 40, 15, new TestTexture(1, 0.5, 0.3, true))),
                new Case("luminaire", new PhotometricLight(profile(), new Spectrum(300, 200, 100), place)),
                new Case("round luminaire", new PhotometricLight(roundProfile(), new Spectrum(300, 200, 100), place)));
    }

    static Case directional() {
        return new Case("directional", new DirectionalLight(0.3, -2, 0.4, new Spectrum(3, 2, 1), 0.5, -0.5, 1, 2.5));
    }

    /** Lights at infinity that rays can hit. */
    static List<Case> infinite() {
        return List.of(
                new Case("constant", new ConstantEnvironment(new Spectrum(3, 2, 1), 0.5, -0.5, 1, 2.5)),
                new Case("sky", sky(SkySettings.Kind.HOSEK_WILKIE, 0.5)),
                new Case("Preetham's sky", sky(SkySettings.Kind.PREETHAM, 0.1)),
                new Case("sun", sun(0.5, 20)),
                new Case("panorama", environment(panorama(8, 5), TURN)),
                new Case(
                        "panorama with shear",
                        environment(
                                panorama(8, 5),
                                Transform.ofRows(1.1, 0.5, 0.2, 0.1, -0.3, 0.8, 0.4, 0.2, 0.1, -0.2, 0.6, -0.4))),
                new Case("sun at the zenith", environment(spots(8, 5, 0, 0), TURN)),
                new Case("sun on the seam", environment(spots(16, 9, 15, 3), TURN)),
                new Case("single row", environment(panorama(4, 1), TURN)),
                new Case("single column", environment(panorama(1, 6), TURN)));
    }

    /** A profile with different values everywhere, symmetric about one plane, which ends at the horizon. */
    static PhotometricProfile profile() {
        double[] candela = new double[3 * 4];
        for (int i = 0; i < candela.length; i++) {
            candela[i] = 50 + i * 37 % 100;
        }
        return new PhotometricProfile(new double[] {0, 30, 60, 90}, new double[] {0, 90, 180}, candela);
    }

    static PhotometricProfile roundProfile() {
        return new PhotometricProfile(
                new double[] {0, 45, 90, 135, 180}, new double[] {0}, new double[] {10, 200, 100, 50, 0});
    }

    static SkySettings settings(SkySettings.Kind kind, double height) {
        return new SkySettings(kind, 3, new Color3f(0.2f, 0.3f, 0.1f), new Vector3d(0.6, 0.3, height));
    }

    static SkyLight sky(SkySettings.Kind kind, double height) {
        return new SkyLight(settings(kind, height), 2, TURN, 0.5, -0.5, 1, 2.5);
    }

    static SunLight sun(double height, double aperture) {
        return new SunLight(settings(SkySettings.Kind.HOSEK_WILKIE, height), aperture, 2, TURN, 0.5, -0.5, 1, 2.5);
    }

    static ImageEnvironment environment(RadianceMap map, Transform toWorld) {
        return new ImageEnvironment(map, 2, toWorld, 0.5, -0.5, 1, 2.5);
    }

    /** A map with different values everywhere. */
    static RadianceMap panorama(int width, int height) {
        float[] rgb = new float[3 * width * height];
        for (int y = 0; y < height; y++) {
            for (int x = 0; x < width; x++) {
                int i = 3 * (y * width + x);
                rgb[i] = (x + 1) * 0.25F;
                rgb[i + 1] = (y + 1) * 0.5F;
                rgb[i + 2] = (x * 3 + y * 5) % 7 * 0.125F;
            }
        }
        return new RadianceMap(width, height, rgb);
    }

    /** Black but for one pixel. */
    static RadianceMap spots(int width, int height, int x, int y) {
        float[] rgb = new float[3 * width * height];
        rgb[3 * (y * width + x)] = 5;
        rgb[3 * (y * width + x) + 1] = 4;
        rgb[3 * (y * width + x) + 2] = 3;
        return new RadianceMap(width, height, rgb);
    }
}
