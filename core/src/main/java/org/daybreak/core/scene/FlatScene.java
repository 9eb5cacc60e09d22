package org.daybreak.core.scene;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import org.daybreak.core.math.Transform;

/**
 * A scene graph unrolled to two levels: what is placed once, and prototypes with the transforms of their instances. Nested
 * instances multiply out; emitting shapes and lights inside instances are placed one by one, since every light needs
 * its own identity.
 */
final class FlatScene {
    /** A shape with its transform to the coordinates of its level. */
    record PlacedShape(ShapeNode node, Transform toLevel) {}

    /** A light with its transform to world coordinates. */
    record PlacedLight(LightNode node, Transform toWorld) {}

    /** A prototype with the transform of one of its instances to world coordinates. */
    record PlacedPrototype(Prototype prototype, Transform toWorld) {}

    /** The content of a group that is instanced, in the coordinates outside the group. */
    static final class Prototype {
        final List<PlacedShape> shapes = new ArrayList<>();
        private final List<PlacedShape> emitters = new ArrayList<>();
        private final List<PlacedLight> lights = new ArrayList<>();
        private final List<PlacedPrototype> nested = new ArrayList<>();
    }

    final List<PlacedShape> shapes = new ArrayList<>();
    final List<PlacedLight> lights = new ArrayList<>();
    final List<PlacedPrototype> instances = new ArrayList<>();

    private final IdentityHashMap<Group, Prototype> prototypes = new IdentityHashMap<>();
    private final IdentityHashMap<Group, Boolean> open = new IdentityHashMap<>();

    private FlatScene() {}

    /**
     * Unrolls a graph.
     *
     * @throws IllegalArgumentException if a group contains itself or a transform is singular or not finite
     */
    static FlatScene of(Group root) {
        FlatScene flat = new FlatScene();
        Prototype all = flat.prototype(root);
        flat.shapes.addAll(all.shapes);
        flat.place(all, Transform.identity());
        return flat;
    }

    /** Distinct prototypes that hold geometry, in the order of their first instance. */
    List<Prototype> usedPrototypes() {
        return instances.stream().map(PlacedPrototype::prototype).distinct().toList();
    }

    private void place(Prototype prototype, Transform toWorld) {
        for (PlacedShape emitter : prototype.emitters) {
            shapes.add(new PlacedShape(emitter.node, toWorld.multiply(emitter.toLevel)));
        }
        for (PlacedLight light : prototype.lights) {
            lights.add(new PlacedLight(light.node, toWorld.multiply(light.toWorld)));
        }
        for (PlacedPrototype nested : prototype.nested) {
            Transform placed = toWorld.multiply(nested.toWorld);
            if (!nested.prototype.shapes.isEmpty()) {
                instances.add(new PlacedPrototype(nested.prototype, placed));
            }
            place(nested.prototype, placed);
        }
    }

    private Prototype prototype(Group group) {
        Prototype known = prototypes.get(group);
        if (known != null) {
            return known;
        }
        if (open.put(group, Boolean.TRUE) != null) {
            throw new IllegalArgumentException(describe(group) + " contains itself through an instance");
        }
        Prototype result = new Prototype();
        collect(group, Transform.identity(), result);
        open.remove(group);
        prototypes.put(group, result);
        return result;
    }

    private void collect(Group group, Transform outer, Prototype into) {
        Transform transform = outer.multiply(transformOf(group));
        for (Node child : group.children()) {
            if (child instanceof Group inner) {
                if (open.put(inner, Boolean.TRUE) != null) {
                    throw new IllegalArgumentException(describe(inner) + " contains itself");
                }
                collect(inner, transform, into);
                open.remove(inner);
            } else if (child instanceof Instance instance) {
                into.nested.add(new PlacedPrototype(
                        prototype(instance.prototype()), transform.multiply(transformOf(instance))));
            } else if (child instanceof ShapeNode shape) {
                PlacedShape placed = new PlacedShape(shape, transform.multiply(transformOf(shape)));
                (shape.radiance() == null ? into.shapes : into.emitters).add(placed);
            } else if (child instanceof LightNode light) {
                into.lights.add(new PlacedLight(light, transform.multiply(transformOf(light))));
            }
        }
    }

    private static Transform transformOf(Node node) {
        try {
            return Transform.of(node.transform());
        } catch (IllegalArgumentException e) {
            throw new IllegalArgumentException(describe(node) + ": " + e.getMessage(), e);
        }
    }

    private static String describe(Node node) {
        String kind = node.getClass().getSimpleName();
        return node.name() == null ? "an unnamed " + kind : kind + " '" + node.name() + "'";
    }
}
