package org.daybreak.scenes.mitsuba;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.function.UnaryOperator;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.jspecify.annotations.Nullable;

/** Changes the description of one object. Properties keep their order and places. */
final class ObjectEditor {
    private final ObjectDescription original;
    private final ProblemList problems;
    private String type;
    private List<PropertyDescription> properties;

    ObjectEditor(ObjectDescription original, ProblemList problems) {
        this.original = original;
        this.problems = problems;
        type = original.type();
        properties = new ArrayList<>(original.properties());
    }

    ObjectDescription result() {
        return new ObjectDescription(original.kind(), type, original.id(), original.location(), properties);
    }

    SourceLocation location() {
        return original.location();
    }

    String type() {
        return type;
    }

    void setType(String newType) {
        type = newType;
    }

    List<PropertyDescription> properties() {
        return properties;
    }

    /** Takes type and properties of another object. */
    void takeOver(ObjectDescription other) {
        type = other.type();
        properties = new ArrayList<>(other.properties());
    }

    void renameAll(UnaryOperator<String> renaming) {
        properties.replaceAll(p -> new PropertyDescription(renaming.apply(p.name()), p.value(), p.location()));
    }

    /** Renames a property if it is there. */
    void rename(String from, String to) {
        properties.replaceAll(p -> p.name().equals(from) ? new PropertyDescription(to, p.value(), p.location()) : p);
    }

    void remove(String... names) {
        properties.removeIf(p -> Arrays.asList(names).contains(p.name()));
    }

    /** Removes all other properties. */
    void retain(Set<String> names) {
        properties.removeIf(p -> !names.contains(p.name()) && !(p.value() instanceof Value.Nested));
    }

    /** Sets a property where it is, or at the place of the object. */
    void put(String name, Value value) {
        PropertyDescription old = find(name);
        PropertyDescription changed =
                new PropertyDescription(name, value, old == null ? original.location() : old.location());
        if (old == null) {
            properties.add(changed);
        } else {
            properties.replaceAll(p -> p.name().equals(name) ? changed : p);
        }
    }

    boolean has(String name) {
        return find(name) != null;
    }

    @Nullable
    PropertyDescription find(String name) {
        for (PropertyDescription p : properties) {
            if (p.name().equals(name)) {
                return p;
            }
        }
        return null;
    }

    double number(String name, double otherwise) {
        PropertyDescription p = find(name);
        if (p != null && p.value() instanceof Value.RealNumber r) {
            return r.value();
        }
        return p != null && p.value() instanceof Value.WholeNumber n ? n.value() : otherwise;
    }

    boolean isTrue(String name) {
        PropertyDescription p = find(name);
        return p != null && p.value() instanceof Value.Switch s && s.value();
    }

    @Nullable
    String text(String name) {
        PropertyDescription p = find(name);
        return p != null && p.value() instanceof Value.Text t ? t.value() : null;
    }

    /** The first nested object of a kind, or null. */
    @Nullable
    ObjectDescription nested(ObjectKind kind) {
        for (PropertyDescription p : properties) {
            if (p.value() instanceof Value.Nested n && n.object().kind() == kind) {
                return n.object();
            }
        }
        return null;
    }

    /** Warns at a property, or at the object if it is not there. */
    void warn(String name, String message) {
        PropertyDescription p = name.isEmpty() ? null : find(name);
        problems.warning(p == null ? original.location() : p.location(), message);
    }
}
