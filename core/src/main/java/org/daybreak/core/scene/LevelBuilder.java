package org.daybreak.core.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import org.daybreak.core.accel.Quadric;
import org.daybreak.core.geometry.Cube;
import org.daybreak.core.geometry.Cylinder;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.math.Frame;
import org.daybreak.core.math.Transform;
import org.jspecify.annotations.Nullable;

/** Gathers the shapes of one level into shared arrays, in the coordinates of the level. */
final class LevelBuilder {
    private static final TriangleMesh RECTANGLE = new TriangleMesh(
            new float[] {-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0}, new int[] {0, 1, 2, 2, 3, 0}, null, new float[] {
                0, 0, 1, 0, 1, 1, 0, 1
            });

    private static final TriangleMesh CUBE = cube();

    private float[] positions = {};
    private int[] triangles = {};
    private float @Nullable [] normals;
    private float @Nullable [] uvs;
    private int vertexCount;
    private int cornerCount;

    private final List<Integer> triangleShapes = new ArrayList<>();
    private final List<Integer> triangleStarts = new ArrayList<>();
    private final List<Quadric> quadrics = new ArrayList<>();
    private final List<LevelGeometry.QuadricShape> quadricShapes = new ArrayList<>();

    /**
     * Adds a shape.
     *
     * @param index the shape's number in the scene
     * @throws IllegalArgumentException if the level would have more than 2³¹ coordinates or corners
     */
    void add(int index, Shape shape, Transform toLevel, boolean flipNormals) {
        if (shape instanceof TriangleMesh mesh) {
            addMesh(index, mesh, toLevel, flipNormals);
        } else if (shape instanceof Rectangle) {
            addMesh(index, RECTANGLE, toLevel, flipNormals);
        } else if (shape instanceof Cube) {
            addMesh(index, CUBE, toLevel, flipNormals);
        } else if (shape instanceof Sphere sphere) {
            Point3d c = sphere.centre();
            double r = sphere.radius();
            addQuadric(
                    index,
                    Quadric.Kind.SPHERE,
                    toLevel.multiply(Transform.translate(c.x, c.y, c.z).multiply(Transform.scale(r, r, r))),
                    flipNormals);
        } else if (shape instanceof Disk) {
            addQuadric(index, Quadric.Kind.DISK, toLevel, flipNormals);
        } else if (shape instanceof Cylinder cylinder) {
            addQuadric(index, Quadric.Kind.CYLINDER, toLevel.multiply(placementOf(cylinder)), flipNormals);
        }
    }

    LevelGeometry build() {
        return new LevelGeometry(
                Arrays.copyOf(positions, 3 * vertexCount),
                Arrays.copyOf(triangles, cornerCount),
                normals == null ? null : Arrays.copyOf(normals, 3 * vertexCount),
                uvs == null ? null : Arrays.copyOf(uvs, 2 * vertexCount),
                triangleStarts.stream().mapToInt(Integer::intValue).toArray(),
                triangleShapes.stream().mapToInt(Integer::intValue).toArray(),
                quadrics.toArray(new Quadric[0]),
                quadricShapes.toArray(new LevelGeometry.QuadricShape[0]));
    }

    /** Maps the canonical cylinder (unit circle, z from 0 to 1) to its place. */
    static Transform placementOf(Cylinder cylinder) {
        Point3d a = cylinder.from();
        Vector3d axis = new Vector3d(cylinder.to());
        axis.sub(a);
        double length = axis.length();
        double r = cylinder.radius();
        Frame frame = new Frame();
        frame.set(axis.x / length, axis.y / length, axis.z / length);
        return Transform.ofRows(
                r * frame.sx,
                r * frame.tx,
                axis.x,
                a.x,
                r * frame.sy,
                r * frame.ty,
                axis.y,
                a.y,
                r * frame.sz,
                r * frame.tz,
                axis.z,
                a.z);
    }

    /** The mesh of a shape that is made of triangles, null for analytic shapes. */
    static @Nullable TriangleMesh meshOf(Shape shape) {
        if (shape instanceof TriangleMesh mesh) {
            return mesh;
        }
        return shape instanceof Cube ? CUBE : null;
    }

    private void addQuadric(int index, Quadric.Kind kind, Transform toLevel, boolean flipNormals) {
        quadrics.add(new Quadric(kind, toLevel.rows(), toLevel.inverse().rows()));
        quadricShapes.add(new LevelGeometry.QuadricShape(index, flipNormals));
    }

    private void addMesh(int index, TriangleMesh mesh, Transform toLevel, boolean flipNormals) {
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
        triangleStarts.add(cornerCount / 3);
        triangleShapes.add(index);
        boolean swap = toLevel.isMirroring() != flipNormals;
        int[] corners = mesh.triangles();
        for (int i = 0; i < corners.length; i += 3) {
            int a = firstVertex + corners[i];
            int b = firstVertex + corners[i + (swap ? 2 : 1)];
            int c = firstVertex + corners[i + (swap ? 1 : 2)];
            boolean against = meshNormals != null && windsAgainstNormals(a, b, c);
            triangles[cornerCount + i] = a;
            triangles[cornerCount + i + 1] = against ? c : b;
            triangles[cornerCount + i + 2] = against ? b : c;
        }
        vertexCount += mesh.vertexCount();
        cornerCount += corners.length;
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

    /** Vertex normals say which side is the front; a triangle wound against all of them is turned over. */
    private boolean windsAgainstNormals(int a, int b, int c) {
        float[] n = java.util.Objects.requireNonNull(normals);
        double e1x = positions[3 * b] - positions[3 * a];
        double e1y = positions[3 * b + 1] - positions[3 * a + 1];
        double e1z = positions[3 * b + 2] - positions[3 * a + 2];
        double e2x = positions[3 * c] - positions[3 * a];
        double e2y = positions[3 * c + 1] - positions[3 * a + 1];
        double e2z = positions[3 * c + 2] - positions[3 * a + 2];
        double gx = e1y * e2z - e1z * e2y;
        double gy = e1z * e2x - e1x * e2z;
        double gz = e1x * e2y - e1y * e2x;
        double sx = (double) n[3 * a] + n[3 * b] + n[3 * c];
        double sy = (double) n[3 * a + 1] + n[3 * b + 1] + n[3 * c + 1];
        double sz = (double) n[3 * a + 2] + n[3 * b + 2] + n[3 * c + 2];
        return gx * sx + gy * sy + gz * sz < 0;
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
        }
        if (corners > triangles.length) {
            triangles = Arrays.copyOf(triangles, (int)
                    Math.min(Integer.MAX_VALUE - 8L, Math.max(corners, 3L * triangles.length / 2)));
        }
    }

    private static TriangleMesh cube() {
        float[] positions = new float[72];
        float[] uvs = new float[48];
        int[] triangles = new int[36];
        int vertex = 0;
        int corner = 0;
        for (int axis = 0; axis < 3; axis++) {
            for (int side = -1; side <= 1; side += 2) {
                int first = vertex;
                for (int k = 0; k < 4; k++) {
                    float a = k == 1 || k == 2 ? 1 : -1;
                    float b = k >= 2 ? 1 : -1;
                    positions[3 * vertex + axis] = side;
                    positions[3 * vertex + (axis + 1) % 3] = side * a;
                    positions[3 * vertex + (axis + 2) % 3] = b;
                    uvs[2 * vertex] = (a + 1) / 2;
                    uvs[2 * vertex + 1] = (b + 1) / 2;
                    vertex++;
                }
                int[] quad = {0, 1, 2, 2, 3, 0};
                for (int k : quad) {
                    triangles[corner++] = first + k;
                }
            }
        }
        return new TriangleMesh(positions, triangles, null, uvs);
    }
}
