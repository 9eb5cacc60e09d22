package org.daybreak.benchmarks.intersection;

import java.util.Arrays;
import org.daybreak.core.accel.PrimitiveSet;

/**
 * A triangle mesh made by formula, with a camera and a rectangular light: a Cornell-like box, or a room with a terrain as
 * floor and noisy spheres over it, of about any number of triangles. Y points up; the room is [-1, 1]³.
 */
final class BenchmarkScene {
    private static final int SPHERES = 34;

    /** Camera, at which all primary rays start, looking along −z. */
    static final double[] CAMERA = {0.1, 0.15, 0.95};

    /** Height of the light, a square of this half width about the y axis. */
    static final double LIGHT_Y = 0.97;

    static final double LIGHT_HALF_WIDTH = 0.3;

    final String name;
    private float[] positions = new float[1 << 10];
    private int[] triangles = new int[1 << 10];
    private int positionEnd;
    private int triangleEnd;

    private BenchmarkScene(String name) {
        this.name = name;
    }

    /** Five walls, a light and two boxes: 36 triangles. */
    static BenchmarkScene cornell() {
        BenchmarkScene scene = new BenchmarkScene("cornell");
        scene.walls(true);
        scene.box(-0.35, -0.4, -0.35, 0.28, 0.6, 0.3);
        scene.box(0.35, -0.7, 0.3, 0.28, 0.3, -0.3);
        return scene;
    }

    /**
     * The room: half of the triangles in the terrain, half in the spheres.
     *
     * @param target about how many triangles
     */
    static BenchmarkScene room(String name, int target) {
        BenchmarkScene scene = new BenchmarkScene(name);
        scene.walls(false);
        int side = Math.max(2, (int) Math.round(Math.sqrt(target / 4.0)));
        scene.terrain(side);
        int rings = Math.max(2, (int) Math.round(Math.sqrt(target / 4.0 / SPHERES / 2)));
        for (int i = 0; i < SPHERES; i++) {
            double x = 1.6 * (radicalInverse(2, i + 1) - 0.5);
            double z = 1.6 * (radicalInverse(3, i + 1) - 0.5) - 0.1;
            double y = -0.6 + 1.2 * radicalInverse(5, i + 1);
            scene.sphere(x, y, z, 0.06 + 0.1 * radicalInverse(7, i + 1), rings, i);
        }
        return scene;
    }

    int triangleCount() {
        return triangleEnd / 3;
    }

    /** The mesh, in arrays of its own. */
    PrimitiveSet primitives() {
        return PrimitiveSet.ofTriangles(Arrays.copyOf(positions, positionEnd), Arrays.copyOf(triangles, triangleEnd));
    }

    private static double radicalInverse(int base, int index) {
        double result = 0;
        double digit = 1.0 / base;
        for (int i = index; i > 0; i /= base) {
            result += digit * (i % base);
            digit /= base;
        }
        return result;
    }

    private int vertex(double x, double y, double z) {
        if (positionEnd + 3 > positions.length) {
            positions = Arrays.copyOf(positions, 2 * positions.length);
        }
        positions[positionEnd] = (float) x;
        positions[positionEnd + 1] = (float) y;
        positions[positionEnd + 2] = (float) z;
        positionEnd += 3;
        return positionEnd / 3 - 1;
    }

    private void triangle(int a, int b, int c) {
        if (triangleEnd + 3 > triangles.length) {
            triangles = Arrays.copyOf(triangles, 2 * triangles.length);
        }
        triangles[triangleEnd++] = a;
        triangles[triangleEnd++] = b;
        triangles[triangleEnd++] = c;
    }

    private void quad(int a, int b, int c, int d) {
        triangle(a, b, c);
        triangle(a, c, d);
    }

    private void walls(boolean floor) {
        int[] v = new int[8];
        for (int i = 0; i < 8; i++) {
            v[i] = vertex((i & 1) == 0 ? -1 : 1, (i & 2) == 0 ? -1 : 1, (i & 4) == 0 ? -1 : 1);
        }
        if (floor) {
            quad(v[0], v[4], v[5], v[1]);
        }
        quad(v[2], v[3], v[7], v[6]);
        quad(v[0], v[2], v[6], v[4]);
        quad(v[1], v[5], v[7], v[3]);
        quad(v[0], v[1], v[3], v[2]);
        double w = LIGHT_HALF_WIDTH;
        double y = LIGHT_Y + 0.01;
        quad(vertex(-w, y, -w), vertex(w, y, -w), vertex(w, y, w), vertex(-w, y, w));
    }

    private void box(double x, double y, double z, double radius, double halfHeight, double angle) {
        int[] v = new int[8];
        double c = Math.cos(angle) * radius;
        double s = Math.sin(angle) * radius;
        for (int i = 0; i < 8; i++) {
            double u = (i & 1) == 0 ? -1 : 1;
            double w = (i & 4) == 0 ? -1 : 1;
            v[i] = vertex(x + c * u - s * w, (i & 2) == 0 ? y - halfHeight : y + halfHeight, z + s * u + c * w);
        }
        quad(v[0], v[1], v[5], v[4]);
        quad(v[2], v[6], v[7], v[3]);
        quad(v[0], v[4], v[6], v[2]);
        quad(v[1], v[3], v[7], v[5]);
        quad(v[0], v[2], v[3], v[1]);
        quad(v[4], v[5], v[7], v[6]);
    }

    private void terrain(int side) {
        int first = positionEnd / 3;
        for (int i = 0; i <= side; i++) {
            for (int j = 0; j <= side; j++) {
                double x = -1 + 2.0 * i / side;
                double z = -1 + 2.0 * j / side;
                vertex(x, -0.85 + 0.12 * noise(3 * x, 3 * z, 0.7), z);
            }
        }
        for (int i = 0; i < side; i++) {
            for (int j = 0; j < side; j++) {
                int a = first + i * (side + 1) + j;
                quad(a, a + 1, a + side + 2, a + side + 1);
            }
        }
    }

    private void sphere(double cx, double cy, double cz, double radius, int rings, int seed) {
        int sectors = 2 * rings;
        int first = positionEnd / 3;
        for (int i = 0; i <= rings; i++) {
            double theta = Math.PI * i / rings;
            for (int j = 0; j < sectors; j++) {
                double phi = 2 * Math.PI * j / sectors;
                double x = Math.sin(theta) * Math.cos(phi);
                double y = Math.cos(theta);
                double z = Math.sin(theta) * Math.sin(phi);
                double r = radius * (1 + 0.15 * noise(4 * x + seed, 4 * y, 4 * z));
                vertex(cx + r * x, cy + r * y, cz + r * z);
            }
        }
        for (int i = 0; i < rings; i++) {
            for (int j = 0; j < sectors; j++) {
                int next = (j + 1) % sectors;
                int a = first + i * sectors + j;
                int b = first + i * sectors + next;
                if (i > 0) {
                    triangle(a, b, b + sectors);
                }
                if (i < rings - 1) {
                    triangle(a, b + sectors, a + sectors);
                }
            }
        }
    }

    /** Four octaves of value noise in [-1, 1]. */
    private static double noise(double x, double y, double z) {
        double sum = 0;
        double amplitude = 0.5;
        double frequency = 1;
        for (int octave = 0; octave < 4; octave++) {
            sum += amplitude * valueNoise(frequency * x, frequency * y, frequency * z);
            amplitude *= 0.5;
            frequency *= 2.03;
        }
        return sum;
    }

    private static double valueNoise(double x, double y, double z) {
        int ix = (int) Math.floor(x);
        int iy = (int) Math.floor(y);
        int iz = (int) Math.floor(z);
        double fx = smooth(x - ix);
        double fy = smooth(y - iy);
        double fz = smooth(z - iz);
        double sum = 0;
        for (int corner = 0; corner < 8; corner++) {
            int cx = corner & 1;
            int cy = corner >> 1 & 1;
            int cz = corner >> 2;
            double weight = (cx == 0 ? 1 - fx : fx) * (cy == 0 ? 1 - fy : fy) * (cz == 0 ? 1 - fz : fz);
            sum += weight * hash(ix + cx, iy + cy, iz + cz);
        }
        return sum;
    }

    private static double smooth(double t) {
        return t * t * (3 - 2 * t);
    }

    private static double hash(int x, int y, int z) {
        int h = x * 0x9e3779b1 ^ y * 0x85ebca77 ^ z * 0xc2b2ae3d;
        h ^= h >>> 15;
        h *= 0x2c1b3c6d;
        h ^= h >>> 12;
        h *= 0x297a2d39;
        h ^= h >>> 15;
        return h * 0x1p-31;
    }
}
