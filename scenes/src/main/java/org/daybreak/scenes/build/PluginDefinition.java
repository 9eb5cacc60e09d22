package org.daybreak.scenes.build;

import java.util.List;
import org.daybreak.scenes.description.ObjectKind;

/**
 * A type of object that scene files may contain, with its properties. Checks, messages and documentation derive from it.
 *
 * @param kind kind of object
 * @param type name of the type in files
 * @param doc what it is
 * @param properties its properties
 */
public record PluginDefinition(ObjectKind kind, String type, String doc, List<PropertyDefinition> properties) {
    /** Copies the properties. */
    public PluginDefinition {
        properties = List.copyOf(properties);
    }
}
