package org.daybreak.core.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class TubesTest {
    private static final double[][] HELIX = {helix()};

    private static double[] helix() {
        double[] c = new double[4 * 20];
        for (int i = 0; i < 20; i++) {
            c[4 * i] = 2 * Math.cos(0.7 * i);
            c[4 * i + 1] = 2 * Math.sin(0.7 * i);
            c[4 * i + 2] = 0.3 * i;
            c[4 * i + 3] = 0.2 + 0.01 * i;
        }
        return c;
    }

    /** Point of a B-spline by de Boor's recursion, an algorithm other than the tested one. */
    private static double[] deBoor(double[] c, double t) {
        int segment = Math.min((int) t, c.length / 4 - 4);
        double x = t + 3;
        double[][] d = new double[4][4];
        for (int j = 0; j < 4; j++) {
            System.arraycopy(c, 4 * (segment + j), d[j], 0, 4);
        }
        for (int level = 1; level < 4; level++) {
            for (int j = 3; j >= level; j--) {
                double knot = segment + j;
                double alpha = (x - knot) / (4 - level);
                for (int k = 0; k < 4; k++) {
                    d[j][k] = (1 - alpha) * d[j - 1][k] + alpha * d[j][k];
                }
            }
        }
        return d[3];
    }

    /** Every vertex lies on the true tube and every triangle within the stated error of it. */
    @Test
    void splinesKeepTheStatedError() {
        TriangleMesh mesh = Tubes.bspline(HELIX, 16);
        double[] c = HELIX[0];
        float[] p = mesh.positions();
        int[] t = mesh.triangles();
        for (int i = 0; i < t.length; i += 3 * 7) {
            double[] centroid = new double[3];
            for (int corner = 0; corner < 3; corner++) {
                for (int k = 0; k < 3; k++) {
                    centroid[k] += p[3 * t[i + corner] + k] / 3.0;
                }
            }
            double best = Double.MAX_VALUE;
            double radius = 0;
            for (double s = 0; s <= 17; s += 1e-3) {
                double[] q = deBoor(c, s);
                double d = Math.sqrt(Math.pow(q[0] - centroid[0], 2)
                        + Math.pow(q[1] - centroid[1], 2)
                        + Math.pow(q[2] - centroid[2], 2));
                if (d < best) {
                    best = d;
                    radius = q[3];
                }
            }
            assertEquals(radius, best, (0.019 + 0.02 + 0.005) * radius);
        }
    }

    @Test
    void normalsPointOutwardsAndAgreeWithTheWinding() {
        for (TriangleMesh mesh : new TriangleMesh[] {Tubes.bspline(HELIX, 8), Tubes.linear(HELIX, 8)}) {
            assertTrue(mesh.windAlongNormals() == mesh);
        }
    }

    /** A straight polyline of two pieces is a frustum; a bend keeps the radius of both pieces. */
    @Test
    void polylines() {
        TriangleMesh straight = Tubes.linear(new double[][] {{0, 0, 0, 1, 0, 0, 2, 0.5, 0, 0, 2, 0.5, 0, 0, 4, 0}}, 4);
        assertEquals(3 * 5, straight.vertexCount());
        float[] p = straight.positions();
        for (int i = 0; i < 15; i++) {
            assertEquals(1 - 0.25 * p[3 * i + 2], Math.hypot(p[3 * i], p[3 * i + 1]), 1e-6);
        }
        TriangleMesh bent = Tubes.linear(new double[][] {{-5, 0, 0, 1, 0, 0, 0, 1, 0, 5, 0, 1}}, 32);
        p = bent.positions();
        for (int i = 33; i < 66; i++) {
            assertEquals(1, Math.hypot(p[3 * i + 1], p[3 * i + 2]), 1e-5);
            assertEquals(1, Math.hypot(p[3 * i], p[3 * i + 2]), 1e-5);
        }
    }

    @Test
    void refusesWhatIsNoCurve() {
        assertThrows(IllegalArgumentException.class, () -> Tubes.linear(new double[][] {{0, 0, 0, 1, 0, 0, 0, 1}}, 8));
        assertThrows(IllegalArgumentException.class, () -> Tubes.bspline(new double[][] {new double[12]}, 8));
        assertThrows(IllegalArgumentException.class, () -> Tubes.linear(new double[][] {{0, 0, 0, -1, 1, 0, 0, 1}}, 8));
        assertThrows(IllegalArgumentException.class, () -> Tubes.linear(HELIX, 2));
    }

    @Test
    void heightFieldsSpanTheSquare() {
        TriangleMesh mesh = HeightField.mesh(new float[] {0, 1, 2, 3, 4, 5}, 3, 2, 0.5);
        assertEquals(4, mesh.triangleCount());
        float[] p = mesh.positions();
        assertEquals(-1f, p[0]);
        assertEquals(-1f, p[1]);
        assertEquals(1f, p[15]);
        assertEquals(1f, p[16]);
        assertEquals(2.5f, p[17]);
        assertThrows(IllegalArgumentException.class, () -> HeightField.mesh(new float[3], 3, 1, 1));
    }
}
