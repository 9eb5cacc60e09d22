package org.daybreak.metropolis.strategy;

import org.daybreak.core.math.Densities;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.metropolis.chains.Outcome;

/**
 * Tilts the edge that leads from a diffuse vertex or the light through ideal reflections and refractions to what the lens sees, follows
 * it and joins its end to the lens: a path …(D|L)S*DE (the thesis' class of that name; Veach 1997, §11.4.3).
 *
 * <p>The range of angles is that of image distances between the given bounds, scaled with the length of the eye's edge over that
 * of the piece. It depends on the path, so T is not symmetric.
 */
public final class CausticPerturbationStrat extends MutationStrategy {
    private final double smallest;
    private final double largest;

    /**
     * Creates the strategy.
     *
     * @param weight relative probability of choosing it
     * @param smallest r₁, in pixels
     * @param largest r₂, in pixels
     */
    public CausticPerturbationStrat(double weight, double smallest, double largest) {
        super(weight);
        this.smallest = smallest;
        this.largest = largest;
    }

    @Override
    public String id() {
        return "caustic";
    }

    @Override
    protected boolean applies(LightPath x) {
        int k = x.length - 1;
        if (k < 2 || !x.joins(k - 1) || x.filmPerSolidAngle == 0) {
            return false;
        }
        return LensPiece.nextDiffuse(x, k - 1) > 0 || !x.infinite;
    }

    /** Factor from distances on the film to angles at a vertex. */
    private static double scale(LightPath x, int start) {
        int k = x.length - 1;
        double length = 0;
        for (int i = start; i < k - 1; i++) {
            length += Math.sqrt(x.squared[i]);
        }
        return Math.sqrt(x.squared[k - 1]) / (length * Math.sqrt(x.filmPerSolidAngle));
    }

    @Override
    public boolean propose(
            LightPath x, LightPath y, Move move, PathBuilder builder, RandomStream random, long stratum) {
        int k = x.length - 1;
        int start = LensPiece.nextDiffuse(x, k - 1);
        move.set(start, k, k);
        y.length = x.length;
        y.reserve(y.length);
        y.copy(x, 0, start + 1, 0);
        y.copyLight(x);
        y.copyLens(x);
        if (!Tilt.tilt(
                x.dx[start], x.dy[start], x.dz[start], smallest, largest, scale(x, start), random, builder.walk())) {
            return builder.fail(Outcome.MISSED);
        }
        if (!builder.walk().traceToEye(y, start, random)) {
            return false;
        }
        for (int i = start + 1; i < k - 1; i++) {
            y.lobe[i] = x.lobe[i];
            if (!builder.walk().follow(y, i, false) || !builder.walk().traceToEye(y, i, random)) {
                return false;
            }
        }
        if (!y.bsdfs[k - 1].connectable()) {
            return builder.fail(Outcome.KIND_CHANGED);
        }
        if (!builder.lens().aim(y, k)) {
            return false;
        }
        y.clear[k - 1] = 1;
        y.setEdge(k - 1);
        return builder.contribution().measure(y, start, k) && builder.edges().reveal(y, k - 1);
    }

    @Override
    public double transition(LightPath from, LightPath to, Move move, PathBuilder builder) {
        int start = move.kept;
        double density = Tilt.density(
                from.dx[start],
                from.dy[start],
                from.dz[start],
                to.dx[start],
                to.dy[start],
                to.dz[start],
                smallest,
                largest,
                scale(from, start));
        density *= Densities.solidAngleToArea(
                1, to.squared[start], to.points[start + 1].geometricCosine(to.dx[start], to.dy[start], to.dz[start]));
        density *= to.clear[start] * to.opacity[start + 1];
        for (int i = start + 2; i < to.length - 1; i++) {
            density *= to.fromLight[i] * to.clear[i - 1] * to.opacity[i];
        }
        return density;
    }
}
