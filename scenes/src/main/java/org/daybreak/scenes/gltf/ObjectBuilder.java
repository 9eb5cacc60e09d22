package org.daybreak.scenes.gltf;

import java.util.ArrayList;
import java.util.List;
import javax.vecmath.Matrix4d;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.jspecify.annotations.Nullable;

/** Gathers the properties of an object, all of which come from one place in the file. */
final class ObjectBuilder {
    private final ObjectKind kind;
    private final String type;
    private final SourceLocation location;
    private final List<PropertyDescription> properties = new ArrayList<>();

    ObjectBuilder(ObjectKind kind, String type, SourceLocation location) {
        this.kind = kind;
        this.type = type;
        this.location = location;
    }

    ObjectBuilder value(String name, Value value) {
        properties.add(new PropertyDescription(name, value, location));
        return this;
    }

    ObjectBuilder number(String name, double value) {
        return value(name, new Value.RealNumber(value));
    }

    ObjectBuilder integer(String name, long value) {
        return value(name, new Value.WholeNumber(value));
    }

    ObjectBuilder truth(String name, boolean value) {
        return value(name, new Value.Switch(value));
    }

    ObjectBuilder text(String name, String value) {
        return value(name, new Value.Text(value));
    }

    ObjectBuilder transform(String name, Matrix4d value) {
        return value(name, new Value.Transform(value));
    }

    /** Adds an object without a name if there is one. */
    ObjectBuilder nested(@Nullable ObjectDescription object) {
        return object == null ? this : value("", new Value.Nested(object));
    }

    ObjectDescription build() {
        return new ObjectDescription(kind, type, null, location, properties);
    }
}
