package org.daybreak.scenes.build;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Set;
import javax.vecmath.Matrix4d;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.mesh.MeshFormatException;
import org.daybreak.scenes.mesh.ObjReader;
import org.daybreak.scenes.mesh.PlyReader;
import org.daybreak.scenes.mesh.SerializedReader;
import org.daybreak.scenes.mesh.StlReader;
import org.daybreak.scenes.mesh.VertexNormals;
import org.daybreak.scenes.mesh.ZeroAreaTriangles;
import org.jspecify.annotations.Nullable;

/** Reads the meshes of a scene. A file that several shapes use is read and stored once. */
final class MeshBuilder {
    /**
     * A mesh for a shape.
     *
     * @param frontByWinding true if the order of vertices in world space says which side is the front, because the file's
     *     normals are absent or not used: then mirroring exchanges the sides
     */
    record Mesh(TriangleMesh mesh, boolean frontByWinding) {}

    private final BuildContext context;
    private final Map<String, TriangleMesh> read = new HashMap<>();
    private final IdentityHashMap<TriangleMesh, TriangleMesh> smoothed = new IdentityHashMap<>();
    private final IdentityHashMap<TriangleMesh, TriangleMesh> flattened = new IdentityHashMap<>();

    /** Meshes whose files ask for flat triangles. */
    private final Set<TriangleMesh> flat = Collections.newSetFromMap(new IdentityHashMap<>());

    MeshBuilder(BuildContext context) {
        this.context = context;
    }

    /**
     * The mesh of a shape of a mesh type.
     *
     * @param toWorld where it goes; computed normals depend on it as Mitsuba computes them in world space
     * @return null after an error that has been reported
     */
    @Nullable
    Mesh mesh(Properties p, Matrix4d toWorld) {
        Path file = p.has("filename") ? context.file(p.text("filename"), p.location("filename")) : null;
        if (file == null) {
            return null;
        }
        String type = p.object().type();
        boolean flip = (type.equals("obj") || type.equals("ply")) && p.truth("flip_tex_coords");
        int index = type.equals("serialized") ? p.integer("shape_index") : 0;
        String key =
                type + " " + flip + " " + index + " " + file.toAbsolutePath().normalize();
        TriangleMesh mesh = read.get(key);
        if (mesh == null) {
            mesh = read(file, type, flip, index, p.location("filename"));
            if (mesh == null) {
                return null;
            }
            read.put(key, mesh);
        }
        if (p.truth("face_normals") || flat.contains(mesh)) {
            TriangleMesh source = mesh;
            return new Mesh(
                    flattened.computeIfAbsent(
                            source, m -> new TriangleMesh(m.positions(), m.triangles(), null, m.uvs())),
                    true);
        }
        if (mesh.normals() != null) {
            return new Mesh(mesh, false);
        }
        // Angles, and with them weights, only change if the transform does more than turn, mirror and scale.
        return new Mesh(
                Affine.isSimilarity(toWorld)
                        ? smoothed.computeIfAbsent(
                                mesh, m -> withNormals(m, VertexNormals.angleWeighted(m.positions(), m.triangles())))
                        : withNormals(mesh, normalsThrough(mesh, toWorld)),
                true);
    }

    private static TriangleMesh withNormals(TriangleMesh m, float[] normals) {
        return new TriangleMesh(m.positions(), m.triangles(), normals, m.uvs());
    }

    /** Normals computed in world space, in the mesh's own coordinates: n = ±Mᵀ n_world, so that M⁻ᵀ brings them back. */
    private static float[] normalsThrough(TriangleMesh mesh, Matrix4d m) {
        float[] p = mesh.positions();
        float[] world = new float[p.length];
        for (int i = 0; i < p.length; i += 3) {
            // Vertices relative to the origin of the mesh: translation would only cost digits.
            world[i] = (float) (m.m00 * p[i] + m.m01 * p[i + 1] + m.m02 * p[i + 2]);
            world[i + 1] = (float) (m.m10 * p[i] + m.m11 * p[i + 1] + m.m12 * p[i + 2]);
            world[i + 2] = (float) (m.m20 * p[i] + m.m21 * p[i + 1] + m.m22 * p[i + 2]);
        }
        float[] n = VertexNormals.angleWeighted(world, mesh.triangles());
        double sign = Affine.isMirroring(m) ? -1 : 1;
        for (int i = 0; i < n.length; i += 3) {
            double x = sign * (m.m00 * n[i] + m.m10 * n[i + 1] + m.m20 * n[i + 2]);
            double y = sign * (m.m01 * n[i] + m.m11 * n[i + 1] + m.m21 * n[i + 2]);
            double z = sign * (m.m02 * n[i] + m.m12 * n[i + 1] + m.m22 * n[i + 2]);
            n[i] = (float) x;
            n[i + 1] = (float) y;
            n[i + 2] = (float) z;
        }
        return n;
    }

    private TriangleMesh serialized(Path file, int index) throws IOException {
        SerializedReader.Mesh mesh = SerializedReader.read(file, index);
        if (mesh.flat()) {
            flat.add(mesh.mesh());
        }
        return mesh.mesh();
    }

    private @Nullable TriangleMesh read(Path file, String type, boolean flip, int index, SourceLocation usedAt) {
        try {
            TriangleMesh mesh = switch (type) {
                case "obj" -> ObjReader.read(file, flip);
                case "ply" -> PlyReader.read(file, flip);
                case "stl" -> StlReader.read(file);
                default -> serialized(file, index);
            };
            TriangleMesh solid = ZeroAreaTriangles.removedFrom(mesh);
            int removed = mesh.triangleCount() - solid.triangleCount();
            if (solid.triangleCount() == 0) {
                context.error(usedAt, "no triangle of " + file + " has an area");
                return null;
            }
            if (removed > 0) {
                context.warning(
                        usedAt,
                        removed + (removed == 1 ? " triangle" : " triangles") + " of zero area in " + file
                                + (removed == 1 ? " is" : " are") + " left out");
            }
            if (flat.remove(mesh)) {
                flat.add(solid);
            }
            return solid;
        } catch (MeshFormatException e) {
            context.error(new SourceLocation(file, e.line(), 0), e.getMessage() + " (used at " + usedAt + ")");
        } catch (IOException e) {
            context.error(usedAt, "cannot read " + file + ": " + e.getMessage());
        } catch (OutOfMemoryError e) {
            context.error(usedAt, "the mesh " + file + " does not fit into memory");
        }
        return null;
    }
}
