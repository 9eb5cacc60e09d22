package org.daybreak.scenes.mitsuba;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.SourceLocation;
import org.jspecify.annotations.Nullable;

/** Names that stand for texts in attributes: {@code $name}. What the caller defines goes before {@code <default>}. */
final class Definitions {
    /** Definitions may contain each other; without a limit a few lines could ask for all memory. */
    private static final int LONGEST_VALUE = 1 << 16;

    /** Characters of all attributes of a scene together that had definitions put in. */
    private static final long MOST_CHARACTERS = 1L << 24;

    private final Map<String, String> values;
    private final Set<String> unused;
    private final Set<String> defaults = new TreeSet<>();
    private int longestName;
    private long characters;

    Definitions(Map<String, String> defines) {
        for (String name : defines.keySet()) {
            longestName = Math.max(longestName, name.length());
        }
        values = new HashMap<>(defines);
        unused = new HashSet<>(defines.keySet());
    }

    /** Defines a name unless it is defined already. */
    void addDefault(String name, String value) {
        values.putIfAbsent(name, value);
        longestName = Math.max(longestName, name.length());
        defaults.add(name);
        unused.remove(name);
    }

    /** Names the caller defined but no attribute used, in order. */
    List<String> unused() {
        return new ArrayList<>(new TreeSet<>(unused));
    }

    /** Names the files have defaults for. */
    Set<String> defaults() {
        return defaults;
    }

    /**
     * Replaces all {@code $name}; the longest defined name goes. A backslash before the dollar keeps it.
     *
     * @return the text, or null after an error, which is reported
     */
    @Nullable
    String substitute(String text, SourceLocation location, ProblemList problems) {
        int dollar = text.indexOf('$');
        if (dollar < 0) {
            return text;
        }
        if (characters > MOST_CHARACTERS) {
            problems.error(
                    location,
                    "with their definitions put in, attributes have more than " + MOST_CHARACTERS
                            + " characters in all");
            return null;
        }
        StringBuilder result = new StringBuilder();
        boolean valid = true;
        int from = 0;
        while (dollar >= 0) {
            if (dollar > from && text.charAt(dollar - 1) == '\\') {
                result.append(text, from, dollar - 1).append('$');
                from = dollar + 1;
            } else {
                result.append(text, from, dollar);
                String word = word(text, dollar + 1);
                String name = longestDefined(word);
                if (name.isEmpty()) {
                    String shown = Numbers.shortened(word);
                    problems.unknownName(location, "'$" + shown + "' is not defined", shown, values.keySet());
                    valid = false;
                    from = dollar + 1 + word.length();
                } else {
                    unused.remove(name);
                    result.append(values.get(name));
                    from = dollar + 1 + name.length();
                }
            }
            if (result.length() > LONGEST_VALUE) {
                problems.error(
                        location,
                        "with its definitions put in, an attribute is longer than " + LONGEST_VALUE + " characters");
                return null;
            }
            dollar = text.indexOf('$', from);
        }
        result.append(text, from, text.length());
        characters += result.length();
        return valid ? result.toString() : null;
    }

    private static String word(String text, int from) {
        int to = from;
        while (to < text.length() && (Character.isLetterOrDigit(text.charAt(to)) || text.charAt(to) == '_')) {
            to++;
        }
        return text.substring(from, to);
    }

    private String longestDefined(String word) {
        for (int length = Math.min(longestName, word.length()); length > 0; length--) {
            String name = word.substring(0, length);
            if (values.containsKey(name)) {
                return name;
            }
        }
        return "";
    }
}
