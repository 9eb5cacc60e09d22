package org.daybreak.scenes.write;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Set;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SceneDescription;
import org.daybreak.scenes.description.Value;
import org.jspecify.annotations.Nullable;

/**
 * Which objects of a scene are used in several places, and the names under which they are. Readers share an object by a
 * reference or by being the same one.
 */
final class ObjectNames {
    private final SceneDescription description;
    private final IdentityHashMap<ObjectDescription, Integer> uses = new IdentityHashMap<>();
    private final Set<ObjectDescription> inScene = Collections.newSetFromMap(new IdentityHashMap<>());
    private final List<ObjectDescription> contained = new ArrayList<>();
    private final IdentityHashMap<ObjectDescription, String> ids = new IdentityHashMap<>();
    private final Set<String> taken = new HashSet<>();

    ObjectNames(SceneDescription description) {
        this.description = description;
        for (PropertyDescription property : description.root().properties()) {
            ObjectDescription object = object(property.value());
            if (object != null) {
                inScene.add(object);
            }
        }
        count(description.root());
    }

    private void count(ObjectDescription owner) {
        for (PropertyDescription property : owner.properties()) {
            ObjectDescription object = object(property.value());
            if (object != null && uses.merge(object, 1, Integer::sum) == 1) {
                count(object);
                if (!inScene.contains(object)) {
                    contained.add(object);
                }
            }
        }
    }

    /** The object that a value is or names; null for any other value. */
    @Nullable
    ObjectDescription object(Value value) {
        if (value instanceof Value.Nested nested) {
            return nested.object();
        }
        return value instanceof Value.Reference reference ? description.ids().get(reference.id()) : null;
    }

    /** Whether an object is written once, directly in the scene, and referred to from elsewhere. */
    boolean isShared(ObjectDescription object) {
        boolean definition = object.kind() == ObjectKind.BSDF
                || object.kind() == ObjectKind.TEXTURE
                || (object.kind() == ObjectKind.EMITTER && object.type().equals("area"))
                || (object.kind() == ObjectKind.SHAPE && object.type().equals("shapegroup"));
        return definition && uses.getOrDefault(object, 0) > 1;
    }

    /** The shared objects that do not stand directly in the scene, each after those that it contains. */
    List<ObjectDescription> definitions() {
        return contained.stream().filter(this::isShared).toList();
    }

    /** The unique name of an object: its own if that can be, else one made up if it is shared, else null. */
    @Nullable
    String id(ObjectDescription object) {
        String known = ids.get(object);
        if (known != null) {
            return known;
        }
        String own = object.id() == null ? "" : legal(object.id());
        if (own.isEmpty() && !isShared(object)) {
            return null;
        }
        String base = own.isEmpty() ? object.type() : own;
        String id = base;
        for (int i = 2; !taken.add(id); i++) {
            id = base + "_" + i;
        }
        ids.put(object, id);
        return id;
    }

    /** Names from other formats can hold characters that XML has no way to write. */
    private static String legal(String id) {
        return id.codePoints()
                .map(c -> (c >= ' ' && c < 0xd800) || (c >= 0xe000 && c <= 0xfffd) || c > 0xffff ? c : '_')
                .collect(StringBuilder::new, StringBuilder::appendCodePoint, StringBuilder::append)
                .toString();
    }
}
