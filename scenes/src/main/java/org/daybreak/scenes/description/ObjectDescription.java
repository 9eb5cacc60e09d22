package org.daybreak.scenes.description;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * An object of a scene file with its properties in the order of the file. Immutable.
 *
 * @param kind what it is
 * @param type name of its type ("plugin") within the kind
 * @param id name other objects refer to it by, or null
 * @param location its start tag
 * @param properties its properties, nested objects included
 */
public record ObjectDescription(
        ObjectKind kind,
        String type,
        @Nullable String id,
        SourceLocation location,
        List<PropertyDescription> properties) {
    /** Copies the properties. */
    public ObjectDescription {
        properties = List.copyOf(properties);
    }

    /** How messages name it: {@code <bsdf type="diffuse">}. */
    public String label() {
        return kind == ObjectKind.SCENE ? "<scene>" : "<" + kind.element() + " type=\"" + type + "\">";
    }
}
