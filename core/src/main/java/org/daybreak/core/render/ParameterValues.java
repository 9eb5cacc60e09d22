package org.daybreak.core.render;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/** Validated values for a list of parameters; missing ones have their defaults. Immutable. */
public final class ParameterValues {
    private final Map<String, Object> values;

    private ParameterValues(Map<String, Object> values) {
        this.values = values;
    }

    /** All defaults. */
    public static ParameterValues defaults(List<Parameter> parameters) {
        return parse(parameters, Map.of(), "");
    }

    /**
     * Parses texts against parameter definitions.
     *
     * @param owner name of the renderer or method, for messages
     * @throws ParameterException for an unknown name (with the nearest one) or an inadmissible value
     */
    public static ParameterValues parse(List<Parameter> parameters, Map<String, String> texts, String owner) {
        Map<String, Object> values = new LinkedHashMap<>();
        for (Parameter p : parameters) {
            String text = texts.get(p.name());
            values.put(p.name(), text == null ? p.defaultValue() : p.parse(text));
        }
        for (String name : texts.keySet()) {
            if (!values.containsKey(name)) {
                throw new ParameterException("'" + owner + "' has no parameter '" + name + "'"
                        + NearestName.hint(name, List.copyOf(values.keySet())));
            }
        }
        return new ParameterValues(values);
    }

    /** A whole number. */
    public int integer(String name) {
        return (Integer) get(name);
    }

    /** A real number. */
    public double real(String name) {
        return (Double) get(name);
    }

    /** Real numbers, one at least. */
    public double[] reals(String name) {
        return Arrays.stream(((String) get(name)).split(",", -1))
                .mapToDouble(Double::parseDouble)
                .toArray();
    }

    /** A switch. */
    public boolean flag(String name) {
        return (Boolean) get(name);
    }

    /** A word. */
    public String choice(String name) {
        return (String) get(name);
    }

    /** The name of a folder; empty if there shall be none. */
    public String folder(String name) {
        return (String) get(name);
    }

    /** All values by name, in the order of their definition: for reports and file attributes. */
    public Map<String, Object> asMap() {
        return java.util.Collections.unmodifiableMap(values);
    }

    private Object get(String name) {
        Object value = values.get(name);
        if (value == null) {
            throw new IllegalArgumentException("no parameter is defined under the name " + name);
        }
        return value;
    }
}
