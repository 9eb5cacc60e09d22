package org.daybreak.scenes.gltf;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.daybreak.core.render.NearestName;
import org.jspecify.annotations.Nullable;

/**
 * A value of a JSON document that knows where it stands. Getters check type and range and otherwise throw an exception that
 * points to the value. Filled by {@link JsonReader}, immutable afterwards.
 */
final class JsonValue {
    /** What a value is. */
    enum Kind {
        OBJECT("an object"),
        ARRAY("an array"),
        TEXT("a string"),
        NUMBER("a number"),
        TRUTH("a boolean"),
        NULL("null");

        private final String description;

        Kind(String description) {
            this.description = description;
        }
    }

    /** Longer texts of a file are cut in messages. */
    private static final int LONGEST_QUOTE = 80;

    private final Kind kind;
    private final @Nullable JsonValue parent;
    /** Name in the parent object, or null in an array or at the root. */
    private final @Nullable String name;
    /** Index in the parent array. */
    private final int index;

    private final int line;
    private final int column;
    private final double number;
    private final String text;
    private final Map<String, JsonValue> members;
    private final List<JsonValue> elements;

    JsonValue(
            Kind kind,
            @Nullable JsonValue parent,
            @Nullable String name,
            int line,
            int column,
            double number,
            String text) {
        this.kind = kind;
        this.parent = parent;
        this.name = name;
        this.index = parent == null ? 0 : parent.elements.size();
        this.line = line;
        this.column = column;
        this.number = number;
        this.text = text;
        this.members = kind == Kind.OBJECT ? new LinkedHashMap<>(4) : Map.of();
        this.elements = kind == Kind.ARRAY ? new ArrayList<>(4) : List.of();
    }

    /** Appends a value to the object or array it names as its parent. */
    void append(JsonValue child) {
        if (child.name == null) {
            elements.add(child);
        } else {
            members.put(child.name, child);
        }
    }

    @Nullable
    JsonValue parent() {
        return parent;
    }

    /** Line from 1. */
    int line() {
        return line;
    }

    /** Column from 1. */
    int column() {
        return column;
    }

    /** Position in the array it stands in. */
    int index() {
        return index;
    }

    /** JSON pointer; {@code /} for the root. */
    String path() {
        if (parent == null) {
            return "/";
        }
        Deque<String> steps = new ArrayDeque<>();
        for (JsonValue v = this; v.parent != null; v = v.parent) {
            String step = v.name;
            steps.push(
                    step == null
                            ? Integer.toString(v.index)
                            : quotable(step).replace("~", "~0").replace("/", "~1"));
        }
        return "/" + String.join("/", steps);
    }

    /** A text of the file as messages may show it: not too long, in one line. */
    static String quotable(String text) {
        String cut = text.length() > LONGEST_QUOTE ? text.substring(0, LONGEST_QUOTE) + "…" : text;
        return cut.replaceAll("\\p{Cntrl}", "?");
    }

    /** An exception that points here. */
    GltfException error(String problem) {
        return new GltfException(this, problem);
    }

    private GltfException wrongType(Kind wanted) {
        return error("must be " + wanted.description + " but is " + kind.description);
    }

    /** The members of an object. */
    Map<String, JsonValue> members() throws GltfException {
        if (kind != Kind.OBJECT) {
            throw wrongType(Kind.OBJECT);
        }
        return Collections.unmodifiableMap(members);
    }

    /** The elements of an array. */
    List<JsonValue> elements() throws GltfException {
        if (kind != Kind.ARRAY) {
            throw wrongType(Kind.ARRAY);
        }
        return Collections.unmodifiableList(elements);
    }

    /** A member of an object, or null if it has none of this name. */
    @Nullable
    JsonValue find(String member) throws GltfException {
        if (kind != Kind.OBJECT) {
            throw wrongType(Kind.OBJECT);
        }
        return members.get(member);
    }

    /** A member that must be there. */
    JsonValue get(String member) throws GltfException {
        JsonValue found = find(member);
        if (found == null) {
            throw error("needs the property '" + member + "'");
        }
        return found;
    }

    /** Follows names of members down; null if one of them is missing. */
    @Nullable
    JsonValue find(String first, String second) throws GltfException {
        JsonValue found = find(first);
        return found == null ? null : found.find(second);
    }

    /** An extension of an object by its name, or null. */
    @Nullable
    JsonValue extension(String extension) throws GltfException {
        return find("extensions", extension);
    }

    /** The elements of a member, none if it is missing. */
    List<JsonValue> list(String member) throws GltfException {
        JsonValue found = find(member);
        return found == null ? List.of() : found.elements();
    }

    /** The text. */
    String text() throws GltfException {
        if (kind != Kind.TEXT) {
            throw wrongType(Kind.TEXT);
        }
        return text;
    }

    /** The text of a member, or null if it is missing. */
    @Nullable
    String text(String member) throws GltfException {
        JsonValue found = find(member);
        return found == null ? null : found.text();
    }

    /** A word out of several. */
    String choice(String member, String otherwise, Collection<String> choices) throws GltfException {
        JsonValue found = find(member);
        if (found == null) {
            return otherwise;
        }
        String word = found.text();
        if (!choices.contains(word)) {
            throw found.error("must be one of " + String.join(", ", choices) + " but is '" + quotable(word)
                    + "'; did you mean '"
                    + NearestName.of(quotable(word), choices, 1).get(0) + "'?");
        }
        return word;
    }

    /** The truth value of a member. */
    boolean truth(String member, boolean otherwise) throws GltfException {
        JsonValue found = find(member);
        if (found == null) {
            return otherwise;
        }
        if (found.kind != Kind.TRUTH) {
            throw found.wrongType(Kind.TRUTH);
        }
        return found.number != 0;
    }

    /** The number, finite. */
    double number() throws GltfException {
        if (kind != Kind.NUMBER) {
            throw wrongType(Kind.NUMBER);
        }
        if (!Double.isFinite(number)) {
            throw error("is too large a number");
        }
        return number;
    }

    /** The number of a member. */
    double number(String member, double otherwise) throws GltfException {
        JsonValue found = find(member);
        return found == null ? otherwise : found.number();
    }

    /** The number of a member, within bounds. */
    double number(String member, double otherwise, double smallest, double largest) throws GltfException {
        JsonValue found = find(member);
        return found == null ? otherwise : found.between(smallest, largest);
    }

    private double between(double smallest, double largest) throws GltfException {
        double value = number();
        if (!(value >= smallest && value <= largest)) {
            String range = largest == Double.POSITIVE_INFINITY || largest == Double.MAX_VALUE
                    ? (smallest == Double.MIN_VALUE ? "greater than 0" : "at least " + shown(smallest))
                    : "from " + shown(smallest) + " to " + shown(largest);
            throw error("must be " + range + " but is " + shown(value));
        }
        return value;
    }

    private static String shown(double value) {
        return value == Math.rint(value) && Math.abs(value) < 1e15
                ? String.format(Locale.ROOT, "%.0f", value)
                : Double.toString(value);
    }

    /** The number, which must be whole and within bounds. */
    int integer(int smallest, int largest) throws GltfException {
        double value = between(smallest, largest);
        if (value != Math.rint(value)) {
            throw error("must be an integer but is " + value);
        }
        return (int) value;
    }

    /** The whole number of a member, within bounds. */
    int integer(String member, int otherwise, int smallest, int largest) throws GltfException {
        JsonValue found = find(member);
        return found == null ? otherwise : found.integer(smallest, largest);
    }

    /** An array of a fixed number of numbers. */
    double[] numbers(int length) throws GltfException {
        List<JsonValue> values = elements();
        if (values.size() != length) {
            throw error("must have " + length + " numbers but has " + values.size());
        }
        double[] out = new double[length];
        for (int i = 0; i < length; i++) {
            out[i] = values.get(i).number();
        }
        return out;
    }

    /** The numbers of a member. */
    double[] numbers(String member, double... otherwise) throws GltfException {
        JsonValue found = find(member);
        return found == null ? otherwise.clone() : found.numbers(otherwise.length);
    }

    /** The numbers of a member, each within bounds. */
    double[] numbersBetween(String member, double smallest, double largest, double... otherwise) throws GltfException {
        double[] values = numbers(member, otherwise);
        JsonValue found = find(member);
        if (found != null) {
            for (JsonValue element : found.elements()) {
                element.between(smallest, largest);
            }
        }
        return values;
    }
}
