package org.daybreak.scenes.mitsuba;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import org.daybreak.scenes.description.ObjectKind;

/** The names of elements. */
final class Elements {
    /** Those that can be read, for messages. */
    static final Set<String> KNOWN = Collections.unmodifiableSet(elements());

    /** Elements of Mitsuba that stand for what cannot be rendered. */
    static final Map<String, String> UNSUPPORTED = Map.of(
            "medium", "participating media",
            "phase", "participating media",
            "volume", "participating media",
            "subsurface", "subsurface scattering models",
            "animation", "moving objects");

    private Elements() {}

    private static Set<String> elements() {
        TreeSet<String> names = new TreeSet<>(List.of(
                "boolean",
                "integer",
                "float",
                "string",
                "point",
                "vector",
                "rgb",
                "srgb",
                "spectrum",
                "blackbody",
                "transform",
                "ref",
                "include",
                "default",
                "alias",
                "path"));
        for (ObjectKind kind : ObjectKind.values()) {
            if (kind != ObjectKind.SCENE) {
                names.add(kind.element());
            }
        }
        return names;
    }
}
