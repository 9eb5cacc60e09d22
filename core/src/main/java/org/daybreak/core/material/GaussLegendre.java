package org.daybreak.core.material;

/** Gauss–Legendre quadrature on [0,1], for tables built at construction. */
final class GaussLegendre {
    private GaussLegendre() {}

    /** The nodes of the rule with {@code n} nodes on [0,1], ascending. */
    static double[] nodes(int n) {
        double[] nodes = new double[n];
        for (int i = 0; i < n; i++) {
            double x = -Math.cos(Math.PI * (i + 0.75) / (n + 0.5));
            // Newton from Tricomi's estimate converges quadratically; five steps are more than enough for any n.
            for (int step = 0; step < 5; step++) {
                x -= legendre(n, x) / legendreDerivative(n, x);
            }
            nodes[i] = 0.5 * (1 + x);
        }
        return nodes;
    }

    /** The weights that belong to {@link #nodes}; they add up to 1. */
    static double[] weights(double[] nodes) {
        double[] weights = new double[nodes.length];
        for (int i = 0; i < nodes.length; i++) {
            double x = 2 * nodes[i] - 1;
            double derivative = legendreDerivative(nodes.length, x);
            weights[i] = 1 / ((1 - x * x) * derivative * derivative);
        }
        return weights;
    }

    private static double legendre(int n, double x) {
        double previous = 0;
        double current = 1;
        for (int k = 1; k <= n; k++) {
            double next = ((2 * k - 1) * x * current - (k - 1) * previous) / k;
            previous = current;
            current = next;
        }
        return current;
    }

    private static double legendreDerivative(int n, double x) {
        return n * (x * legendre(n, x) - legendre(n - 1, x)) / (x * x - 1);
    }
}
