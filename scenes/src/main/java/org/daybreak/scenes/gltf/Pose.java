package org.daybreak.scenes.gltf;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import javax.vecmath.Matrix4d;
import org.jspecify.annotations.Nullable;

/**
 * A skin with its joints where the nodes put them. The matrix of a vertex is the mean of {@code world(joint) · inverseBind(joint)}
 * by its weights (glTF 2.0 specification, 3.7.3); it leads to world coordinates, the transform of the mesh's own node does not
 * count.
 */
final class Pose {
    private static final Set<Accessor.Component> JOINTS =
            EnumSet.of(Accessor.Component.UNSIGNED_BYTE, Accessor.Component.UNSIGNED_SHORT);
    private static final Set<Accessor.Component> WEIGHTS =
            EnumSet.of(Accessor.Component.FLOAT, Accessor.Component.UNSIGNED_BYTE, Accessor.Component.UNSIGNED_SHORT);

    private final Container container;
    private final Buffers buffers;
    private final Matrix4d[] joints;

    Pose(JsonValue skin, NodeTree nodes, Container container, Buffers buffers) throws GltfException {
        this.container = container;
        this.buffers = buffers;
        List<JsonValue> references = skin.get("joints").elements();
        if (references.isEmpty()) {
            throw skin.get("joints").error("must not be empty");
        }
        JsonValue bind = skin.find("inverseBindMatrices");
        Accessor inverse = bind == null
                ? null
                : Accessor.of(bind, container, buffers)
                        .requireType(bind, "MAT4")
                        .requireComponent(bind, EnumSet.of(Accessor.Component.FLOAT));
        if (bind != null && inverse != null && inverse.count() < references.size()) {
            throw bind.error(
                    "leads to " + inverse.count() + " matrices but there are " + references.size() + " joints");
        }
        this.joints = new Matrix4d[references.size()];
        for (int j = 0; j < joints.length; j++) {
            joints[j] = nodes.world(container.resolve(references.get(j), "nodes"));
            if (inverse != null) {
                joints[j].mul(matrix(inverse, j));
            }
        }
    }

    private static Matrix4d matrix(Accessor accessor, int element) throws GltfException {
        Matrix4d m = new Matrix4d();
        for (int i = 0; i < 16; i++) {
            // Accessors hold matrices column by column.
            m.setElement(i % 4, i / 4, accessor.value(element, i));
        }
        return m;
    }

    /** Influences of joints on vertices: one pair of attributes, four joints per vertex. */
    private record Influences(JsonValue reference, Accessor joints, Accessor weights) {}

    private List<Influences> influences(JsonValue attributes, int vertexCount) throws GltfException {
        List<Influences> all = new ArrayList<>();
        for (int set = 0; ; set++) {
            JsonValue joint = attributes.find("JOINTS_" + set);
            if (joint == null) {
                break;
            }
            JsonValue weight = attributes.get("WEIGHTS_" + set);
            Accessor jointAccessor = Accessor.of(joint, container, buffers)
                    .requireType(joint, "VEC4")
                    .requireComponent(joint, JOINTS);
            Accessor weightAccessor = Accessor.of(weight, container, buffers)
                    .requireType(weight, "VEC4")
                    .requireComponent(weight, WEIGHTS)
                    .requireFloatOrNormalized(weight);
            if (jointAccessor.count() != vertexCount || weightAccessor.count() != vertexCount) {
                throw joint.error("leads to " + jointAccessor.count() + " joints and " + weightAccessor.count()
                        + " weights but there are " + vertexCount + " positions");
            }
            all.add(new Influences(joint, jointAccessor, weightAccessor));
        }
        if (all.isEmpty()) {
            throw attributes.error("needs the property 'JOINTS_0', as the mesh has a skin");
        }
        return all;
    }

    /**
     * Brings a primitive into the pose.
     *
     * @param vertices numbers of the geometry's vertices in the buffers
     * @param attributes attributes of the primitive
     * @param vertexCount vertices in the buffers
     */
    Geometry apply(Geometry geometry, int[] vertices, JsonValue attributes, int vertexCount) throws GltfException {
        List<Influences> influences = influences(attributes, vertexCount);
        float[] positions = geometry.positions().clone();
        float[] normals = copy(geometry.normals());
        float[] tangents = copy(geometry.tangents());
        Matrix4d m = new Matrix4d();
        for (int i = 0; i < vertices.length; i++) {
            blend(influences, vertices[i], m);
            transformPoint(m, positions, 3 * i);
            if (normals != null) {
                transformNormal(m, normals, 3 * i);
            }
            if (tangents != null) {
                transformDirection(m, tangents, 4 * i);
            }
        }
        return new Geometry(
                positions, geometry.triangles(), normals, tangents, geometry.uv0(), geometry.uv1(), geometry.colors());
    }

    private static float @Nullable [] copy(float @Nullable [] values) {
        return values == null ? null : values.clone();
    }

    private void blend(List<Influences> influences, int vertex, Matrix4d out) throws GltfException {
        double sum = 0;
        out.setZero();
        for (Influences four : influences) {
            for (int c = 0; c < 4; c++) {
                double weight = four.weights.value(vertex, c);
                long joint = four.joints.unsigned(vertex, c);
                if (joint >= joints.length) {
                    throw four.reference.error("leads to joint " + joint + " at vertex " + vertex + " but the skin has "
                            + joints.length + " joints");
                }
                if (weight != 0) {
                    addScaled(joints[(int) joint], weight, out);
                    sum += weight;
                }
            }
        }
        if (sum > 0) {
            // Stored weights are rounded; the matrix must stay affine.
            out.mul(1 / sum);
        } else {
            out.set(joints[(int) influences.get(0).joints.unsigned(vertex, 0)]);
        }
    }

    private static void addScaled(Matrix4d m, double weight, Matrix4d sum) {
        Matrix4d scaled = new Matrix4d(m);
        scaled.mul(weight);
        sum.add(scaled);
    }

    private static void transformPoint(Matrix4d m, float[] v, int at) {
        double x = v[at];
        double y = v[at + 1];
        double z = v[at + 2];
        v[at] = (float) (m.m00 * x + m.m01 * y + m.m02 * z + m.m03);
        v[at + 1] = (float) (m.m10 * x + m.m11 * y + m.m12 * z + m.m13);
        v[at + 2] = (float) (m.m20 * x + m.m21 * y + m.m22 * z + m.m23);
    }

    private static void transformDirection(Matrix4d m, float[] v, int at) {
        double x = v[at];
        double y = v[at + 1];
        double z = v[at + 2];
        v[at] = (float) (m.m00 * x + m.m01 * y + m.m02 * z);
        v[at + 1] = (float) (m.m10 * x + m.m11 * y + m.m12 * z);
        v[at + 2] = (float) (m.m20 * x + m.m21 * y + m.m22 * z);
    }

    /** Multiplies by the cofactors: as cross products of edges change, so that mirroring turns normals with the winding. */
    private static void transformNormal(Matrix4d m, float[] v, int at) {
        double x = v[at];
        double y = v[at + 1];
        double z = v[at + 2];
        double nx = (m.m11 * m.m22 - m.m12 * m.m21) * x
                + (m.m12 * m.m20 - m.m10 * m.m22) * y
                + (m.m10 * m.m21 - m.m11 * m.m20) * z;
        double ny = (m.m02 * m.m21 - m.m01 * m.m22) * x
                + (m.m00 * m.m22 - m.m02 * m.m20) * y
                + (m.m01 * m.m20 - m.m00 * m.m21) * z;
        double nz = (m.m01 * m.m12 - m.m02 * m.m11) * x
                + (m.m02 * m.m10 - m.m00 * m.m12) * y
                + (m.m00 * m.m11 - m.m01 * m.m10) * z;
        // Cofactors are products of two lengths; unit vectors do not run out of the range of floats.
        double length = Math.sqrt(nx * nx + ny * ny + nz * nz);
        double scale = length > 0 ? 1 / length : 0;
        v[at] = (float) (nx * scale);
        v[at + 1] = (float) (ny * scale);
        v[at + 2] = (float) (nz * scale);
    }
}
