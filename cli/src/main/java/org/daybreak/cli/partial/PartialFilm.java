package org.daybreak.cli.partial;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import org.daybreak.core.render.RenderPart;
import org.daybreak.core.render.RenderState;

/**
 * The state of a render together with what it is a render of. Immutable.
 *
 * @param identity everything that the bits of the image depend on, by names that are meant for users, see {@link
 *     RenderIdentity}
 * @param part which part of the work it is
 * @param state the state
 */
public record PartialFilm(Map<String, String> identity, RenderPart part, RenderState state) {
    /** Copies the map. */
    public PartialFilm {
        identity = Collections.unmodifiableMap(new LinkedHashMap<>(identity));
    }

    /**
     * The first difference between this render and another one, in words; empty if they are the same.
     *
     * @param other the identity that is expected
     * @param owner what the expected one is: {@code "this render"}
     */
    public Optional<String> difference(Map<String, String> other, String owner) {
        for (Map.Entry<String, String> entry : other.entrySet()) {
            String own = identity.get(entry.getKey());
            if (own == null) {
                return Optional.of("it does not say its " + entry.getKey());
            }
            if (!own.equals(entry.getValue())) {
                return Optional.of("its " + entry.getKey() + " is " + shortened(own) + ", that of " + owner + " is "
                        + shortened(entry.getValue()));
            }
        }
        return Optional.empty();
    }

    private static String shortened(String value) {
        boolean digest =
                value.length() == RenderIdentity.DIGEST_LENGTH && value.chars().allMatch(PartialFilm::isHex);
        return digest ? value.substring(0, 12) : "'" + value + "'";
    }

    private static boolean isHex(int c) {
        return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
    }
}
