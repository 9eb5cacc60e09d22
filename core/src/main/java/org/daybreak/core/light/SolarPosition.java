package org.daybreak.core.light;

import javax.vecmath.Vector3d;

/**
 * Where the sun is at a time and place, to half a minute of arc from 1999 to 2015 and somewhat more beyond (Blanco-Muriel et
 * al., “Computing the Solar Vector”, Solar Energy 70(5), 2001). Pure functions.
 */
public final class SolarPosition {
    /** Mean radius of the earth over the astronomical unit: the parallax at the horizon. */
    private static final double PARALLAX = 6371.01 / 149_597_890.0;

    private SolarPosition() {}

    /**
     * Unit direction to the sun; +z is the zenith, +x south, +y west, as Mitsuba has it.
     *
     * @param month from 1
     * @param day day of the month, from 1
     * @param hour local time in hours, with fractions
     * @param timezone offset of local time from universal time in hours, positive to the east
     * @param latitude in degrees, positive to the north
     * @param longitude in degrees, positive to the east
     */
    public static Vector3d direction(
            int year, int month, int day, double hour, double timezone, double latitude, double longitude) {
        double universal = hour - timezone;
        // Days since noon of 1 January 2000; integer division truncates, as the formula wants.
        int early = (month - 14) / 12;
        long number = 1461L * (year + 4800 + early) / 4
                + 367L * (month - 2 - 12 * early) / 12
                - 3L * ((year + 4900 + early) / 100) / 4
                + day
                - 32_075;
        double days = number - 0.5 + universal / 24 - 2_451_545;
        double omega = 2.1429 - 0.0010394594 * days;
        double meanLongitude = 4.8950630 + 0.017202791698 * days;
        double anomaly = 6.2400600 + 0.0172019699 * days;
        double ecliptic = meanLongitude
                + 0.03341607 * Math.sin(anomaly)
                + 0.00034894 * Math.sin(2 * anomaly)
                - 0.0001134
                - 0.0000203 * Math.sin(omega);
        double obliquity = 0.4090928 - 6.2140e-9 * days + 0.0000396 * Math.cos(omega);
        double ascension = Math.atan2(Math.cos(obliquity) * Math.sin(ecliptic), Math.cos(ecliptic));
        double declination = Math.asin(Math.sin(obliquity) * Math.sin(ecliptic));
        double sidereal = 6.6974243242 + 0.0657098283 * days + universal;
        double hourAngle = Math.toRadians(sidereal * 15 + longitude) - ascension;
        double phi = Math.toRadians(latitude);
        double cosZenith =
                Math.cos(phi) * Math.cos(hourAngle) * Math.cos(declination) + Math.sin(declination) * Math.sin(phi);
        double zenith = Math.acos(Math.max(-1, Math.min(1, cosZenith)));
        // Clockwise from north.
        double azimuth = Math.atan2(
                -Math.sin(hourAngle), Math.tan(declination) * Math.cos(phi) - Math.sin(phi) * Math.cos(hourAngle));
        double seen = zenith + PARALLAX * Math.sin(zenith);
        return new Vector3d(-Math.sin(seen) * Math.cos(azimuth), -Math.sin(seen) * Math.sin(azimuth), Math.cos(seen));
    }
}
