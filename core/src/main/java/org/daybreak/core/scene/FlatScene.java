package org.daybreak.core.scene;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.math.Transform;

/**
 * A scene graph unrolled to two levels: what is placed once, and prototypes with the transforms of their instances. Emitting
 * shapes and lights inside instances are placed one by one, since every light needs its own identity.
 *
 * <p>A prototype that holds instances is unrolled in one of two ways, whichever takes less memory: its instances multiply
 * out, or their geometry is copied into it. A plant of a thousand leaves that stands in a forest ten thousand times is
 * thus one level of all its leaves with ten thousand instances, and not ten million instances of a leaf.
 */
final class FlatScene {
    /** Memory of a triangle in a level: vertices with attributes, indices and its share of the index. */
    private static final double PRIMITIVE_BYTES = 150;

    /** Memory of an instance, with its share of the index. */
    private static final double INSTANCE_BYTES = 400;

    /** More primitives than this are never copied into one level. */
    private static final double MOST_COPIED = 1 << 26;

    /** A shape with its transform to the coordinates of its level. */
    record PlacedShape(ShapeNode node, Transform toLevel) {}

    /** A light with its transform to world coordinates. */
    record PlacedLight(LightNode node, Transform toWorld) {}

    /** A prototype with the transform of one of its instances to world coordinates. */
    record PlacedPrototype(Prototype prototype, Transform toWorld) {}

    /** The content of a group that is instanced, in the coordinates outside the group. */
    static final class Prototype {
        final List<PlacedShape> shapes = new ArrayList<>();
        /** All geometry in one level, if that takes less memory than instances of instances; else this. */
        private Prototype geometry = this;
        /** Primitives with those of nested instances. */
        private double primitives;
        /** Instances of levels that one placement makes if nested ones multiply out. */
        private double levels;
        /** Placements in the scene if all instances multiply out. */
        private double placements;
        /** Whether it or what is nested in it emits. */
        private boolean emits;

        private final List<PlacedShape> emitters = new ArrayList<>();
        private final List<PlacedLight> lights = new ArrayList<>();
        private final List<PlacedPrototype> nested = new ArrayList<>();

        /** The comparison of the class comment. */
        private boolean isBetterCopied() {
            return levels > 1
                    && primitives <= MOST_COPIED
                    && primitives * PRIMITIVE_BYTES < (levels - 1) * placements * INSTANCE_BYTES;
        }
    }

    final List<PlacedShape> shapes = new ArrayList<>();
    final List<PlacedLight> lights = new ArrayList<>();
    final List<PlacedPrototype> instances = new ArrayList<>();

    private final IdentityHashMap<Group, Prototype> prototypes = new IdentityHashMap<>();
    /** All prototypes, nested ones before those that hold them. */
    private final List<Prototype> inOrder = new ArrayList<>();

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
        flat.count(all);
        for (Prototype prototype : flat.inOrder) {
            if (prototype != all && prototype.isBetterCopied()) {
                prototype.geometry = copied(prototype);
            }
        }
        flat.place(all, Transform.identity());
        return flat;
    }

    /** Fills in what the choice between copies and instances depends on. Nested prototypes come first in the list. */
    private void count(Prototype root) {
        for (Prototype p : inOrder) {
            p.levels = p.shapes.isEmpty() ? 0 : 1;
            p.emits = !p.emitters.isEmpty() || !p.lights.isEmpty();
            for (PlacedShape shape : p.shapes) {
                p.primitives += shape.node.shape() instanceof TriangleMesh mesh ? mesh.triangleCount() : 4;
            }
            for (PlacedPrototype nested : p.nested) {
                p.primitives += nested.prototype.primitives;
                p.levels += nested.prototype.levels;
                p.emits |= nested.prototype.emits;
            }
        }
        root.placements = 1;
        for (int i = inOrder.size() - 1; i >= 0; i--) {
            for (PlacedPrototype nested : inOrder.get(i).nested) {
                nested.prototype.placements += inOrder.get(i).placements;
            }
        }
    }

    private static Prototype copied(Prototype prototype) {
        Prototype copy = new Prototype();
        copyShapes(prototype, Transform.identity(), copy);
        return copy;
    }

    private static void copyShapes(Prototype from, Transform toLevel, Prototype to) {
        for (PlacedShape shape : from.shapes) {
            to.shapes.add(new PlacedShape(shape.node, toLevel.multiply(shape.toLevel)));
        }
        for (PlacedPrototype nested : from.nested) {
            copyShapes(nested.prototype, toLevel.multiply(nested.toWorld), to);
        }
    }

    /** Distinct prototypes that hold geometry, in the order of their first instance. */
    List<Prototype> usedPrototypes() {
        return instances.stream().map(PlacedPrototype::prototype).distinct().toList();
    }

    private void place(Prototype prototype, Transform toWorld) {
        placeOwnEmitters(prototype, toWorld);
        for (PlacedPrototype nested : prototype.nested) {
            Transform placed = toWorld.multiply(nested.toWorld);
            Prototype geometry = nested.prototype.geometry;
            if (!geometry.shapes.isEmpty()) {
                instances.add(new PlacedPrototype(geometry, placed));
            }
            if (geometry == nested.prototype) {
                place(nested.prototype, placed);
            } else if (nested.prototype.emits) {
                placeEmitters(nested.prototype, placed);
            }
        }
    }

    private void placeOwnEmitters(Prototype prototype, Transform toWorld) {
        for (PlacedShape emitter : prototype.emitters) {
            shapes.add(new PlacedShape(emitter.node, toWorld.multiply(emitter.toLevel)));
        }
        for (PlacedLight light : prototype.lights) {
            lights.add(new PlacedLight(light.node, toWorld.multiply(light.toWorld)));
        }
    }

    /** Places what emits in a prototype whose geometry is in one level. */
    private void placeEmitters(Prototype prototype, Transform toWorld) {
        placeOwnEmitters(prototype, toWorld);
        for (PlacedPrototype nested : prototype.nested) {
            if (nested.prototype.emits) {
                placeEmitters(nested.prototype, toWorld.multiply(nested.toWorld));
            }
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
        inOrder.add(result);
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
