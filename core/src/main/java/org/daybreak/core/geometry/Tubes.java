package org.daybreak.core.geometry;

/**
 * Curves as tubes of round cross-section, as triangle meshes with vertex normals and open ends. Texture coordinates: u around
 * the tube, v from the first end (0) to the last (1).
 *
 * <p>Error: a cross-section of n sides lies inside the circle by at most r(1 − cos(π/n)), 1.9 % of the radius for 16 sides.
 * Cubic curves are cut so finely that no chord is farther than 2 % of the smaller radius at its ends from the axis, unless
 * that takes more than {@value #MOST_STEPS} pieces for one segment.
 */
public final class Tubes {
    /** Pieces of a cubic segment at most. */
    public static final int MOST_STEPS = 64;

    private static final double TOLERANCE = 0.02;

    /** Longest mitre of a bend, in radii. */
    private static final double LONGEST_MITRE = 3;

    private Tubes() {}

    /**
     * Tubes along polylines, mitred at their bends.
     *
     * @param curves x, y, z, radius per point, one array per curve; at least two different points each
     * @param sides number of sides of the cross-section, at least 3
     * @throws IllegalArgumentException if a curve has fewer points, or a number is not finite or a radius negative
     */
    public static TriangleMesh linear(double[][] curves, int sides) {
        double[][] axes = new double[curves.length][];
        for (int i = 0; i < curves.length; i++) {
            axes[i] = withoutRepetitions(curves[i], i);
        }
        return sweep(axes, sides, true);
    }

    /**
     * Tubes along uniform cubic B-splines; the radius is interpolated like the position.
     *
     * @param curves x, y, z, radius per control point, one array per curve; at least four control points each
     * @param sides number of sides of the cross-section, at least 3
     * @throws IllegalArgumentException if a curve has fewer points, or a number is not finite or a radius negative
     */
    public static TriangleMesh bspline(double[][] curves, int sides) {
        double[][] axes = new double[curves.length][];
        for (int i = 0; i < curves.length; i++) {
            if (curves[i].length < 16) {
                throw new IllegalArgumentException(
                        "curve " + i + " has " + curves[i].length / 4 + " control points but needs at least 4");
            }
            axes[i] = withoutRepetitions(flattened(curves[i]), i);
        }
        return sweep(axes, sides, false);
    }

    private static double[] withoutRepetitions(double[] points, int curve) {
        double[] kept = new double[points.length];
        int end = 0;
        for (int i = 0; i < points.length; i += 4) {
            for (int k = 0; k < 4; k++) {
                if (!Double.isFinite(points[i + k]) || points[i + 3] < 0) {
                    throw new IllegalArgumentException(
                            "point " + i / 4 + " of curve " + curve + " must be finite and its radius not negative");
                }
            }
            boolean repeated = end > 0
                    && points[i] == kept[end - 4]
                    && points[i + 1] == kept[end - 3]
                    && points[i + 2] == kept[end - 2];
            if (!repeated) {
                System.arraycopy(points, i, kept, end, 4);
                end += 4;
            }
        }
        if (end < 8) {
            throw new IllegalArgumentException("curve " + curve + " needs at least 2 different points");
        }
        return java.util.Arrays.copyOf(kept, end);
    }

    /** Points on a B-spline, close enough for the stated error. */
    private static double[] flattened(double[] c) {
        int segments = c.length / 4 - 3;
        int[] steps = new int[segments];
        int total = 1;
        for (int s = 0; s < segments; s++) {
            steps[s] = steps(c, 4 * s);
            total += steps[s];
        }
        double[] points = new double[4 * total];
        int at = 0;
        for (int s = 0; s < segments; s++) {
            for (int i = 0; i < steps[s] + (s == segments - 1 ? 1 : 0); i++) {
                double t = (double) i / steps[s];
                double r = 1 - t;
                double w0 = r * r * r / 6;
                double w1 = (3 * t * t * t - 6 * t * t + 4) / 6;
                double w3 = t * t * t / 6;
                double w2 = 1 - w0 - w1 - w3;
                for (int k = 0; k < 4; k++) {
                    int p = 4 * s + k;
                    points[at++] = w0 * c[p] + w1 * c[p + 4] + w2 * c[p + 8] + w3 * c[p + 12];
                }
            }
        }
        return points;
    }

    /** A chord of parameter length h is off by at most h²/8 times the second derivative, which is linear in a segment. */
    private static int steps(double[] c, int at) {
        double squared = 0;
        for (int end = 0; end < 2; end++) {
            double sum = 0;
            for (int k = 0; k < 3; k++) {
                int p = at + 4 * end + k;
                double d = c[p] - 2 * c[p + 4] + c[p + 8];
                sum += d * d;
            }
            squared = Math.max(squared, sum);
        }
        double radius = Math.min(Math.min(c[at + 3], c[at + 7]), Math.min(c[at + 11], c[at + 15]));
        double wanted = Math.sqrt(Math.sqrt(squared) / (8 * TOLERANCE * radius));
        return wanted < MOST_STEPS ? Math.max(1, (int) Math.ceil(wanted)) : MOST_STEPS;
    }

    private static TriangleMesh sweep(double[][] axes, int sides, boolean mitre) {
        if (sides < 3) {
            throw new IllegalArgumentException("a tube needs at least 3 sides but is given " + sides);
        }
        long rings = 0;
        for (double[] axis : axes) {
            rings += axis.length / 4;
        }
        long quads = (rings - axes.length) * sides;
        // One more vertex in each ring, so that u can run from 0 to 1.
        if (3 * rings * (sides + 1) > Integer.MAX_VALUE - 8 || 6 * quads > Integer.MAX_VALUE - 8) {
            throw new IllegalArgumentException("the curves have too many points: " + rings);
        }
        Sweep sweep = new Sweep((int) rings, (int) quads, sides, mitre);
        for (double[] axis : axes) {
            sweep.add(axis);
        }
        return new TriangleMesh(sweep.positions, sweep.triangles, sweep.normals, sweep.uvs);
    }

    /** The arrays that are filled ring by ring. */
    private static final class Sweep {
        private final int sides;
        private final boolean mitre;
        private final float[] positions;
        private final float[] normals;
        private final float[] uvs;
        private final int[] triangles;
        private int vertex;
        private int corner;

        Sweep(int rings, int quads, int sides, boolean mitre) {
            this.sides = sides;
            this.mitre = mitre;
            positions = new float[3 * rings * (sides + 1)];
            normals = new float[3 * rings * (sides + 1)];
            uvs = new float[2 * rings * (sides + 1)];
            triangles = new int[6 * quads];
        }

        void add(double[] axis) {
            int count = axis.length / 4;
            double[] before = new double[3];
            double[] after = new double[3];
            double[] tangent = new double[3];
            double[] across = new double[3];
            for (int i = 0; i < count; i++) {
                direction(axis, Math.max(0, i - 1), before);
                direction(axis, Math.min(count - 2, i), after);
                for (int k = 0; k < 3; k++) {
                    tangent[k] = before[k] + after[k];
                }
                if (!(normalize(tangent) > 1e-6)) {
                    // The curve turns back: the ring faces along the way that it came.
                    System.arraycopy(before, 0, tangent, 0, 3);
                }
                transport(across, tangent);
                double taper = taper(axis, i, count);
                double half = dot(before, tangent);
                double stretch = mitre ? Math.min(LONGEST_MITRE, 1 / Math.max(1e-6, half)) - 1 : 0;
                double[] bend = {after[0] - before[0], after[1] - before[1], after[2] - before[2]};
                if (!(normalize(bend) > 1e-9)) {
                    stretch = 0;
                }
                ring(axis, i, (double) i / (count - 1), tangent, across, taper, bend, stretch);
            }
            for (int i = 0; i + 1 < count; i++) {
                int low = vertex - (count - i) * (sides + 1);
                for (int k = 0; k < sides; k++) {
                    int a = low + k;
                    int b = a + sides + 1;
                    triangles[corner++] = a;
                    triangles[corner++] = a + 1;
                    triangles[corner++] = b + 1;
                    triangles[corner++] = a;
                    triangles[corner++] = b + 1;
                    triangles[corner++] = b;
                }
            }
        }

        private void ring(
                double[] axis,
                int i,
                double v,
                double[] t,
                double[] across,
                double taper,
                double[] bend,
                double stretch) {
            double bx = t[1] * across[2] - t[2] * across[1];
            double by = t[2] * across[0] - t[0] * across[2];
            double bz = t[0] * across[1] - t[1] * across[0];
            double radius = axis[4 * i + 3];
            for (int k = 0; k <= sides; k++) {
                double phi = 2 * Math.PI * (k == sides ? 0 : k) / sides;
                double c = Math.cos(phi);
                double s = Math.sin(phi);
                double[] n = {
                    c * across[0] + s * bx, c * across[1] + s * by, c * across[2] + s * bz,
                };
                double along = stretch * dot(n, bend);
                for (int axisIndex = 0; axisIndex < 3; axisIndex++) {
                    positions[3 * vertex + axisIndex] =
                            (float) (axis[4 * i + axisIndex] + radius * (n[axisIndex] + along * bend[axisIndex]));
                    normals[3 * vertex + axisIndex] = (float) (n[axisIndex] - taper * t[axisIndex]);
                }
                uvs[2 * vertex] = (float) ((double) k / sides);
                uvs[2 * vertex + 1] = (float) v;
                vertex++;
            }
        }

        /** Change of the radius per length around a point. */
        private static double taper(double[] axis, int i, int count) {
            int a = 4 * Math.max(0, i - 1);
            int b = 4 * Math.min(count - 1, i + 1);
            double length = 0;
            for (int p = a; p < b; p += 4) {
                length += Math.sqrt((axis[p + 4] - axis[p]) * (axis[p + 4] - axis[p])
                        + (axis[p + 5] - axis[p + 1]) * (axis[p + 5] - axis[p + 1])
                        + (axis[p + 6] - axis[p + 2]) * (axis[p + 6] - axis[p + 2]));
            }
            return (axis[b + 3] - axis[a + 3]) / length;
        }

        /** Carries a vector to the plane across a new tangent with the least turn; chooses one if there is none. */
        private static void transport(double[] across, double[] tangent) {
            double along = dot(across, tangent);
            for (int k = 0; k < 3; k++) {
                across[k] -= along * tangent[k];
            }
            if (!(normalize(across) > 1e-9)) {
                double sign = Math.copySign(1, tangent[2]);
                double a = -1 / (sign + tangent[2]);
                across[0] = 1 + sign * tangent[0] * tangent[0] * a;
                across[1] = sign * tangent[0] * tangent[1] * a;
                across[2] = -sign * tangent[0];
            }
        }

        private static void direction(double[] axis, int i, double[] out) {
            for (int k = 0; k < 3; k++) {
                out[k] = axis[4 * (i + 1) + k] - axis[4 * i + k];
            }
            normalize(out);
        }

        /** Returns the length before. */
        private static double normalize(double[] v) {
            double length = Math.sqrt(dot(v, v));
            if (length > 0) {
                for (int k = 0; k < 3; k++) {
                    v[k] /= length;
                }
            }
            return length;
        }

        private static double dot(double[] a, double[] b) {
            return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        }
    }
}
