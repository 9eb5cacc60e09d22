package org.daybreak.core.light;

import javax.vecmath.Color3f;
import javax.vecmath.Vector3d;

/**
 * State of the atmosphere and place of the sun. Immutable. The zenith is +z.
 *
 * @param kind model of the sky
 * @param turbidity haze, from 1 to 10: 1 for pure air, 2 a very clear day, 10 a hazy one; from 1.7 on for Preetham,
 *     whose fit is negative below
 * @param albedo albedo of the ground in linear RGB, from 0 to 1; Preetham's model does not use it
 * @param sun direction to the sun, of any positive length; below the horizon there is neither sky nor sun
 */
public record SkySettings(Kind kind, double turbidity, Color3f albedo, Vector3d sun) {
    /** Models of the sky. */
    public enum Kind {
        /** Hosek and Wilkie 2012. */
        HOSEK_WILKIE,
        /** Preetham, Shirley and Smits 1999. */
        PREETHAM
    }

    /** Copies the tuples, makes the direction a unit vector and checks the numbers. */
    public SkySettings {
        if (!(turbidity >= 1 && turbidity <= 10)) {
            throw new IllegalArgumentException("the turbidity of the sky must be from 1 to 10 but is " + turbidity);
        }
        if (kind == Kind.PREETHAM && turbidity < 1.7) {
            throw new IllegalArgumentException(
                    "Preetham's sky is valid from a turbidity of 1.7 on but the turbidity is " + turbidity);
        }
        albedo = new Color3f(albedo);
        for (float a : new float[] {albedo.x, albedo.y, albedo.z}) {
            if (!(a >= 0 && a <= 1)) {
                throw new IllegalArgumentException("the albedo of the ground must be from 0 to 1 but is " + albedo);
            }
        }
        sun = new Vector3d(sun);
        double length = sun.length();
        if (!(length > 0 && length < Double.POSITIVE_INFINITY)) {
            throw new IllegalArgumentException("the direction to the sun must not be zero but is " + sun);
        }
        sun.scale(1 / length);
    }

    @Override
    public Color3f albedo() {
        return new Color3f(albedo);
    }

    @Override
    public Vector3d sun() {
        return new Vector3d(sun);
    }

    /** Angle between the sun and the zenith in radians. */
    double zenithAngle() {
        return Math.acos(Math.max(-1, Math.min(1, sun.z)));
    }

    SkyModel model() {
        return switch (kind) {
            case HOSEK_WILKIE ->
                new HosekWilkieSky(turbidity, new double[] {albedo.x, albedo.y, albedo.z}, zenithAngle());
            case PREETHAM -> new PreethamSky(turbidity, zenithAngle());
        };
    }
}
