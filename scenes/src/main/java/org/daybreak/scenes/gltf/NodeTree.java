package org.daybreak.scenes.gltf;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import javax.vecmath.Matrix4d;
import javax.vecmath.Quat4d;
import javax.vecmath.Vector3d;
import org.jspecify.annotations.Nullable;

/** The nodes of a document with their transforms to world coordinates. A node has at most one parent; there are no cycles. */
final class NodeTree {
    private final List<JsonValue> nodes;
    private final int[] parents;
    private final Matrix4d[] worlds;
    private final List<JsonValue> shown = new ArrayList<>();

    /**
     * Reads the nodes.
     *
     * @throws GltfException if they form no forest or a transform is wrong
     */
    NodeTree(Container container) throws GltfException {
        this.nodes = container.root().list("nodes");
        this.parents = new int[nodes.size()];
        this.worlds = new Matrix4d[nodes.size()];
        java.util.Arrays.fill(parents, -1);
        for (JsonValue node : nodes) {
            for (JsonValue reference : node.list("children")) {
                int child = container.resolve(reference, "nodes").index();
                if (parents[child] >= 0) {
                    throw reference.error("makes node " + child + " a child of node " + node.index()
                            + ", but it is one of node " + parents[child] + " already");
                }
                parents[child] = node.index();
            }
        }
        List<JsonValue> roots =
                nodes.stream().filter(n -> parents[n.index()] < 0).toList();
        visit(roots, container, null);
        for (JsonValue node : nodes) {
            if (worlds[node.index()] == null) {
                throw node.error("is its own ancestor");
            }
        }
        visit(sceneRoots(container, roots), container, shown);
    }

    private List<JsonValue> sceneRoots(Container container, List<JsonValue> roots) throws GltfException {
        JsonValue root = container.root();
        JsonValue chosen = container.resolve(root, "scene", "scenes");
        List<JsonValue> scenes = root.list("scenes");
        if (chosen == null && scenes.isEmpty()) {
            return roots;
        }
        List<JsonValue> list = new ArrayList<>();
        boolean[] listed = new boolean[nodes.size()];
        for (JsonValue reference : (chosen == null ? scenes.get(0) : chosen).list("nodes")) {
            JsonValue node = container.resolve(reference, "nodes");
            if (parents[node.index()] >= 0) {
                throw reference.error(
                        "must be a root but node " + node.index() + " is a child of node " + parents[node.index()]);
            }
            if (!listed[node.index()]) {
                listed[node.index()] = true;
                list.add(node);
            }
        }
        return list;
    }

    /** Visits trees from their roots down, children in order; computes transforms or lists the nodes. */
    private void visit(List<JsonValue> roots, Container container, @Nullable List<JsonValue> into)
            throws GltfException {
        Deque<JsonValue> open = new ArrayDeque<>();
        for (int i = roots.size() - 1; i >= 0; i--) {
            open.push(roots.get(i));
        }
        while (!open.isEmpty()) {
            JsonValue node = open.pop();
            if (into == null) {
                Matrix4d world = local(node);
                if (parents[node.index()] >= 0) {
                    world.mul(worlds[parents[node.index()]], world);
                }
                worlds[node.index()] = world;
            } else {
                into.add(node);
            }
            List<JsonValue> children = node.list("children");
            for (int i = children.size() - 1; i >= 0; i--) {
                open.push(container.resolve(children.get(i), "nodes"));
            }
        }
    }

    /** Transform to the parent's coordinates: the matrix, or translation · rotation · scale. */
    private static Matrix4d local(JsonValue node) throws GltfException {
        JsonValue given = node.find("matrix");
        if (given == null) {
            double[] t = node.numbers("translation", 0, 0, 0);
            double[] r = node.numbers("rotation", 0, 0, 0, 1);
            double[] s = node.numbers("scale", 1, 1, 1);
            if (r[0] * r[0] + r[1] * r[1] + r[2] * r[2] + r[3] * r[3] < 1e-12) {
                throw node.get("rotation").error("must be a unit quaternion but is 0");
            }
            return transform(t, r, s);
        }
        for (String name : new String[] {"translation", "rotation", "scale"}) {
            if (node.find(name) != null) {
                throw node.error("must not have both 'matrix' and '" + name + "'");
            }
        }
        double[] m = given.numbers(16);
        if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1) {
            throw given.error("must be affine: the numbers 4, 8, 12 and 16 are 0, 0, 0 and 1");
        }
        return new Matrix4d(
                m[0], m[4], m[8], m[12], m[1], m[5], m[9], m[13], m[2], m[6], m[10], m[14], m[3], m[7], m[11], m[15]);
    }

    /**
     * Translation · rotation · scale.
     *
     * @param r quaternion x, y, z, w; need not be of length 1
     */
    static Matrix4d transform(double[] t, double[] r, double[] s) {
        Quat4d rotation = new Quat4d(r[0], r[1], r[2], r[3]);
        rotation.normalize();
        Matrix4d m = new Matrix4d(rotation, new Vector3d(t[0], t[1], t[2]), 1);
        m.m00 *= s[0];
        m.m10 *= s[0];
        m.m20 *= s[0];
        m.m01 *= s[1];
        m.m11 *= s[1];
        m.m21 *= s[1];
        m.m02 *= s[2];
        m.m12 *= s[2];
        m.m22 *= s[2];
        return m;
    }

    /** The nodes of the scene, parents before children. */
    List<JsonValue> shown() {
        return shown;
    }

    /** A copy of a node's transform to world coordinates. */
    Matrix4d world(JsonValue node) {
        return new Matrix4d(worlds[node.index()]);
    }
}
