package org.daybreak.scenes.build;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Collections;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Set;
import javax.vecmath.Matrix4d;
import org.daybreak.core.geometry.HeightField;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.geometry.Tubes;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.image.ImageLoader;
import org.daybreak.scenes.image.LoadedImage;
import org.daybreak.scenes.mesh.CurveReader;
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

    /** Keys of the OBJ files that have been read by materials. */
    private final Set<String> parts = new HashSet<>();

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
        String part = type.equals("obj") && p.has("material") ? p.text("material") : null;
        int index = type.equals("serialized") ? p.integer("shape_index") : 0;
        String detail = switch (type) {
            case "bsplinecurve", "linearcurve" -> Integer.toString(p.integer("sides"));
            case "heightfield" -> Double.toString(p.number("scale"));
            default -> Integer.toString(index);
        };
        String key =
                type + " " + flip + " " + detail + " " + file.toAbsolutePath().normalize();
        if (part != null) {
            key += " " + part;
            readParts(file, flip, part, key, p.location("material"));
        }
        TriangleMesh mesh = read.get(key);
        if (mesh == null && part == null) {
            mesh = switch (type) {
                case "bsplinecurve", "linearcurve" -> curves(p, file);
                case "heightfield" -> heightField(p, file);
                default -> read(file, type, flip, index, p.location("filename"));
            };
            if (mesh == null) {
                return null;
            }
            read.put(key, mesh);
        }
        if (mesh == null) {
            return null;
        }
        boolean faces = !type.endsWith("curve") && p.truth("face_normals");
        if (faces || flat.contains(mesh)) {
            TriangleMesh source = mesh;
            return new Mesh(flattened.computeIfAbsent(source, m -> m.withNormals(null)), true);
        }
        if (mesh.normals() != null) {
            return new Mesh(mesh, false);
        }
        // Angles, and with them weights, only change if the transform does more than turn, mirror and scale.
        return new Mesh(
                Affine.isSimilarity(toWorld)
                        ? smoothed.computeIfAbsent(
                                mesh, m -> m.withNormals(VertexNormals.angleWeighted(m.positions(), m.triangles())))
                        : mesh.withNormals(normalsThrough(mesh, toWorld)),
                true);
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

    /** Reads an OBJ file by materials, once for all of them. */
    private void readParts(Path file, boolean flip, String part, String key, SourceLocation usedAt) {
        String common = key.substring(0, key.length() - part.length());
        if (parts.add(common)) {
            Map<String, TriangleMesh> meshes = guarded(file, usedAt, () -> ObjReader.readByMaterial(file, flip));
            if (meshes != null) {
                meshes.forEach((name, mesh) -> {
                    TriangleMesh solid = solid(mesh, file, usedAt);
                    if (solid != null) {
                        read.put(common + name, solid);
                    }
                });
                if (!meshes.containsKey(part)) {
                    context.problems()
                            .unknownName(
                                    usedAt,
                                    file + " has no faces of the material '" + part + "'",
                                    part,
                                    meshes.keySet());
                }
            }
        }
    }

    private @Nullable TriangleMesh curves(Properties p, Path file) {
        return guarded(file, p.location("filename"), () -> {
            double[][] curves = CurveReader.read(file);
            try {
                return p.object().type().equals("linearcurve")
                        ? Tubes.linear(curves, p.integer("sides"))
                        : Tubes.bspline(curves, p.integer("sides"));
            } catch (IllegalArgumentException e) {
                throw new MeshFormatException(0, String.valueOf(e.getMessage()));
            }
        });
    }

    /** Heights are the values of the first channel as they are stored. */
    private @Nullable TriangleMesh heightField(Properties p, Path file) {
        String ending = ImageLoader.ending(file);
        SourceLocation usedAt = p.location("filename");
        if (!context.images().endings().contains(ending)) {
            context.error(usedAt, "images of type '" + ending + "' cannot be read");
            return null;
        }
        return guarded(file, usedAt, () -> {
            LoadedImage image = context.images().load(file);
            float[] heights = new float[image.width() * image.height()];
            for (int i = 0; i < heights.length; i++) {
                int at = image.channels() * i;
                heights[i] = image instanceof LoadedImage.Bytes b
                        ? (b.samples()[at] & 0xff) / 255f
                        : ((LoadedImage.Floats) image).samples()[at];
            }
            try {
                return HeightField.mesh(heights, image.width(), image.height(), p.number("scale"));
            } catch (IllegalArgumentException e) {
                throw new MeshFormatException(0, String.valueOf(e.getMessage()));
            }
        });
    }

    private TriangleMesh serialized(Path file, int index) throws IOException {
        SerializedReader.Mesh mesh = SerializedReader.read(file, index);
        if (mesh.flat()) {
            flat.add(mesh.mesh());
        }
        return mesh.mesh();
    }

    private @Nullable TriangleMesh read(Path file, String type, boolean flip, int index, SourceLocation usedAt) {
        TriangleMesh mesh = guarded(file, usedAt, () -> switch (type) {
            case "obj" -> ObjReader.read(file, flip);
            case "ply" -> PlyReader.read(file, flip);
            case "stl" -> StlReader.read(file);
            default -> serialized(file, index);
        });
        return mesh == null ? null : solid(mesh, file, usedAt);
    }

    /** The mesh without triangles of no area; null if nothing is left, which is reported. */
    private @Nullable TriangleMesh solid(TriangleMesh mesh, Path file, SourceLocation usedAt) {
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
    }

    private interface Reading<T> {
        T read() throws IOException;
    }

    /** What a reader returns; null after an error that has been reported. */
    private <T> @Nullable T guarded(Path file, SourceLocation usedAt, Reading<T> reading) {
        try {
            return reading.read();
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
