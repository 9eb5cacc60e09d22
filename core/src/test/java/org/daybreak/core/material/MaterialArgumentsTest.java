package org.daybreak.core.material;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Bad arguments are refused in words, and the compositions {@link Mask} and {@link TwoSided} do as they say. */
class MaterialArgumentsTest {
    private static final Texture WHITE = BsdfCases.white();
    private static final Texture TOO_BRIGHT = ConstantTexture.grey(1.01);

    @Test
    void reflectanceAboveOneIsRefused() {
        assertMessage("diffuse reflectance must be between 0 and 1 but reaches 1.01", () -> new Diffuse(TOO_BRIGHT));
        assertMessage("specular reflectance", () -> Conductor.mirror(TOO_BRIGHT));
        assertMessage("specular transmittance", () -> new Dielectric(1.5, 1, WHITE, TOO_BRIGHT));
        assertMessage("diffuse reflectance", () -> new Plastic(1.5, 1, TOO_BRIGHT, WHITE, false));
        assertMessage(
                "specular reflectance",
                () -> new RoughPlastic(Microfacet.Kind.GGX, 0.1, 1.5, 1, WHITE, TOO_BRIGHT, false));
        assertMessage("opacity", () -> new Mask(TOO_BRIGHT, new Diffuse(WHITE)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1.5, Double.NaN, Double.POSITIVE_INFINITY})
    void indicesOfRefractionAreChecked(double ior) {
        assertMessage("interior index of refraction", () -> new Dielectric(ior, 1, WHITE, WHITE));
        assertMessage("exterior index of refraction", () -> new Plastic(1.5, ior, WHITE, WHITE, false));
        assertMessage(
                "interior index of refraction",
                () -> new RoughPlastic(Microfacet.Kind.GGX, 0.1, ior, 1, WHITE, WHITE, false));
    }

    @Test
    void complexIndicesAreChecked() {
        Spectrum good = new Spectrum(1, 1, 1);
        assertMessage("in green", () -> new Conductor(new Spectrum(1, -1, 1), good, WHITE));
        assertMessage("in blue", () -> new Conductor(good, new Spectrum(1, 1, Double.NaN), WHITE));
        assertMessage(
                "in red",
                () -> new RoughConductor(
                        Microfacet.Kind.GGX, 0.2, new Spectrum(0, 1, 1), new Spectrum(0, 1, 1), WHITE));
    }

    @Test
    void changingTheIndexAfterwardsChangesNothing() {
        Spectrum eta = BsdfCases.eta();
        Conductor conductor = new Conductor(eta, BsdfCases.k(), WHITE);
        Spectrum before = new Spectrum();
        conductor.albedo(BsdfCases.point(), before);
        eta.set(5);
        Spectrum after = new Spectrum();
        conductor.albedo(BsdfCases.point(), after);
        assertEquals(before.r, after.r);
    }

    @Test
    void twoSidedRefusesWhatLetsLightThrough() {
        Bsdf diffuse = new Diffuse(WHITE);
        assertMessage("the front of", () -> new TwoSided(new Dielectric(1.5, 1, WHITE, WHITE), diffuse));
        assertMessage("a mask goes around", () -> new TwoSided(diffuse, new Mask(WHITE, diffuse)));
    }

    @Test
    void oneMaterialHasOneFrame() {
        Bsdf diffuse = new Diffuse(WHITE);
        Bsdf first = new NormalMap(map(false), diffuse, false);
        Bsdf second = new BumpMap(map(true), 1, diffuse, false);
        assertEquals(TangentFrame.FIRST_UVS, first.tangentFrame());
        assertEquals(TangentFrame.SECOND_UVS, new Blend(ConstantTexture.grey(0.5), second, diffuse).tangentFrame());
        assertMessage("over the first and over the second", () -> new TwoSided(first, second));
        assertMessage("over the first and over the second", () -> new Blend(WHITE, second, first));
        assertMessage("over the first and over the second", () -> new NormalMap(map(true), first, false));
    }

    private static Texture map(boolean secondUvs) {
        return new BitmapTexture(
                TextureImage.fromFloats(1, 1, 1, new float[] {0.5f}),
                BitmapTexture.Filter.BILINEAR,
                BitmapTexture.Wrap.REPEAT,
                BitmapTexture.Wrap.REPEAT,
                new double[] {1, 0, 0, 0, 1, 0},
                secondUvs);
    }

    @Test
    void twoSidedShowsEachMaterialOnItsSide() {
        Bsdf bsdf = new TwoSided(new Diffuse(ConstantTexture.grey(0.2)), new Diffuse(ConstantTexture.grey(0.7)));
        SurfacePoint point = BsdfCases.point();
        Spectrum value = new Spectrum();
        double density = bsdf.evaluate(point, 0, 0.6, 0.8, 0, 0, 1, TransportMode.RADIANCE, value);
        assertEquals(0.2 / Math.PI, value.r, 1e-15);
        assertEquals(1 / Math.PI, density, 1e-15);
        bsdf.evaluate(point, 0, 0.6, -0.8, 0, 0, -1, TransportMode.RADIANCE, value);
        assertEquals(0.7 / Math.PI, value.r, 1e-15);
        BsdfSample sample = new BsdfSample();
        assertTrue(bsdf.sample(point, 0, 0.6, -0.8, 0.3, 0.4, 0.5, TransportMode.RADIANCE, sample));
        assertTrue(sample.wiZ < 0);
        assertEquals(0.7, sample.weight.r, 1e-15);
    }

    @Test
    void maskPassesWhatIsNotThere() {
        Bsdf bsdf = new Mask(ConstantTexture.grey(0.25), new Diffuse(ConstantTexture.grey(0.6)));
        SurfacePoint point = BsdfCases.point();
        assertEquals(0.75, bsdf.transparency(point), 1e-15);
        assertTrue(bsdf.maybeTransparent());
        assertFalse(new Diffuse(WHITE).maybeTransparent());
        Spectrum value = new Spectrum();
        double density = bsdf.evaluate(point, 0, 0.6, 0.8, 0, 0, 1, TransportMode.RADIANCE, value);
        assertEquals(0.25 * 0.6 / Math.PI, value.r, 1e-15);
        assertEquals(0.25 / Math.PI, density, 1e-15);
        BsdfSample sample = new BsdfSample();
        assertTrue(bsdf.sample(point, 0, 0.6, 0.8, 0.3, 0.4, 0.25, TransportMode.RADIANCE, sample));
        assertTrue(sample.passThrough && sample.delta);
        assertEquals(0.75, sample.density, 1e-15);
        assertEquals(1, sample.weight.r, 1e-15);
        assertEquals(-0.8, sample.wiZ);
        assertTrue(bsdf.sample(point, 0, 0.6, 0.8, 0.3, 0.4, 0.2499, TransportMode.RADIANCE, sample));
        assertFalse(sample.passThrough);
    }

    @Test
    void masksMultiply() {
        Bsdf bsdf = new Mask(ConstantTexture.grey(0.5), new Mask(ConstantTexture.grey(0.4), new Diffuse(WHITE)));
        assertEquals(0.8, bsdf.transparency(BsdfCases.point()), 1e-15);
    }

    private static void assertMessage(String part, Runnable action) {
        IllegalArgumentException e = assertThrows(IllegalArgumentException.class, action::run);
        assertTrue(e.getMessage().contains(part), e.getMessage());
    }
}
