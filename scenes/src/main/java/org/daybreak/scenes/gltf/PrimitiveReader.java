package org.daybreak.scenes.gltf;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;

/**
 * Decodes mesh primitives: indices, attributes, morph targets at given weights, skins. Only vertices that a primitive uses are
 * kept, as several primitives often share long attribute arrays.
 */
final class PrimitiveReader {
    private static final Set<Accessor.Component> INDICES = EnumSet.of(
            Accessor.Component.UNSIGNED_BYTE, Accessor.Component.UNSIGNED_SHORT, Accessor.Component.UNSIGNED_INT);

    /** Core types and those of KHR_mesh_quantization. */
    private static final Set<Accessor.Component> NUMBERS =
            EnumSet.complementOf(EnumSet.of(Accessor.Component.UNSIGNED_INT));

    private static final Set<Accessor.Component> DIRECTIONS =
            EnumSet.of(Accessor.Component.FLOAT, Accessor.Component.BYTE, Accessor.Component.SHORT);

    private final Container container;
    private final Buffers buffers;
    private final Report report;
    private final Map<String, Geometry> known = new HashMap<>();
    private long work;

    PrimitiveReader(Container container, Buffers buffers, Report report) {
        this.container = container;
        this.buffers = buffers;
        this.report = report;
    }

    /** The primitive that is read, with what its attributes have in common. */
    private record Source(JsonValue primitive, JsonValue attributes, int vertexCount, List<Target> targets) {}

    /** A morph target with its weight, which is not 0. */
    private record Target(JsonValue attributes, double weight) {}

    /**
     * Decodes a primitive.
     *
     * @param weights weights of the morph targets
     * @param pose where the joints are, null if the mesh has no skin
     * @return null if the primitive has no triangles, about which there is a warning
     * @throws GltfException if it breaks the rules of the format
     */
    @Nullable
    Geometry read(JsonValue primitive, double[] weights, @Nullable Pose pose) throws GltfException {
        int mode = primitive.integer("mode", Triangulation.TRIANGLES, 0, 6);
        if (mode < Triangulation.TRIANGLES) {
            report.warning(primitive, "is left out: points and lines have no surface");
            return null;
        }
        JsonValue attributes = primitive.get("attributes");
        JsonValue position = attributes.find("POSITION");
        if (position == null) {
            report.warning(primitive, "is left out: it has no positions");
            return null;
        }
        List<Target> targets = targets(primitive, weights);
        String key = pose == null ? key(mode, primitive, attributes, targets) : "";
        Geometry shared = known.get(key);
        if (shared != null) {
            return shared;
        }
        Accessor positions = Accessor.of(position, container, buffers);
        Source source = new Source(primitive, attributes, positions.count(), targets);
        int[] corners = corners(source);
        int leftOver = Triangulation.leftOver(mode, corners.length);
        if (leftOver > 0) {
            report.warning(primitive, "has corners that make no whole triangle: " + leftOver);
        }
        int[] triangles = Triangulation.triangles(mode, corners);
        if (triangles.length == 0) {
            return null;
        }
        int[] vertices = compact(triangles, source);
        Geometry geometry = decode(source, vertices, triangles);
        if (pose == null) {
            known.put(key, geometry);
            return geometry;
        }
        return pose.apply(geometry, vertices, attributes, source.vertexCount);
    }

    /** What the result depends on. */
    private static String key(int mode, JsonValue primitive, JsonValue attributes, List<Target> targets)
            throws GltfException {
        StringBuilder text = new StringBuilder().append(mode);
        JsonValue indices = primitive.find("indices");
        text.append(' ').append(indices == null ? -1 : indices.number());
        append(text, attributes);
        for (Target target : targets) {
            text.append(' ').append(target.weight);
            append(text, target.attributes);
        }
        return text.toString();
    }

    private static void append(StringBuilder text, JsonValue attributes) throws GltfException {
        for (Map.Entry<String, JsonValue> e : new TreeMap<>(attributes.members()).entrySet()) {
            text.append(' ').append(e.getKey()).append('=').append(e.getValue().number());
        }
    }

    private static List<Target> targets(JsonValue primitive, double[] weights) throws GltfException {
        List<Target> targets = new ArrayList<>();
        List<JsonValue> all = primitive.list("targets");
        if (weights.length != 0 && weights.length != all.size()) {
            throw primitive.error("has " + all.size() + " morph targets but there are " + weights.length + " weights");
        }
        for (int i = 0; i < weights.length; i++) {
            if (weights[i] != 0) {
                targets.add(new Target(all.get(i), weights[i]));
            }
        }
        return targets;
    }

    private int[] corners(Source source) throws GltfException {
        JsonValue reference = source.primitive.find("indices");
        if (reference == null) {
            charge(source.primitive, source.vertexCount);
            int[] corners = new int[source.vertexCount];
            for (int i = 0; i < corners.length; i++) {
                corners[i] = i;
            }
            return corners;
        }
        Accessor indices = Accessor.of(reference, container, buffers)
                .requireType(reference, "SCALAR")
                .requireComponent(reference, INDICES);
        charge(source.primitive, indices.count());
        int[] corners = new int[indices.count()];
        for (int i = 0; i < corners.length; i++) {
            long index = indices.unsigned(i, 0);
            if (index >= source.vertexCount) {
                throw reference.error("leads to index " + index + " at position " + i + " but there are "
                        + source.vertexCount + " vertices");
            }
            corners[i] = (int) index;
        }
        return corners;
    }

    private void charge(JsonValue primitive, long amount) throws GltfException {
        work += amount;
        if (work > buffers.mostElements()) {
            throw primitive.error("is one too many: the meshes have more corners and vertices together than a file of"
                    + " this size may have");
        }
    }

    /** Numbers the used vertices anew, in the order in which they stand in the buffers. Returns their old numbers. */
    private int[] compact(int[] triangles, Source source) throws GltfException {
        int lowest = Integer.MAX_VALUE;
        int highest = 0;
        for (int vertex : triangles) {
            lowest = Math.min(lowest, vertex);
            highest = Math.max(highest, vertex);
        }
        charge(source.primitive, highest - lowest + 1L);
        int[] numbers = new int[highest - lowest + 1];
        for (int vertex : triangles) {
            numbers[vertex - lowest] = 1;
        }
        int used = 0;
        for (int i = 0; i < numbers.length; i++) {
            used += numbers[i];
            numbers[i] = numbers[i] == 0 ? -1 : used - 1;
        }
        int[] vertices = new int[used];
        for (int i = 0; i < numbers.length; i++) {
            if (numbers[i] >= 0) {
                vertices[numbers[i]] = lowest + i;
            }
        }
        for (int i = 0; i < triangles.length; i++) {
            triangles[i] = numbers[triangles[i] - lowest];
        }
        return vertices;
    }

    private Geometry decode(Source source, int[] vertices, int[] triangles) throws GltfException {
        float[] positions = attribute(source, "POSITION", vertices, NUMBERS, 3, 3, "VEC3");
        if (positions == null) {
            throw source.attributes.error("needs the property 'POSITION'");
        }
        float[] normals = attribute(source, "NORMAL", vertices, DIRECTIONS, 3, 3, "VEC3");
        // Without normals triangles are flat and tangents do not count (specification, 3.7.2.1).
        float[] tangents = normals == null ? null : attribute(source, "TANGENT", vertices, DIRECTIONS, 4, 3, "VEC4");
        float[] colors = attribute(source, "COLOR_0", vertices, NUMBERS, 4, 4, "VEC3", "VEC4");
        if (colors != null) {
            for (int i = 0; i < colors.length; i++) {
                colors[i] = Math.min(1, Math.max(0, colors[i]));
            }
        }
        return new Geometry(
                positions,
                triangles,
                normals,
                tangents,
                attribute(source, "TEXCOORD_0", vertices, NUMBERS, 2, 2, "VEC2"),
                attribute(source, "TEXCOORD_1", vertices, NUMBERS, 2, 2, "VEC2"),
                colors);
    }

    /**
     * Decodes an attribute and adds what the morph targets say.
     *
     * @param width numbers per vertex to return; missing ones are 1
     * @param morphed how many of them morph targets change
     * @return null if the primitive does not have the attribute
     */
    private float @Nullable [] attribute(
            Source source,
            String name,
            int[] vertices,
            Set<Accessor.Component> components,
            int width,
            int morphed,
            String... types)
            throws GltfException {
        JsonValue reference = source.attributes.find(name);
        if (reference == null) {
            return null;
        }
        Accessor accessor = accessor(source, reference, components).requireType(reference, types);
        if (name.startsWith("COLOR")) {
            accessor.requireFloatOrNormalized(reference);
        }
        float[] out = new float[Math.multiplyExact(width, vertices.length)];
        int given = Math.min(width, accessor.width());
        for (int i = 0; i < vertices.length; i++) {
            for (int c = 0; c < width; c++) {
                out[width * i + c] = c < given ? accessor.value(vertices[i], c) : 1;
            }
        }
        for (Target target : source.targets) {
            JsonValue change = target.attributes.find(name);
            if (change != null) {
                add(
                        out,
                        width,
                        accessor(source, change, components),
                        Math.min(morphed, given),
                        vertices,
                        target.weight);
            }
        }
        return out;
    }

    private static void add(float[] out, int width, Accessor change, int changed, int[] vertices, double weight)
            throws GltfException {
        int columns = Math.min(changed, change.width());
        for (int i = 0; i < vertices.length; i++) {
            for (int c = 0; c < columns; c++) {
                out[width * i + c] += (float) (weight * change.value(vertices[i], c));
            }
        }
    }

    private Accessor accessor(Source source, JsonValue reference, Set<Accessor.Component> components)
            throws GltfException {
        Accessor accessor = Accessor.of(reference, container, buffers).requireComponent(reference, components);
        if (accessor.count() != source.vertexCount) {
            throw reference.error(
                    "leads to " + accessor.count() + " elements but there are " + source.vertexCount + " positions");
        }
        return accessor;
    }
}
