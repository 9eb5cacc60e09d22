package org.daybreak.scenes.mitsuba;

import java.util.Map;
import org.daybreak.scenes.description.Value;
import org.daybreak.scenes.mitsuba.Numbers.FormatException;

/** Points and vectors in the attributes x, y, z or value. */
final class Coordinates {
    private Coordinates() {}

    /** A point or vector, all of whose coordinates must be given. */
    static Value triple(String element, Map<String, String> attributes) throws FormatException {
        if (!attributes.containsKey("value")
                && !(attributes.containsKey("x") && attributes.containsKey("y") && attributes.containsKey("z"))) {
            throw new FormatException("<" + element + "> needs the attribute 'value' or 'x', 'y' and 'z'");
        }
        double[] xyz = of(attributes, 0);
        return new Value.Triple(xyz[0], xyz[1], xyz[2]);
    }

    /** Three numbers from x, y, z, or from one or three in value. */
    static double[] of(Map<String, String> attributes, double missing) throws FormatException {
        String value = attributes.get("value");
        if (value != null) {
            if (attributes.containsKey("x") || attributes.containsKey("y") || attributes.containsKey("z")) {
                throw new FormatException("either 'value' or 'x', 'y' and 'z' can be given, not both");
            }
            double[] values = Numbers.list(value);
            if (values.length == 1) {
                return new double[] {values[0], values[0], values[0]};
            }
            if (values.length != 3) {
                throw new FormatException("'" + Numbers.shortened(value) + "' must be one or three numbers");
            }
            return values;
        }
        double[] xyz = {missing, missing, missing};
        for (int i = 0; i < 3; i++) {
            String coordinate = attributes.get("xyz".substring(i, i + 1));
            if (coordinate != null) {
                xyz[i] = Numbers.real(coordinate);
            }
        }
        return xyz;
    }
}
