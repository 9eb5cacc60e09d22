package org.daybreak.core.light;

import java.util.ArrayList;
import java.util.List;
import org.daybreak.core.color.Spectrum;
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
        cases.add(directional());
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
                new Case("wide spot", new SpotLight(place, new Spectrum(3, 2, 1), 180, 0)));
    }

    static Case directional() {
        return new Case("directional", new DirectionalLight(0.3, -2, 0.4, new Spectrum(3, 2, 1), 0.5, -0.5, 1, 2.5));
    }

    /** Lights at infinity that rays can hit. */
    static List<Case> infinite() {
        return List.of(
                new Case("constant", new ConstantEnvironment(new Spectrum(3, 2, 1), 0.5, -0.5, 1, 2.5)),
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
