package org.daybreak.core.testing;

import java.util.SplittableRandom;
import org.daybreak.core.accel.PrimitiveSet;

/** Closed convex meshes about the origin whose triangles share vertices. */
public final class TestMesh {
    private final double[] positions;
    private final int[] triangles;

    private TestMesh(double[] positions, int[] triangles) {
        this.positions = positions;
        this.triangles = triangles;
    }

    /**
     * The cube [-1, 1]³.
     *
     * @param parts number of squares along each edge; each is cut into two triangles
     */
    public static TestMesh cube(int parts) {
        int side = parts + 1;
        double[] positions = new double[3 * side * side * side];
        for (int i = 0; i < positions.length / 3; i++) {
            int[] cell = {i % side, i / side % side, i / (side * side)};
            for (int axis = 0; axis < 3; axis++) {
                positions[3 * i + axis] = 2.0 * cell[axis] / parts - 1;
            }
        }
        int[] strides = {1, side, side * side};
        int[] triangles = new int[3 * 12 * parts * parts];
        int end = 0;
        for (int axis = 0; axis < 3; axis++) {
            int u = strides[(axis + 1) % 3];
            int v = strides[(axis + 2) % 3];
            for (int i = 0; i < parts; i++) {
                for (int j = 0; j < parts; j++) {
                    int low = i * u + j * v;
                    int high = low + parts * strides[axis];
                    int[] corners = {
                        low,
                        low + v,
                        low + u + v,
                        low,
                        low + u + v,
                        low + u,
                        high,
                        high + u,
                        high + u + v,
                        high,
                        high + u + v,
                        high + v
                    };
                    System.arraycopy(corners, 0, triangles, end, 12);
                    end += 12;
                }
            }
        }
        return new TestMesh(positions, triangles);
    }

    /** The unit sphere, by rings of latitude and sectors of longitude. */
    public static TestMesh sphere(int rings, int sectors) {
        double[] positions = new double[3 * ((rings - 1) * sectors + 2)];
        positions[2] = 1;
        positions[5] = -1;
        for (int i = 1; i < rings; i++) {
            for (int j = 0; j < sectors; j++) {
                double theta = Math.PI * i / rings;
                double phi = 2 * Math.PI * j / sectors;
                int at = 3 * vertex(i, j, rings, sectors);
                positions[at] = Math.sin(theta) * Math.cos(phi);
                positions[at + 1] = Math.sin(theta) * Math.sin(phi);
                positions[at + 2] = Math.cos(theta);
            }
        }
        int[] triangles = new int[6 * (rings - 1) * sectors];
        int end = 0;
        for (int i = 0; i < rings; i++) {
            for (int j = 0; j < sectors; j++) {
                int a = vertex(i, j, rings, sectors);
                int b = vertex(i, j + 1, rings, sectors);
                int c = vertex(i + 1, j, rings, sectors);
                int d = vertex(i + 1, j + 1, rings, sectors);
                if (i > 0) {
                    triangles[end++] = a;
                    triangles[end++] = c;
                    triangles[end++] = b;
                }
                if (i < rings - 1) {
                    triangles[end++] = b;
                    triangles[end++] = c;
                    triangles[end++] = d;
                }
            }
        }
        return new TestMesh(positions, triangles);
    }

    private static int vertex(int ring, int sector, int rings, int sectors) {
        if (ring == 0) {
            return 0;
        }
        return ring == rings ? 1 : 2 + (ring - 1) * sectors + sector % sectors;
    }

    /** The mesh times the scale, then moved. */
    public PrimitiveSet placed(double scale, double x, double y, double z) {
        float[] placed = new float[positions.length];
        double[] centre = {x, y, z};
        for (int i = 0; i < placed.length; i++) {
            placed[i] = (float) (scale * positions[i] + centre[i % 3]);
        }
        return PrimitiveSet.ofTriangles(placed, triangles.clone());
    }

    /**
     * A random vertex, or a random point of a random edge of a mesh.
     *
     * @param kind 0 for a vertex, 1 for the middle of an edge, 2 for any point of it
     */
    public static void pointOnEdge(PrimitiveSet set, SplittableRandom random, int kind, double[] target) {
        int triangle = random.nextInt(set.triangleCount());
        int corner = random.nextInt(3);
        int a = 3 * set.triangles()[3 * triangle + corner];
        int b = 3 * set.triangles()[3 * triangle + (corner + 1) % 3];
        double weight = kind == 0 ? 0 : kind == 1 ? 0.5 : random.nextDouble();
        for (int axis = 0; axis < 3; axis++) {
            target[axis] = (1 - weight) * set.positions()[a + axis] + weight * set.positions()[b + axis];
        }
    }
}
