package org.daybreak.bidirectional;

import org.daybreak.core.camera.Camera;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.scene.Scene;

/**
 * The geometry of a full path x₀…x_k, x₀ on the light and x_k on the lens: what is left of a {@link Contribution} when one forgets
 * how it was found.
 *
 * <p>Edges have the unit directions that the path was found with. Walks start rays a little above a surface, so that the line
 * from point to point is not quite the ray's: densities would differ by more than rounding.
 */
final class FullPath {
    final Scene scene;
    final Camera camera;
    final int lightIndex;

    /** True if x₀ lies at infinity, where {@link #edges}[0] is all there is of it. */
    final boolean infinite;

    final SurfacePoint[] points;

    /** Unit direction from x_i to x_{i+1}. */
    final double[][] edges;

    /** Squared distance of x_i and x_{i+1}; infinite for the edge from infinity. */
    final double[] squares;

    /** True if the path scatters at x_i by a delta lobe. */
    final boolean[] delta;

    FullPath(Scene scene, Camera camera, Contribution found) {
        this.scene = scene;
        this.camera = camera;
        lightIndex = found.lightIndex;
        infinite = scene.light(lightIndex).isInfinite();
        int s = found.s;
        int t = found.t;
        int k = s + t - 1;
        points = new SurfacePoint[k + 1];
        edges = new double[k][];
        squares = new double[k];
        delta = new boolean[k + 1];
        for (int i = 0; i <= k; i++) {
            points[i] = new SurfacePoint();
            if (i == k && t == 0) {
                points[i].set(found.lens.point);
            } else if (i >= s && t > 1) {
                points[i].set(found.eye.points[k - i]);
            } else if (i >= s) {
                points[i].set(found.lens.point);
            } else if (s == 1 && t > 1) {
                points[i].set(found.lightSample.point);
            } else {
                points[i].set(found.light.points[i]);
            }
        }
        for (int i = 0; i < k; i++) {
            if (i + 1 == k && t <= 1) {
                edges[i] = new double[] {found.lens.wiX, found.lens.wiY, found.lens.wiZ};
            } else if (i + 1 < s) {
                PathValues light = found.light;
                edges[i] = new double[] {-light.backX[i + 1], -light.backY[i + 1], -light.backZ[i + 1]};
            } else if (i >= s) {
                PathValues eye = found.eye;
                edges[i] = new double[] {eye.backX[k - i], eye.backY[k - i], eye.backZ[k - i]};
            } else if (s == 1) {
                edges[i] = new double[] {-found.lightSample.wiX, -found.lightSample.wiY, -found.lightSample.wiZ};
            } else {
                edges[i] = between(points[i], points[i + 1]);
            }
            squares[i] = i == 0 && infinite ? Double.POSITIVE_INFINITY : square(points[i], points[i + 1]);
        }
        for (int i = 1; i < k; i++) {
            delta[i] = i < s - 1 ? found.light.delta[i] : i > s && found.eye.delta[k - i];
        }
    }

    /** Number of edges k. */
    int edgeCount() {
        return edges.length;
    }

    /** Whether the edge before x_i can join two subpaths. */
    boolean joinable(int i) {
        return !delta[i - 1] && !delta[i];
    }

    private static double square(SurfacePoint a, SurfacePoint b) {
        double x = b.x - a.x;
        double y = b.y - a.y;
        double z = b.z - a.z;
        return x * x + y * y + z * z;
    }

    private static double[] between(SurfacePoint a, SurfacePoint b) {
        double length = Math.sqrt(square(a, b));
        return new double[] {(b.x - a.x) / length, (b.y - a.y) / length, (b.z - a.z) / length};
    }
}
