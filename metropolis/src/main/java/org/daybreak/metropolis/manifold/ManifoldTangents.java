package org.daybreak.metropolis.manifold;

import java.util.Arrays;
import org.daybreak.core.geometry.SurfaceDifferential;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.math.Frame;
import org.daybreak.core.scene.Scene;

/**
 * How the vertices of a specular chain move with its end while its start is fixed, to first order (Jakob and Marschner 2012). Owned
 * by one worker.
 *
 * <p>At vertex i with the unit directions w to the vertex before and w′ to the next one, refractive indices η and η′ on their sides,
 * and the shading frame (s, t, n), a delta lobe means that h = η w + η′ w′ is along n:
 *
 * <pre>C_i(x_{i−1}, x_i, x_{i+1}) = (s·h, t·h) = 0</pre>
 *
 * This is their half vector without its normalisation, which is a factor that does not matter where C = 0, and is not defined where
 * light passes straight on. With A_i, B_i, D_i the 2×2 derivatives of C_i by the positions of the three vertices in the tangents of
 * {@link SurfaceDifferential}, which are orthonormal, the change of all vertices with x_b solves a block-tridiagonal
 * system, here by elimination from the start: dx_i = P_i dx_{i+1}, P_i = −(B_i + A_i P_{i−1})⁻¹ D_i.
 */
public final class ManifoldTangents {
    /** A 2×2 matrix whose determinant is this small a part of its largest entry squared is taken as singular. */
    private static final double SINGULAR = 1e-13;

    private SurfaceDifferential[] differentials = new SurfaceDifferential[0];

    /** P_i by rows, four numbers each. */
    private double[] transfer = new double[0];

    private final Frame endFrame = new Frame();
    private int length;
    private double determinant;
    private double startPerFirst;

    /** A step of x₁ along its two tangents. */
    private double stepU;

    private double stepV;

    /** Unit direction from the vertex in hand to the one before, and one over the distance: 0 for parallel rays. */
    private double backX;

    private double backY;
    private double backZ;
    private double backInverse;

    /** The same towards the next one. */
    private double nextX;

    private double nextY;
    private double nextZ;
    private double nextInverse;

    /** Creates tangents of no chain yet. */
    public ManifoldTangents() {}

    /**
     * Computes the tangents of a chain that {@link SpecularManifold#follow} has completed.
     *
     * @return false if some vertex has no derivatives or does not change differentiably with the end; the tangents are undefined then
     */
    public boolean set(Scene scene, SpecularChain chain) {
        length = chain.length();
        reserve();
        for (int i = 0; i < length; i++) {
            if (!scene.differential(chain.points[i], differentials[i])) {
                return false;
            }
        }
        determinant = 1;
        for (int i = 0; i < length; i++) {
            setBack(chain, i);
            setNext(chain, i);
            if (i == 0) {
                double cosine = Math.abs(chain.points[0].geometricCosine(backX, backY, backZ));
                startPerFirst = chain.start.parallel ? cosine : cosine * backInverse * backInverse;
            }
            if (!eliminate(chain, i)) {
                return false;
            }
        }
        return determinant < Double.POSITIVE_INFINITY;
    }

    /** Area at the first vertex per area at the end, or per solid angle if the end is a direction: |det ∂x₁/∂x_b|. */
    public double firstPerEnd() {
        return determinant;
    }

    /**
     * The generalized geometry term without the cosine at the start: |dω_a/dA_b|. Solid angle at the start, or
     * area across the rays if it is a direction, per area at the end, or per solid angle if that is a direction. For
     * a chain without specular vertices it would be cos θ_b/d².
     */
    public double startPerEnd() {
        return determinant * startPerFirst;
    }

    /** Solves for the step of x₁ that moves the end by a vector in its tangent plane. */
    void solve(double x, double y, double z) {
        double u = x * endFrame.sx + y * endFrame.sy + z * endFrame.sz;
        double v = x * endFrame.tx + y * endFrame.ty + z * endFrame.tz;
        for (int i = length - 1; i >= 0; i--) {
            double oldU = u;
            u = transfer[4 * i] * oldU + transfer[4 * i + 1] * v;
            v = transfer[4 * i + 2] * oldU + transfer[4 * i + 3] * v;
        }
        stepU = u;
        stepV = v;
    }

    /** The step of the first vertex in world space, as x, y or z component. */
    double step(int component) {
        SurfaceDifferential d = differentials[0];
        return switch (component) {
            case 0 -> stepU * d.pux + stepV * d.pvx;
            case 1 -> stepU * d.puy + stepV * d.pvy;
            default -> stepU * d.puz + stepV * d.pvz;
        };
    }

    private void reserve() {
        int old = differentials.length;
        if (length <= old) {
            return;
        }
        int capacity = Math.max(length, 2 * old);
        differentials = Arrays.copyOf(differentials, capacity);
        for (int i = old; i < capacity; i++) {
            differentials[i] = new SurfaceDifferential();
        }
        transfer = new double[4 * capacity];
    }

    private void setBack(SpecularChain chain, int i) {
        if (i > 0) {
            backInverse = nextInverse;
            backX = -nextX;
            backY = -nextY;
            backZ = -nextZ;
        } else if (chain.start.parallel) {
            backInverse = 0;
            backX = chain.start.dx;
            backY = chain.start.dy;
            backZ = chain.start.dz;
        } else {
            SurfacePoint here = chain.points[0];
            SurfacePoint start = chain.start.point;
            double x = start.x - here.x;
            double y = start.y - here.y;
            double z = start.z - here.z;
            backInverse = 1 / Math.sqrt(x * x + y * y + z * z);
            backX = x * backInverse;
            backY = y * backInverse;
            backZ = z * backInverse;
        }
    }

    private void setNext(SpecularChain chain, int i) {
        boolean last = i + 1 == length;
        if (last && chain.end.parallel) {
            nextInverse = 0;
            nextX = chain.end.dx;
            nextY = chain.end.dy;
            nextZ = chain.end.dz;
        } else {
            SurfacePoint here = chain.points[i];
            SurfacePoint next = last ? chain.end.point : chain.points[i + 1];
            double x = next.x - here.x;
            double y = next.y - here.y;
            double z = next.z - here.z;
            nextInverse = 1 / Math.sqrt(x * x + y * y + z * z);
            nextX = x * nextInverse;
            nextY = y * nextInverse;
            nextZ = z * nextInverse;
        }
        if (last) {
            if (chain.end.surface) {
                endFrame.set(chain.end.point.gx, chain.end.point.gy, chain.end.point.gz);
            } else {
                endFrame.set(nextX, nextY, nextZ);
            }
        }
    }

    /** Computes P_i. */
    private boolean eliminate(SpecularChain chain, int i) {
        SurfacePoint x = chain.points[i];
        SurfaceDifferential d = differentials[i];
        double backS = x.localX(backX, backY, backZ);
        double backT = x.localY(backX, backY, backZ);
        double nextS = x.localX(nextX, nextY, nextZ);
        double nextT = x.localY(nextX, nextY, nextZ);
        double eta = chain.eta[i];
        double back = eta * backInverse;
        double next = nextInverse;
        double along = eta * x.localZ(backX, backY, backZ) + x.localZ(nextX, nextY, nextZ);
        double backU = backX * d.pux + backY * d.puy + backZ * d.puz;
        double backV = backX * d.pvx + backY * d.pvy + backZ * d.pvz;
        double nextU = nextX * d.pux + nextY * d.puy + nextZ * d.puz;
        double nextV = nextX * d.pvx + nextY * d.pvy + nextZ * d.pvz;
        // B: the ends of both directions move against the vertex, and with the normal turn s and t, ds·n = −s·dn.
        double m00 = back * backU * backS
                + next * nextU * nextS
                - (back + next) * x.localX(d.pux, d.puy, d.puz)
                - along * x.localX(d.nux, d.nuy, d.nuz);
        double m01 = back * backV * backS
                + next * nextV * nextS
                - (back + next) * x.localX(d.pvx, d.pvy, d.pvz)
                - along * x.localX(d.nvx, d.nvy, d.nvz);
        double m10 = back * backU * backT
                + next * nextU * nextT
                - (back + next) * x.localY(d.pux, d.puy, d.puz)
                - along * x.localY(d.nux, d.nuy, d.nuz);
        double m11 = back * backV * backT
                + next * nextV * nextT
                - (back + next) * x.localY(d.pvx, d.pvy, d.pvz)
                - along * x.localY(d.nvx, d.nvy, d.nvz);
        if (i > 0) {
            SurfaceDifferential b = differentials[i - 1];
            double bu = backX * b.pux + backY * b.puy + backZ * b.puz;
            double bv = backX * b.pvx + backY * b.pvy + backZ * b.pvz;
            double a00 = back * (x.localX(b.pux, b.puy, b.puz) - bu * backS);
            double a01 = back * (x.localX(b.pvx, b.pvy, b.pvz) - bv * backS);
            double a10 = back * (x.localY(b.pux, b.puy, b.puz) - bu * backT);
            double a11 = back * (x.localY(b.pvx, b.pvy, b.pvz) - bv * backT);
            int p = 4 * (i - 1);
            m00 += a00 * transfer[p] + a01 * transfer[p + 2];
            m01 += a00 * transfer[p + 1] + a01 * transfer[p + 3];
            m10 += a10 * transfer[p] + a11 * transfer[p + 2];
            m11 += a10 * transfer[p + 1] + a11 * transfer[p + 3];
        }
        double largest = Math.max(Math.max(Math.abs(m00), Math.abs(m01)), Math.max(Math.abs(m10), Math.abs(m11)));
        double det = m00 * m11 - m01 * m10;
        if (!(Math.abs(det) > SINGULAR * largest * largest)) {
            return false;
        }
        boolean last = i + 1 == length;
        SurfaceDifferential n = last ? d : differentials[i + 1];
        double ux = last ? endFrame.sx : n.pux;
        double uy = last ? endFrame.sy : n.puy;
        double uz = last ? endFrame.sz : n.puz;
        double vx = last ? endFrame.tx : n.pvx;
        double vy = last ? endFrame.ty : n.pvy;
        double vz = last ? endFrame.tz : n.pvz;
        // Of a direction the derivative is that on the unit sphere.
        double scale = last && chain.end.parallel ? 1 : nextInverse;
        double du = nextX * ux + nextY * uy + nextZ * uz;
        double dv = nextX * vx + nextY * vy + nextZ * vz;
        double d00 = scale * (x.localX(ux, uy, uz) - du * nextS);
        double d01 = scale * (x.localX(vx, vy, vz) - dv * nextS);
        double d10 = scale * (x.localY(ux, uy, uz) - du * nextT);
        double d11 = scale * (x.localY(vx, vy, vz) - dv * nextT);
        double inverse = -1 / det;
        int p = 4 * i;
        transfer[p] = (m11 * d00 - m01 * d10) * inverse;
        transfer[p + 1] = (m11 * d01 - m01 * d11) * inverse;
        transfer[p + 2] = (m00 * d10 - m10 * d00) * inverse;
        transfer[p + 3] = (m00 * d11 - m10 * d01) * inverse;
        determinant *= Math.abs((d00 * d11 - d01 * d10) / det);
        return true;
    }
}
