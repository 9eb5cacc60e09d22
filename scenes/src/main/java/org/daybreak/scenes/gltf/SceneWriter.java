package org.daybreak.scenes.gltf;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import javax.vecmath.Matrix4d;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.Value;
import org.daybreak.scenes.mesh.ZeroAreaTriangles;
import org.daybreak.scenes.model.ModelReader;
import org.jspecify.annotations.Nullable;

/**
 * Describes the scene of a document. Nodes are flattened: what they show gets its transform to the world. A mesh that appears
 * several times becomes a group with instances.
 */
final class SceneWriter {
    private final Container container;
    private final Report report;
    private final NodeTree nodes;
    private final Buffers buffers;
    private final PrimitiveReader primitives;
    private final Materials materials;
    private final Instancing instancing;
    private final IdentityHashMap<Geometry, TriangleMesh> meshes = new IdentityHashMap<>();

    private final IdentityHashMap<JsonValue, Pose> poses = new IdentityHashMap<>();

    SceneWriter(Container container, Report report) throws GltfException {
        this.container = container;
        this.report = report;
        this.nodes = new NodeTree(container);
        this.buffers = new Buffers(container);
        this.primitives = new PrimitiveReader(container, buffers, report);
        this.materials = new Materials(container, report, new Textures(container, buffers, report));
        this.instancing = new Instancing(container, buffers);
    }

    /** A mesh at certain weights of its morph targets. */
    private record Morphed(int mesh, List<Double> weights) {}

    /** Something that appears in the scene, and where. */
    private record Appearances(List<Part> parts, List<Matrix4d> transforms) {}

    /** A primitive that is ready to be placed. */
    private record Part(JsonValue primitive, TriangleMesh mesh, Materials.Look look) {}

    /** The document's file and those that its buffers have been read from so far. */
    List<Path> files() {
        List<Path> files = new ArrayList<>(List.of(container.file()));
        files.addAll(buffers.files());
        return files;
    }

    /** The scene. Errors in one mesh, camera or light do not keep those in others from being found. */
    ObjectDescription scene() {
        ObjectBuilder scene = new ObjectBuilder(ObjectKind.SCENE, ModelReader.MODEL, report.location(container.root()));
        Cameras cameras = new Cameras(container, report);
        Lights lights = new Lights(container, report);
        Map<Morphed, Appearances> shared = new LinkedHashMap<>();
        for (JsonValue node : nodes.shown()) {
            try {
                Matrix4d world = nodes.world(node);
                scene.nested(cameras.camera(node, world));
                scene.nested(lights.light(node, world));
                addMesh(node, world, shared, scene);
            } catch (GltfException e) {
                report.error(e);
            }
        }
        shared.values().forEach(a -> place(a, scene));
        return scene.build();
    }

    private void addMesh(JsonValue node, Matrix4d world, Map<Morphed, Appearances> shared, ObjectBuilder scene)
            throws GltfException {
        JsonValue mesh = container.resolve(node, "mesh", "meshes");
        if (mesh == null) {
            return;
        }
        JsonValue weightsValue = node.find("weights") == null ? mesh.find("weights") : node.find("weights");
        double[] weights = weightsValue == null
                ? new double[0]
                : weightsValue.numbers(weightsValue.elements().size());
        JsonValue skin = container.resolve(node, "skin", "skins");
        if (skin != null) {
            Pose pose = poses.get(skin);
            if (pose == null) {
                pose = new Pose(skin, nodes, container, buffers);
                poses.put(skin, pose);
            }
            List<Part> posed = parts(mesh, weights, pose);
            place(new Appearances(posed, List.of(identity())), scene);
            return;
        }
        Morphed key = new Morphed(mesh.index(), Arrays.stream(weights).boxed().toList());
        Appearances appearances = shared.get(key);
        if (appearances == null) {
            appearances = new Appearances(parts(mesh, weights, null), new ArrayList<>());
            shared.put(key, appearances);
        }
        boolean hidden = false;
        for (Matrix4d transform : instancing.transforms(node, world)) {
            // A scale of 0 is how files hide things; flat things are not worth the trouble.
            if (isInvertible(transform)) {
                appearances.transforms.add(transform);
            } else {
                hidden = true;
            }
        }
        if (hidden) {
            report.warning(node, "is left out where its transform flattens it");
        }
    }

    private static boolean isInvertible(Matrix4d m) {
        double x = Math.sqrt(m.m00 * m.m00 + m.m10 * m.m10 + m.m20 * m.m20);
        double y = Math.sqrt(m.m01 * m.m01 + m.m11 * m.m11 + m.m21 * m.m21);
        double z = Math.sqrt(m.m02 * m.m02 + m.m12 * m.m12 + m.m22 * m.m22);
        double volume = m.m00 * (m.m11 * m.m22 - m.m12 * m.m21)
                - m.m01 * (m.m10 * m.m22 - m.m12 * m.m20)
                + m.m02 * (m.m10 * m.m21 - m.m11 * m.m20);
        return Math.abs(volume) > 1e-9 * x * y * z;
    }

    private static Matrix4d identity() {
        Matrix4d m = new Matrix4d();
        m.setIdentity();
        return m;
    }

    private List<Part> parts(JsonValue mesh, double[] weights, @Nullable Pose pose) throws GltfException {
        List<Part> parts = new ArrayList<>();
        for (JsonValue primitive : mesh.get("primitives").elements()) {
            try {
                Geometry geometry = primitives.read(primitive, weights, pose);
                TriangleMesh triangles = geometry == null ? null : triangleMesh(geometry, primitive);
                if (geometry != null && triangles != null) {
                    JsonValue material = container.resolve(primitive, "material", "materials");
                    parts.add(new Part(primitive, triangles, materials.look(material, geometry)));
                }
            } catch (GltfException e) {
                report.error(e);
            }
        }
        return parts;
    }

    /** The mesh without triangles of zero area, of which strips are full; null if none is left. */
    private @Nullable TriangleMesh triangleMesh(Geometry geometry, JsonValue primitive) throws GltfException {
        TriangleMesh known = meshes.get(geometry);
        if (known == null) {
            try {
                known = ZeroAreaTriangles.removedFrom(geometry.toMesh());
            } catch (IllegalArgumentException e) {
                throw primitive.error("is no mesh: " + e.getMessage());
            }
            meshes.put(geometry, known);
        }
        if (known.triangleCount() == 0) {
            report.warning(primitive, "is left out: none of its triangles has an area");
            return null;
        }
        return known;
    }

    private void place(Appearances appearances, ObjectBuilder scene) {
        List<Part> parts = appearances.parts;
        if (parts.isEmpty() || appearances.transforms.isEmpty()) {
            return;
        }
        if (appearances.transforms.size() == 1) {
            for (Part part : parts) {
                scene.nested(shape(part)
                        .transform("to_world", appearances.transforms.get(0))
                        .build());
            }
            return;
        }
        ObjectBuilder group =
                new ObjectBuilder(ObjectKind.SHAPE, "shapegroup", report.location(parts.get(0).primitive));
        for (Part part : parts) {
            group.nested(shape(part).build());
        }
        ObjectDescription prototype = group.build();
        for (Matrix4d transform : appearances.transforms) {
            scene.nested(new ObjectBuilder(ObjectKind.SHAPE, "instance", prototype.location())
                    .transform("to_world", transform)
                    .nested(prototype)
                    .build());
        }
    }

    private ObjectBuilder shape(Part part) {
        return new ObjectBuilder(ObjectKind.SHAPE, "mesh", report.location(part.primitive))
                .value("mesh", new Value.Mesh(part.mesh))
                .nested(part.look.bsdf())
                .nested(part.look.emitter());
    }
}
