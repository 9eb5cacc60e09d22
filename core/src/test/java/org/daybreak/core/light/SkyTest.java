package org.daybreak.core.light;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.math.Transform;
import org.junit.jupiter.api.Test;

class SkyTest {
    private final SurfacePoint unused = new SurfacePoint();
    private final Spectrum value = new Spectrum();

    private static SkySettings settings(SkySettings.Kind kind, double turbidity, double elevation, float albedo) {
        double e = Math.toRadians(elevation);
        return new SkySettings(
                kind,
                turbidity,
                new Color3f(albedo, albedo, albedo),
                new Vector3d(3 * Math.cos(e), 0, 3 * Math.sin(e)));
    }

    private static Light sky(SkySettings settings) {
        return new SkyLight(settings, 1, Transform.identity(), 0, 0, 0, 1);
    }

    private static Light sun(SkySettings settings, double aperture) {
        return new SunLight(settings, aperture, 1, Transform.identity(), 0, 0, 0, 1);
    }

    /** What Mitsuba 3.9.1 (scalar_rgb, {@code sunsky}, sun_scale 0) gives: turbidity, elevation, albedo, direction, RGB. */
    @Test
    void skiesAreThoseOfMitsuba() {
        double[][] table = {
            {3, 50, 0.3, 0, 0, 1, 0.0267638, 0.045399, 0.0910723},
            {3, 50, 0.3, 0.6, 0.64, 0.48, 0.0645964, 0.102243, 0.171741},
            {3, 50, 0.3, -0.8, 0, 0.6, 0.0300169, 0.0583204, 0.11703},
            {2.5, 8, 0.1, 0, 0, 1, 0.00731243, 0.0144637, 0.0245542},
            {2.5, 8, 0.1, 0.6, 0.64, 0.48, 0.0321301, 0.0458172, 0.0584028},
            {6, 1, 0.5, -0.8, 0, 0.6, 0.0141694, 0.0150191, 0.0135375},
            {1, 80, 0, 0.6, 0.64, 0.48, 0.0303704, 0.0620288, 0.122908},
        };
        for (double[] row : table) {
            Light light = sky(settings(SkySettings.Kind.HOSEK_WILKIE, row[0], row[1], (float) row[2]));
            light.radiance(unused, -row[3], -row[4], -row[5], value);
            assertEquals(row[6], value.r, 2e-5 * row[6]);
            assertEquals(row[7], value.g, 2e-5 * row[7]);
            assertEquals(row[8], value.b, 2e-5 * row[8]);
        }
    }

    /** Integrals over the disk of the data, by an independent program: 24 Gauss–Legendre nodes in cos ψ, 64 azimuths. */
    @Test
    void theMeanOfTheSunIsTheIntegral() {
        double[][] table = {
            {3, 50, 21599.9686, 17891.0027, 13429.749},
            {2.5, 8, 13738.0426, 7687.2614, 2150.0515},
            {1, 80, 22733.0326, 19285.0089, 15198.0492}
        };
        for (double[] row : table) {
            Spectrum mean = HosekWilkieSky.meanSunRadiance(row[0], Math.toRadians(90 - row[1]));
            assertEquals(row[2], mean.r, 1e-4 * row[2]);
            assertEquals(row[3], mean.g, 1e-4 * row[3]);
            assertEquals(row[4], mean.b, 1e-4 * row[4]);
        }
    }

    /** The mean of the disk is within 0.3 % of what Mitsuba 3.9.1 has in the table it ships. */
    @Test
    void sunsAreThoseOfMitsuba() {
        double[][] table = {{3, 50, 21580.8, 17872, 13411.9}, {2.5, 8, 13725.6, 7679.04, 2147.05}};
        for (double[] row : table) {
            double e = Math.toRadians(row[1]);
            Light light = sun(settings(SkySettings.Kind.HOSEK_WILKIE, row[0], row[1], 0), SunLight.APERTURE_DEGREES);
            light.radiance(unused, -Math.cos(e), 0, -Math.sin(e), value);
            assertEquals(row[2], value.r, 3e-3 * row[2]);
            assertEquals(row[3], value.g, 3e-3 * row[3]);
            assertEquals(row[4], value.b, 3e-3 * row[4]);
        }
    }

    @Test
    void largerSunsGiveTheSamePower() {
        SkySettings settings = settings(SkySettings.Kind.HOSEK_WILKIE, 4, 40, 0);
        double power = sun(settings, SunLight.APERTURE_DEGREES).power();
        assertEquals(power, sun(settings, 10).power(), 1e-9 * power);
        assertEquals(
                0, sun(settings(SkySettings.Kind.HOSEK_WILKIE, 4, -1, 0), 10).power());
    }

    /** Zenith luminance of Preetham et al., appendix A.2: (4.0453T − 4.9710)·tan χ − 0.2155T + 2.4192 kcd/m². */
    @Test
    void preethamsZenithHasTheLuminanceOfThePaper() {
        for (double turbidity : new double[] {2, 3.5, 6}) {
            for (double elevation : new double[] {10, 45, 70}) {
                sky(settings(SkySettings.Kind.PREETHAM, turbidity, elevation, 0))
                        .radiance(unused, 0, 0, -1, value);
                double chi = (4.0 / 9 - turbidity / 120) * Math.toRadians(2 * elevation);
                double kilo = (4.0453 * turbidity - 4.9710) * Math.tan(chi) - 0.2155 * turbidity + 2.4192;
                // 683 lm/W over the integral of the CIE curve, 106.75 nm.
                assertEquals(kilo * 1000 / (683.002 * 106.7502594), value.luminance(), 1e-3 * value.luminance());
                assertTrue(value.b > value.r, "the zenith is blue");
            }
        }
    }

    @Test
    void belowTheHorizonItIsDark() {
        Light light = sky(settings(SkySettings.Kind.HOSEK_WILKIE, 3, 30, 0.5f));
        light.radiance(unused, 0.6, 0, 0.8, value);
        assertTrue(value.isBlack());
        assertEquals(0, light.incidentDensity(0, 0, 0, unused, 0.6, 0, -0.8));
        Light night = sky(settings(SkySettings.Kind.PREETHAM, 3, -5, 0.5f));
        assertEquals(0, night.power());
        assertFalse(night.sampleIncident(0, 0, 0, 0.3, 0.4, new LightSample()));
    }

    /** 10 a.m. of 20 May 2015 at 48° N 11.5° E, UTC+1: what Mitsuba 3.9.1 finds, to the width of the disk it was sought with. */
    @Test
    void theSunStandsWhereMitsubaHasIt() {
        Vector3d sun = SolarPosition.direction(2015, 5, 20, 10, 1, 48, 11.5);
        Vector3d mitsuba = new Vector3d(0.35715, -0.50536, 0.78490);
        mitsuba.normalize();
        double cosine = sun.dot(mitsuba);
        assertEquals(1, sun.length(), 1e-12);
        assertTrue(Math.toDegrees(Math.acos(Math.min(1, cosine))) < 0.7, sun::toString);
        // At the equinox the sun passes over the equator's zenith at local noon, within the equation of time.
        Vector3d noon = SolarPosition.direction(2015, 3, 20, 12, 0, 0, 0);
        assertTrue(noon.z > 0.998, noon::toString);
        // In the morning it is in the east, −y; in the northern winter at noon in the south, +x.
        assertTrue(SolarPosition.direction(2015, 3, 20, 8, 0, 0, 0).y < -0.8);
        assertTrue(SolarPosition.direction(2015, 12, 21, 12, 0, 50, 0).x > 0.9);
    }

    @Test
    void badNumbersAreRefused() {
        for (double turbidity : new double[] {0.9, 11, Double.NaN}) {
            assertThrows(
                    IllegalArgumentException.class, () -> settings(SkySettings.Kind.HOSEK_WILKIE, turbidity, 40, 0));
        }
        assertThrows(IllegalArgumentException.class, () -> settings(SkySettings.Kind.PREETHAM, 1.5, 40, 0));
        assertThrows(IllegalArgumentException.class, () -> settings(SkySettings.Kind.PREETHAM, 3, 40, 1.1f));
        SkySettings good = settings(SkySettings.Kind.PREETHAM, 3, 40, 0);
        assertThrows(IllegalArgumentException.class, () -> sun(good, 0));
        assertThrows(IllegalArgumentException.class, () -> new SkyLight(good, -1, Transform.identity(), 0, 0, 0, 1));
        assertThrows(IllegalArgumentException.class, () -> new SkyLight(good, 1, Transform.scale(1, 2, 1), 0, 0, 0, 1));
    }
}
