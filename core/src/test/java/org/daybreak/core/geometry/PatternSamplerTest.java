package org.daybreak.core.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.daybreak.core.math.Transform;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.Significance;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Surfaces whose brightness varies: points are drawn from where they are bright. */
class PatternSamplerTest {
    /** False-alarm rate of each kind of test. */
    private static final double SIGNIFICANCE = 1e-4;

    private static final Transform PLACE = Transform.translate(0.3, -0.2, 0.5)
            .multiply(Transform.rotate(1, 2, 0.5, 40))
            .multiply(Transform.scale(1.2, 0.7, 1));

    /** Bright in one corner, black in half of the square. */
    private static final SurfaceBrightness PATTERN = new SurfaceBrightness() {
        @Override
        public double at(double u, double v) {
            return u < 0.5 ? 0 : u > 0.75 && v < 0.25 ? 20 : u * v;
        }

        @Override
        public int detail() {
            return 8;
        }
    };

    /** The square of 4 × 4 × 2 triangles with the texture coordinates of the rectangle. */
    private static TriangleMesh grid() {
        int n = 4;
        float[] positions = new float[3 * (n + 1) * (n + 1)];
        float[] uvs = new float[2 * (n + 1) * (n + 1)];
        for (int i = 0; i < (n + 1) * (n + 1); i++) {
            uvs[2 * i] = (float) (i % (n + 1)) / n;
            uvs[2 * i + 1] = (float) Math.floorDiv(i, n + 1) / n;
            positions[3 * i] = 2 * uvs[2 * i] - 1;
            positions[3 * i + 1] = 2 * uvs[2 * i + 1] - 1;
        }
        int[] triangles = new int[6 * n * n];
        for (int cell = 0; cell < n * n; cell++) {
            int a = cell / n * (n + 1) + cell % n;
            int[] corners = {a, a + 1, a + n + 2, a, a + n + 2, a + n + 1};
            System.arraycopy(corners, 0, triangles, 6 * cell, 6);
        }
        return new TriangleMesh(positions, triangles, null, uvs);
    }

    record Case(String name, SurfaceSampler sampler) {
        @Override
        public String toString() {
            return name;
        }
    }

    static List<Case> cases() {
        return List.of(
                new Case("rectangle", SurfaceSamplers.of(new Rectangle(), PLACE, false, 0, PATTERN)),
                new Case("mesh", SurfaceSamplers.of(grid(), PLACE, false, 100, PATTERN)));
    }

    /** Completes a point at texture coordinates as a hit would be. */
    private static void at(Case c, double u, double v, SurfacePoint out) {
        double[] d = new double[3];
        PLACE.applyPoint(2 * u - 1, 2 * v - 1, 0, d);
        out.x = d[0];
        out.y = d[1];
        out.z = d[2];
        PLACE.applyNormal(0, 0, 1, d);
        double length = Math.sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
        out.gx = d[0] / length;
        out.gy = d[1] / length;
        out.gz = d[2] / length;
        out.u = u;
        out.v = v;
        int column = (int) (4 * u);
        int row = (int) (4 * v);
        boolean lower = 4 * u - column >= 4 * v - row;
        out.primitive = c.name().equals("mesh") ? 100 + 2 * (4 * row + column) + (lower ? 0 : 1) : 0;
    }

    @ParameterizedTest
    @MethodSource("cases")
    void pointsFollowTheirDensity(Case c) {
        SurfacePoint point = new SurfacePoint();
        SurfacePoint other = new SurfacePoint();
        double area = c.sampler.area();
        ChiSquareTest.ofPoints(
                        c.name,
                        (u, v, w, xy) -> {
                            double density = c.sampler.sampleArea(u, v, point);
                            assertEquals(density, c.sampler.areaDensity(point), 1e-9 * density);
                            xy[0] = point.u;
                            xy[1] = point.v;
                            return density > 0;
                        },
                        (u, v) -> {
                            at(c, u, v, other);
                            return area * c.sampler.areaDensity(other);
                        },
                        0,
                        1,
                        0,
                        1)
                .cells(16, 16)
                .depth(3, 8)
                .samples(50_000)
                .assertAgrees(Significance.sidak(SIGNIFICANCE, 2));
    }

    @ParameterizedTest
    @MethodSource("cases")
    void directionsFollowTheirDensity(Case c) {
        SurfacePoint point = new SurfacePoint();
        SurfacePoint other = new SurfacePoint();
        double[] d = new double[3];
        for (double[] local : new double[][] {{0.2, 0.1, 0.5}, {3, -2, 6}}) {
            PLACE.applyPoint(local[0], local[1], local[2], d);
            double px = d[0];
            double py = d[1];
            double pz = d[2];
            double area = c.sampler.area();
            // In texture coordinates: a density per solid angle times cos/d² times the area of the unit square.
            ChiSquareTest.ofPoints(
                            c.name,
                            (u, v, w, xy) -> {
                                double density = c.sampler.sampleDirection(px, py, pz, u, v, point);
                                if (density > 0) {
                                    double stated = density(c, px, py, pz, point);
                                    assertEquals(density, stated, 1e-6 * density);
                                }
                                xy[0] = point.u;
                                xy[1] = point.v;
                                return density > 0;
                            },
                            (u, v) -> {
                                at(c, u, v, other);
                                double x = other.x - px;
                                double y = other.y - py;
                                double z = other.z - pz;
                                double squared = x * x + y * y + z * z;
                                double cosine = -other.geometricCosine(x, y, z) / Math.sqrt(squared);
                                return area * density(c, px, py, pz, other) * cosine / squared;
                            },
                            0,
                            1,
                            0,
                            1)
                    .cells(16, 16)
                    .depth(3, 8)
                    .samples(50_000)
                    .assertAgrees(Significance.sidak(SIGNIFICANCE, 4));
        }
    }

    private static double density(Case c, double px, double py, double pz, SurfacePoint on) {
        double x = on.x - px;
        double y = on.y - py;
        double z = on.z - pz;
        double distance = Math.sqrt(x * x + y * y + z * z);
        return c.sampler.directionDensity(px, py, pz, on, x / distance, y / distance, z / distance);
    }

    /** From afar, brightness over density hardly varies for a rectangle, and less than without the pattern for a mesh. */
    @Test
    void brightPlacesAreFoundFirst() {
        RandomStream random = new RandomStream(3, StreamDomain.SELF_CHECK, 0, 0);
        SurfacePoint point = new SurfacePoint();
        double truth = 0;
        for (int i = 0; i < 64 * 64; i++) {
            truth += PATTERN.at((i % 64 + 0.5) / 64, (Math.floorDiv(i, 64) + 0.5) / 64) / (64 * 64);
        }
        double[] spreads = new double[3];
        SurfaceSampler plain = SurfaceSamplers.of(new Rectangle(), PLACE, false);
        SurfaceSampler[] samplers = {cases().get(0).sampler, cases().get(1).sampler, plain};
        for (int k = 0; k < 3; k++) {
            Moments moments = new Moments();
            for (int i = 0; i < 20_000; i++) {
                double density = samplers[k].sampleArea(random.nextDouble(), random.nextDouble(), point);
                moments.add(PATTERN.at(point.u, point.v) / (density * plain.area()));
            }
            ZTest.assertNotRejected("mean", ZTest.oneSample(moments, truth), Significance.sidak(SIGNIFICANCE, 3));
            spreads[k] = moments.variance();
        }
        assertTrue(spreads[0] < 0.05 * spreads[2], spreads[0] + " of " + spreads[2]);
        assertTrue(spreads[1] < 0.2 * spreads[2], spreads[1] + " of " + spreads[2]);
    }
}
