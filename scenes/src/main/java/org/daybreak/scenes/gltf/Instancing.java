package org.daybreak.scenes.gltf;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import javax.vecmath.Matrix4d;
import org.jspecify.annotations.Nullable;

/** EXT_mesh_gpu_instancing: a node that shows its mesh many times. */
final class Instancing {
    static final String EXTENSION = "EXT_mesh_gpu_instancing";

    /** Bounds the memory of the scene. */
    private static final int MOST_INSTANCES = 1 << 26;

    private static final Set<Accessor.Component> FLOATS = EnumSet.of(Accessor.Component.FLOAT);
    private static final Set<Accessor.Component> ROTATIONS =
            EnumSet.of(Accessor.Component.FLOAT, Accessor.Component.BYTE, Accessor.Component.SHORT);

    private final Container container;
    private final Buffers buffers;
    private long instances;

    Instancing(Container container, Buffers buffers) {
        this.container = container;
        this.buffers = buffers;
    }

    /** Where a node shows its mesh, in world coordinates. */
    List<Matrix4d> transforms(JsonValue node, Matrix4d world) throws GltfException {
        JsonValue extension = node.extension(EXTENSION);
        if (extension == null) {
            return List.of(world);
        }
        JsonValue attributes = extension.get("attributes");
        Accessor translations = accessor(attributes, "TRANSLATION", "VEC3", FLOATS);
        Accessor rotations = accessor(attributes, "ROTATION", "VEC4", ROTATIONS);
        Accessor scales = accessor(attributes, "SCALE", "VEC3", FLOATS);
        int count = -1;
        for (Accessor a : new Accessor[] {translations, rotations, scales}) {
            if (a != null && count >= 0 && a.count() != count) {
                throw attributes.error("must have as many elements each but have " + count + " and " + a.count());
            }
            count = a == null ? count : a.count();
        }
        instances += Math.max(0, count);
        if (instances > Math.min(MOST_INSTANCES, buffers.mostElements())) {
            throw attributes.error("make more instances than a file of this size may have");
        }
        List<Matrix4d> all = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            double[] r = numbers(rotations, i, 0, 0, 0, 1);
            if (r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3] < 1e-12) {
                throw attributes.get("ROTATION").error("leads to a quaternion of length 0 at element " + i);
            }
            Matrix4d m = NodeTree.transform(numbers(translations, i, 0, 0, 0), r, numbers(scales, i, 1, 1, 1));
            m.mul(world, m);
            all.add(m);
        }
        return all;
    }

    private @Nullable Accessor accessor(JsonValue attributes, String name, String type, Set<Accessor.Component> kinds)
            throws GltfException {
        JsonValue reference = attributes.find(name);
        return reference == null
                ? null
                : Accessor.of(reference, container, buffers)
                        .requireType(reference, type)
                        .requireComponent(reference, kinds)
                        .requireFloatOrNormalized(reference);
    }

    private static double[] numbers(@Nullable Accessor accessor, int element, double... otherwise)
            throws GltfException {
        double[] out = otherwise.clone();
        if (accessor != null) {
            for (int c = 0; c < out.length; c++) {
                out[c] = accessor.value(element, c);
            }
        }
        return out;
    }
}
