package org.daybreak.core.light;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.DoubleBuffer;

/**
 * The RGB data of the sky model of Hosek and Wilkie, as they published them (licence beside the resource): doubles for
 * turbidity 1 to 10, albedo 0 and 1, six control points of the elevation, three channels and nine parameters; the same
 * without the last for the mean radiance; and for the sun turbidity, 45 segments of the elevation, channel, four powers of the
 * elevation and six of limb darkening.
 */
final class HosekWilkieData {
    static final int TURBIDITIES = 10;
    static final int CONTROL_POINTS = 6;
    static final int PARAMETERS = 9;
    static final int SEGMENTS = 45;
    static final int POWERS = 4;
    static final int DARKENING = 6;

    private static final int PARAMETER_COUNT = TURBIDITIES * 2 * CONTROL_POINTS * 3 * PARAMETERS;
    private static final int RADIANCE_COUNT = TURBIDITIES * 2 * CONTROL_POINTS * 3;
    private static final int SUN_COUNT = TURBIDITIES * SEGMENTS * 3 * POWERS * DARKENING;

    private final DoubleBuffer values;

    private HosekWilkieData(DoubleBuffer values) {
        this.values = values;
    }

    /** Reads the resource. */
    static HosekWilkieData load() {
        try (InputStream in = HosekWilkieData.class.getResourceAsStream("hosek_wilkie_rgb.bin")) {
            byte[] bytes = in == null ? new byte[0] : in.readAllBytes();
            if (bytes.length != 8 * (PARAMETER_COUNT + RADIANCE_COUNT + SUN_COUNT)) {
                throw new IllegalStateException("the data of the sky model are missing from the program");
            }
            return new HosekWilkieData(
                    ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).asDoubleBuffer());
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    double parameter(int turbidity, int albedo, int point, int channel, int parameter) {
        return values.get((((turbidity * 2 + albedo) * CONTROL_POINTS + point) * 3 + channel) * PARAMETERS + parameter);
    }

    double radiance(int turbidity, int albedo, int point, int channel) {
        return values.get(PARAMETER_COUNT + ((turbidity * 2 + albedo) * CONTROL_POINTS + point) * 3 + channel);
    }

    double sun(int turbidity, int segment, int channel, int power, int darkening) {
        return values.get(PARAMETER_COUNT
                + RADIANCE_COUNT
                + (((turbidity * SEGMENTS + segment) * 3 + channel) * POWERS + power) * DARKENING
                + darkening);
    }
}
