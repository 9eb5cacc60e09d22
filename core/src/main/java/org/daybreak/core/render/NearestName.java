package org.daybreak.core.render;

import java.util.Collection;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;

/** Finds the names most like a misspelt one, for error messages. */
public final class NearestName {
    private NearestName() {}

    /** Up to {@code count} known names nearest to the given one by edit distance, the nearest first. */
    public static List<String> of(String name, Collection<String> known, int count) {
        String lower = name.toLowerCase(Locale.ROOT);
        return known.stream()
                .sorted(Comparator.<String>comparingInt(k -> editDistance(lower, k.toLowerCase(Locale.ROOT)))
                        .thenComparing(Comparator.naturalOrder()))
                .limit(count)
                .toList();
    }

    /** A hint such as {@code "; did you mean 'path'?"}, followed by all names if they are few. */
    public static String hint(String name, Collection<String> known) {
        if (known.isEmpty()) {
            return "";
        }
        String nearest = of(name, known, 1).get(0);
        String hint = "; did you mean '" + nearest + "'?";
        return known.size() > 12 ? hint : hint + " (known: " + String.join(", ", known) + ")";
    }

    private static int editDistance(String a, String b) {
        int[] row = new int[b.length() + 1];
        for (int j = 0; j <= b.length(); j++) {
            row[j] = j;
        }
        for (int i = 1; i <= a.length(); i++) {
            int diagonal = row[0];
            row[0] = i;
            for (int j = 1; j <= b.length(); j++) {
                int substitution = diagonal + (a.charAt(i - 1) == b.charAt(j - 1) ? 0 : 1);
                diagonal = row[j];
                row[j] = Math.min(substitution, 1 + Math.min(row[j], row[j - 1]));
            }
        }
        return row[b.length()];
    }
}
