package org.daybreak.core.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.Stream;
import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class SphericalRectangleTest {
    /** False-alarm rate of each statistical assertion. */
    private static final double SIGNIFICANCE = 1e-4;

    private static final double[] CORNER = {-1, -2, 3};
    private static final double[] EDGE_X = {2, 0, 0};
    private static final double[] EDGE_Y = {0, 4, 0};

    private final SphericalRectangle rectangle = new SphericalRectangle();

    /** Points that see the rectangle of edges 2 and 4 in the plane z = 3 about the z axis. */
    static Stream<double[]> viewpoints() {
        return Stream.of(
                new double[] {0, 0, 0},
                new double[] {0.3, -0.4, 6},
                new double[] {0.2, 0.1, 2.9},
                new double[] {0.9, 1.9, 2.9},
                new double[] {3, 1, 2},
                new double[] {1, 0, 2},
                new double[] {-1, -2, 4},
                new double[] {2, 3, 2.5},
                new double[] {-5, 7, -2});
    }

    @ParameterizedTest
    @MethodSource("viewpoints")
    void directionsFollowTheDensity(double[] from) {
        rectangle.set(CORNER, EDGE_X, EDGE_Y, from[0], from[1], from[2]);
        double[] p = new double[3];
        ChiSquareTest.ofDirections(
                        "spherical rectangle",
                        (u, v, w, dest) -> {
                            double density = rectangle.sample(u, v, p);
                            direction(from, p, dest);
                            assertEquals(density, rectangle.density(dest[0], dest[1], dest[2]), 1e-9 * density);
                            return true;
                        },
                        rectangle::density)
                .depth(3, 9)
                .samples(100_000)
                .assertAgrees(SIGNIFICANCE);
    }

    @ParameterizedTest
    @MethodSource("viewpoints")
    void solidAngleIsTheIntegralOverTheArea(double[] from) {
        rectangle.set(CORNER, EDGE_X, EDGE_Y, from[0], from[1], from[2]);
        assertEquals(solidAngleByQuadrature(from), rectangle.solidAngle(), 1e-9);
    }

    @Test
    void solidAnglesInClosedForm() {
        // A face of a cube from its centre: a sixth of the sphere.
        rectangle.set(new double[] {-1, -1, 1}, new double[] {2, 0, 0}, new double[] {0, 2, 0}, 0, 0, 0);
        assertEquals(4 * Math.PI / 6, rectangle.solidAngle(), 1e-15);
        // The same face at any scale.
        rectangle.set(new double[] {-1e20, -1e20, 1e20}, new double[] {2e20, 0, 0}, new double[] {0, 2e20, 0}, 0, 0, 0);
        assertEquals(4 * Math.PI / 6, rectangle.solidAngle(), 1e-15);
        // Close above the middle: nearly the half sphere, on either side.
        rectangle.set(CORNER, EDGE_X, EDGE_Y, 0, 0, 3 + 1e-6);
        assertEquals(2 * Math.PI, rectangle.solidAngle(), 1e-5);
        rectangle.set(CORNER, EDGE_X, EDGE_Y, 0, 0, 3 - 1e-6);
        assertEquals(2 * Math.PI, rectangle.solidAngle(), 1e-5);
        // Far away on the axis: area / distance².
        rectangle.set(CORNER, EDGE_X, EDGE_Y, 0, 0, -1e4);
        assertEquals(8 / 1.00060009e8, rectangle.solidAngle(), 1e-14);
    }

    @Test
    void densityIsZeroBesideTheRectangle() {
        rectangle.set(CORNER, EDGE_X, EDGE_Y, 0, 0, 0);
        assertTrue(rectangle.density(0, 0, 1) > 0);
        assertEquals(rectangle.density(0, 0, 1), rectangle.density(0, 0, 7));
        assertEquals(0, rectangle.density(0, 0, -1));
        assertEquals(0, rectangle.density(1.01, 0, 3));
        assertEquals(0, rectangle.density(0, 2.01, 3));
        assertEquals(0, rectangle.density(1, 0, 0));
    }

    @Test
    void edgeOnRectanglesAreNotSampled() {
        for (double[] from : new double[][] {{5, 0, 3}, {0, 0, 3}, {-1, -2, 3}, {-1, 0, 3}}) {
            rectangle.set(CORNER, EDGE_X, EDGE_Y, from[0], from[1], from[2]);
            assertEquals(0, rectangle.sample(0.5, 0.5, new double[3]));
            assertEquals(0, rectangle.density(-1, 0, 0));
            assertEquals(0, rectangle.solidAngle());
        }
    }

    /** Grazing and distant views, where the solid angle is small or ill-conditioned: ∫ dω stays that of the area. */
    @Test
    void extremeViewsStayUnbiased() {
        double[][] viewpoints = {
            {0, 0, -1e3}, {0, 0, -1e5}, {0, 0, 1e9}, {40, 3, 3 + 1e-3}, {1.0001, 0, 3 - 1e-7}, {1e4, 2e4, -1e4}
        };
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        double[] p = new double[3];
        double[] d = new double[3];
        double[] pValues = new double[2 * viewpoints.length];
        for (int i = 0; i < viewpoints.length; i++) {
            double[] from = viewpoints[i];
            rectangle.set(CORNER, EDGE_X, EDGE_Y, from[0], from[1], from[2]);
            Moments x = new Moments();
            Moments y = new Moments();
            for (int n = 0; n < 20_000; n++) {
                double density = rectangle.sample(random.nextDouble(), random.nextDouble(), p);
                assertTrue(density > 0 && density < Double.POSITIVE_INFINITY);
                assertTrue(Math.abs(p[0]) <= 1 + 1e-12 && Math.abs(p[1]) <= 2 + 1e-12);
                assertEquals(3, p[2], 1e-12 * Math.max(1, Math.abs(from[2])));
                double squaredDistance = direction(from, p, d);
                // An integral over the area: dA = r² / |cos| dω, with cos from the exact height.
                double cosine = Math.abs(3 - from[2]) / Math.sqrt(squaredDistance);
                double areaPerDensity = squaredDistance / cosine / density;
                x.add(areaPerDensity * (p[0] + 2));
                y.add(areaPerDensity * (p[1] + 3));
            }
            pValues[2 * i] = ZTest.oneSample(x, 16);
            pValues[2 * i + 1] = ZTest.oneSample(y, 24);
        }
        ZTest.assertNoneRejected("area and its moments", pValues, SIGNIFICANCE);
    }

    private static double direction(double[] from, double[] to, double[] dest) {
        double x = to[0] - from[0];
        double y = to[1] - from[1];
        double z = to[2] - from[2];
        double squared = x * x + y * y + z * z;
        double length = Math.sqrt(squared);
        dest[0] = x / length;
        dest[1] = y / length;
        dest[2] = z / length;
        return squared;
    }

    /** Gauss-Legendre quadrature of order 3 on 300 × 300 parts. */
    private static double solidAngleByQuadrature(double[] from) {
        int n = 300;
        double[] nodes = {0.5 - Math.sqrt(0.15), 0.5, 0.5 + Math.sqrt(0.15)};
        double[] weights = {5.0 / 18, 8.0 / 18, 5.0 / 18};
        double height = 3 - from[2];
        double sum = 0;
        for (int i = 0; i < 3 * n; i++) {
            int column = i / 3;
            double x = -1 + 2 * (column + nodes[i % 3]) / n - from[0];
            for (int j = 0; j < 3 * n; j++) {
                int row = j / 3;
                double y = -2 + 4 * (row + nodes[j % 3]) / n - from[1];
                double squared = x * x + y * y + height * height;
                sum += weights[i % 3] * weights[j % 3] * Math.abs(height) / (squared * Math.sqrt(squared));
            }
        }
        return sum * 8 / n / n;
    }
}
