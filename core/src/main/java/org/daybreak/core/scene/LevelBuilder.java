package org.daybreak.core.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.daybreak.core.accel.Quadric;
import org.daybreak.core.geometry.Cone;
import org.daybreak.core.geometry.Cube;
import org.daybreak.core.geometry.CubeMesh;
import org.daybreak.core.geometry.Cylinder;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.ShapeFrames;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.TangentFrame;
import org.daybreak.core.math.Transform;
import org.jspecify.annotations.Nullable;

/** Gathers the shapes of one level into shared arrays, in the coordinates of the level. */
final class LevelBuilder {
    private static final TriangleMesh RECTANGLE = new TriangleMesh(
            new float[] {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, new int[] {0, 1, 2, 2, 3, 0}, null, new float[] {
                0, 0, 1, 0, 1, 1, 0, 1
            });

    private float[] positions = {};
    private int[] triangles = {};
    private float @Nullable [] normals;
    private float @Nullable [] uvs;
    private float @Nullable [] secondUvs;
    private float @Nullable [] colors;
    private float @Nullable [] tangents;
    private int vertexCount;
    private int cornerCount;

    private final List<Integer> triangleShapes = new ArrayList<>();
    private final List<Integer> triangleStarts = new ArrayList<>();
    private final List<TangentFrame> triangleFrames = new ArrayList<>();
    private final List<Quadric> quadrics = new ArrayList<>();
    private final List<LevelGeometry.QuadricShape> quadricShapes = new ArrayList<>();

    /**
     * Adds a shape.
     *
     * @param index the shape's number in the scene
     * @param needs what its points must offer
     * @throws IllegalArgumentException if the level would have more than 2³¹ coordinates or corners
     */
    void add(int index, Shape shape, Transform toLevel, boolean flipNormals, ShadingNeeds needs) {
        if (shape instanceof TriangleMesh mesh) {
            addMesh(index, mesh, toLevel, flipNormals, needs);
        } else if (shape instanceof Rectangle) {
            addMesh(index, RECTANGLE, toLevel, flipNormals, needs);
        } else if (shape instanceof Cube) {
            addMesh(index, CubeMesh.MESH, toLevel, flipNormals, needs);
        } else if (shape instanceof Sphere sphere) {
            addQuadric(index, Quadric.Kind.SPHERE, toLevel.multiply(ShapeFrames.of(sphere)), flipNormals, needs);
        } else if (shape instanceof Disk) {
            addQuadric(index, Quadric.Kind.DISK, toLevel, flipNormals, needs);
        } else if (shape instanceof Cone cone) {
            Transform map = toLevel.multiply(ShapeFrames.of(cone));
            quadrics.add(new Quadric(
                    Quadric.Kind.CONE, cone.taper(), map.rows(), map.inverse().rows()));
            quadricShapes.add(new LevelGeometry.QuadricShape(index, flipNormals, needs, cone.widens()));
        } else if (shape instanceof Cylinder cylinder) {
            addQuadric(index, Quadric.Kind.CYLINDER, toLevel.multiply(ShapeFrames.of(cylinder)), flipNormals, needs);
        }
    }

    /** Number of triangles so far. */
    int triangleCount() {
        return cornerCount / 3;
    }

    LevelGeometry build() {
        return new LevelGeometry(
                Arrays.copyOf(positions, 3 * vertexCount),
                Arrays.copyOf(triangles, cornerCount),
                normals == null ? null : Arrays.copyOf(normals, 3 * vertexCount),
                uvs == null ? null : Arrays.copyOf(uvs, 2 * vertexCount),
                attributes(),
                triangleStarts.stream().mapToInt(Integer::intValue).toArray(),
                triangleShapes.stream().mapToInt(Integer::intValue).toArray(),
                frames(),
                quadrics.toArray(new Quadric[0]),
                quadricShapes.toArray(new LevelGeometry.QuadricShape[0]));
    }

    private @Nullable VertexAttributes attributes() {
        return secondUvs == null && colors == null && tangents == null
                ? null
                : new VertexAttributes(
                        secondUvs == null ? null : Arrays.copyOf(secondUvs, 2 * vertexCount),
                        colors == null ? null : Arrays.copyOf(colors, 3 * vertexCount),
                        tangents == null ? null : Arrays.copyOf(tangents, 3 * vertexCount));
    }

    private TangentFrame @Nullable [] frames() {
        return triangleFrames.stream().allMatch(f -> f == TangentFrame.ARBITRARY)
                ? null
                : triangleFrames.toArray(new TangentFrame[0]);
    }

    private void addQuadric(int index, Quadric.Kind kind, Transform toLevel, boolean flipNormals, ShadingNeeds needs) {
        quadrics.add(new Quadric(kind, toLevel.rows(), toLevel.inverse().rows()));
        quadricShapes.add(new LevelGeometry.QuadricShape(index, flipNormals, needs, false));
    }

    private void addMesh(int index, TriangleMesh mesh, Transform toLevel, boolean flipNormals, ShadingNeeds needs) {
        int firstVertex = vertexCount;
        grow(mesh);
        double[] p = new double[3];
        float[] source = mesh.positions();
        for (int i = 0; i < source.length; i += 3) {
            toLevel.applyPoint(source[i], source[i + 1], source[i + 2], p);
            int at = 3 * firstVertex + i;
            positions[at] = (float) p[0];
            positions[at + 1] = (float) p[1];
            positions[at + 2] = (float) p[2];
        }
        float[] meshNormals = mesh.normals();
        if (meshNormals != null) {
            copyNormals(meshNormals, toLevel, flipNormals, firstVertex);
        }
        float[] meshUvs = mesh.uvs();
        if (meshUvs != null) {
            if (uvs == null) {
                uvs = new float[positions.length / 3 * 2];
            }
            System.arraycopy(meshUvs, 0, uvs, 2 * firstVertex, meshUvs.length);
        }
        addAttributes(mesh, firstVertex);
        float[] meshTangents = mesh.tangents();
        if (meshTangents != null && needs.frame() != TangentFrame.ARBITRARY) {
            copyTangents(meshTangents, toLevel, firstVertex);
        }
        triangleStarts.add(cornerCount / 3);
        triangleFrames.add(needs.frame());
        triangleShapes.add(index);
        boolean swap = toLevel.isMirroring() != flipNormals;
        int[] corners = mesh.triangles();
        for (int i = 0; i < corners.length; i += 3) {
            triangles[cornerCount + i] = firstVertex + corners[i];
            triangles[cornerCount + i + 1] = firstVertex + corners[i + (swap ? 2 : 1)];
            triangles[cornerCount + i + 2] = firstVertex + corners[i + (swap ? 1 : 2)];
        }
        vertexCount += mesh.vertexCount();
        cornerCount += corners.length;
    }

    /** Meshes without second coordinates have the first ones there, meshes without colours are white. */
    private void addAttributes(TriangleMesh mesh, int firstVertex) {
        float[] meshSecond = mesh.secondUvs() != null ? mesh.secondUvs() : mesh.uvs();
        if (secondUvs == null && mesh.secondUvs() != null) {
            secondUvs = new float[positions.length / 3 * 2];
            if (uvs != null) {
                System.arraycopy(uvs, 0, secondUvs, 0, 2 * firstVertex);
            }
        }
        if (secondUvs != null && meshSecond != null) {
            System.arraycopy(meshSecond, 0, secondUvs, 2 * firstVertex, meshSecond.length);
        }
        float[] meshColors = mesh.colors();
        if (colors == null && meshColors != null) {
            colors = new float[positions.length];
            Arrays.fill(colors, 0, 3 * firstVertex, 1);
        }
        if (colors != null) {
            if (meshColors != null) {
                System.arraycopy(meshColors, 0, colors, 3 * firstVertex, meshColors.length);
            } else {
                Arrays.fill(colors, 3 * firstVertex, 3 * (firstVertex + mesh.vertexCount()), 1);
            }
        }
    }

    private void copyTangents(float[] meshTangents, Transform toLevel, int firstVertex) {
        if (tangents == null) {
            tangents = new float[positions.length];
        }
        double[] d = new double[3];
        for (int i = 0; i < meshTangents.length; i += 3) {
            toLevel.applyVector(meshTangents[i], meshTangents[i + 1], meshTangents[i + 2], d);
            double length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
            double scale = length == 0 ? 0 : 1 / length;
            int at = 3 * firstVertex + i;
            tangents[at] = (float) (d[0] * scale);
            tangents[at + 1] = (float) (d[1] * scale);
            tangents[at + 2] = (float) (d[2] * scale);
        }
    }

    private void copyNormals(float[] meshNormals, Transform toLevel, boolean flipNormals, int firstVertex) {
        if (normals == null) {
            normals = new float[positions.length];
        }
        double[] n = new double[3];
        for (int i = 0; i < meshNormals.length; i += 3) {
            toLevel.applyNormal(meshNormals[i], meshNormals[i + 1], meshNormals[i + 2], n);
            double length = Math.sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            double scale = length == 0 ? 0 : (flipNormals ? -1 : 1) / length;
            int at = 3 * firstVertex + i;
            normals[at] = (float) (n[0] * scale);
            normals[at + 1] = (float) (n[1] * scale);
            normals[at + 2] = (float) (n[2] * scale);
        }
    }

    private void grow(TriangleMesh mesh) {
        int vertices = Math.addExact(vertexCount, mesh.vertexCount());
        int corners = Math.addExact(cornerCount, mesh.triangles().length);
        if (3L * vertices > Integer.MAX_VALUE - 8) {
            throw new IllegalArgumentException(
                    "one level of the scene has more than " + Integer.MAX_VALUE / 3 + " vertices; use instances");
        }
        if (3 * vertices > positions.length) {
            int capacity = (int) Math.min(Integer.MAX_VALUE / 3 - 8L, Math.max(vertices, 3L * positions.length / 6));
            positions = Arrays.copyOf(positions, 3 * capacity);
            if (normals != null) {
                normals = Arrays.copyOf(normals, 3 * capacity);
            }
            if (uvs != null) {
                uvs = Arrays.copyOf(uvs, 2 * capacity);
            }
            if (secondUvs != null) {
                secondUvs = Arrays.copyOf(secondUvs, 2 * capacity);
            }
            if (colors != null) {
                colors = Arrays.copyOf(colors, 3 * capacity);
            }
            if (tangents != null) {
                tangents = Arrays.copyOf(tangents, 3 * capacity);
            }
        }
        if (corners > triangles.length) {
            triangles = Arrays.copyOf(triangles, (int)
                    Math.min(Integer.MAX_VALUE - 8L, Math.max(corners, 3L * triangles.length / 2)));
        }
    }
}
