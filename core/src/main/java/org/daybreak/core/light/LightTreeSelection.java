package org.daybreak.core.light;

import java.util.Arrays;
import java.util.List;
import org.daybreak.core.geometry.EmissionBounds;
import org.daybreak.core.geometry.EmitterTree;
import org.daybreak.core.math.Bounds;

/**
 * Chooses among many lights in time logarithmic in their number: by an {@link EmitterTree} over those with a place down to a leaf
 * of few, and in the leaf by the irradiance that each would cause, as {@link ImportanceLightSelection} does. Lights at infinity
 * stand beside the tree and are expected to be few.
 *
 * <p>Small parts of the choices between tree and distant lights and within a leaf are uniform among those that can contribute.
 */
public final class LightTreeSelection implements LightSelection {
    /** Lights in a leaf: looking at each costs as much as a level of the tree and tells much more. */
    private static final int LEAF = 4;

    /** Part of the choices in a leaf that does not follow the estimates. */
    private static final double UNIFORM_SHARE = 0.05;

    /** The same for the choice between tree and distant lights, where one of the estimates is coarse. */
    private static final double UNIFORM_SHARE_OF_PARTS = 0.2;

    private static final double LARGEST = 1e200;

    private final Light[] lights;
    private final EmitterTree tree;
    private final int[] distant;
    private final PowerLightSelection forEmission;

    /** Creates the selection among these lights. */
    public LightTreeSelection(List<? extends Light> lights) {
        this.lights = lights.toArray(new Light[0]);
        forEmission = new PowerLightSelection(lights);
        EmissionBounds[] bounds = new EmissionBounds[this.lights.length];
        int[] infinite = new int[bounds.length];
        int infiniteCount = 0;
        for (int i = 0; i < bounds.length; i++) {
            EmissionBounds own = this.lights[i].bounds();
            bounds[i] = own == null ? EmissionBounds.everywhere(Bounds.EMPTY, 0) : own;
            if (this.lights[i].isInfinite()) {
                infinite[infiniteCount++] = i;
            }
        }
        distant = Arrays.copyOf(infinite, infiniteCount);
        tree = EmitterTree.of(bounds, LEAF);
    }

    @Override
    public boolean choose(double px, double py, double pz, double nx, double ny, double nz, double u, LightChoice out) {
        double left = u;
        double share = 1;
        if (distant.length > 0) {
            double near = nearImportance(px, py, pz, nx, ny, nz);
            double total = near;
            int parts = near > 0 ? 1 : 0;
            for (int light : distant) {
                double importance = importance(light, px, py, pz, nx, ny, nz);
                total += importance;
                parts += importance > 0 ? 1 : 0;
            }
            share = near > 0 ? part(near, total, parts) : 0;
            if (left >= share) {
                return parts > 0 && chooseDistant(left - share, total, parts, px, py, pz, nx, ny, nz, out);
            }
            left /= share;
        }
        double[] way = out.scratch;
        int leaf = tree.choose(px, py, pz, nx, ny, nz, left, way);
        return leaf >= 0 && chooseInLeaf(leaf, share * way[0], way[1], px, py, pz, nx, ny, nz, out);
    }

    private boolean chooseDistant(
            double u,
            double total,
            int parts,
            double px,
            double py,
            double pz,
            double nx,
            double ny,
            double nz,
            LightChoice out) {
        double left = u;
        boolean found = false;
        for (int i = 0; i < distant.length && left >= 0; i++) {
            double importance = importance(distant[i], px, py, pz, nx, ny, nz);
            if (importance > 0) {
                double probability = part(importance, total, parts);
                out.set(distant[i], probability);
                found = true;
                left -= probability;
            }
        }
        return found;
    }

    private boolean chooseInLeaf(
            int leaf,
            double leafProbability,
            double u,
            double px,
            double py,
            double pz,
            double nx,
            double ny,
            double nz,
            LightChoice out) {
        int start = tree.leafStart(leaf);
        int size = tree.leafSize(leaf);
        double w0 = importance(tree.emitter(start), px, py, pz, nx, ny, nz);
        double w1 = size > 1 ? importance(tree.emitter(start + 1), px, py, pz, nx, ny, nz) : 0;
        double w2 = size > 2 ? importance(tree.emitter(start + 2), px, py, pz, nx, ny, nz) : 0;
        double w3 = size > 3 ? importance(tree.emitter(start + 3), px, py, pz, nx, ny, nz) : 0;
        double total = w0 + w1 + w2 + w3;
        int candidates = (w0 > 0 ? 1 : 0) + (w1 > 0 ? 1 : 0) + (w2 > 0 ? 1 : 0) + (w3 > 0 ? 1 : 0);
        double left = u;
        for (int i = 0; i < size; i++) {
            double own = i == 0 ? w0 : i == 1 ? w1 : i == 2 ? w2 : w3;
            if (own > 0) {
                double probability = mix(own, total, candidates);
                out.set(tree.emitter(start + i), leafProbability * probability);
                left -= probability;
                if (left < 0) {
                    break;
                }
            }
        }
        // Rounding may leave a little over: that is the last candidate's.
        return candidates > 0;
    }

    @Override
    public double probability(int light, double px, double py, double pz, double nx, double ny, double nz) {
        double own = importance(light, px, py, pz, nx, ny, nz);
        if (!(own > 0)) {
            return 0;
        }
        double share = 1;
        if (distant.length > 0) {
            double near = nearImportance(px, py, pz, nx, ny, nz);
            double total = near;
            int parts = near > 0 ? 1 : 0;
            for (int other : distant) {
                double importance = importance(other, px, py, pz, nx, ny, nz);
                total += importance;
                parts += importance > 0 ? 1 : 0;
            }
            if (lights[light].isInfinite()) {
                return part(own, total, parts);
            }
            share = near > 0 ? part(near, total, parts) : 0;
        }
        int leaf = tree.leafOf(light);
        if (leaf < 0) {
            return 0;
        }
        int start = tree.leafStart(leaf);
        int size = tree.leafSize(leaf);
        double total = 0;
        int candidates = 0;
        for (int i = start; i < start + size; i++) {
            int other = tree.emitter(i);
            double importance = other == light ? own : importance(other, px, py, pz, nx, ny, nz);
            if (importance > 0) {
                total += importance;
                candidates++;
            }
        }
        return share * tree.probability(leaf, px, py, pz, nx, ny, nz) * mix(own, total, candidates);
    }

    @Override
    public int chooseForEmission(double u) {
        return forEmission.chooseForEmission(u);
    }

    @Override
    public double emissionProbability(int light) {
        return forEmission.emissionProbability(light);
    }

    private static double mix(double importance, double total, int candidates) {
        return (1 - UNIFORM_SHARE) * (importance / total) + UNIFORM_SHARE / candidates;
    }

    private static double part(double importance, double total, int parts) {
        return (1 - UNIFORM_SHARE_OF_PARTS) * (importance / total) + UNIFORM_SHARE_OF_PARTS / parts;
    }

    private double nearImportance(double px, double py, double pz, double nx, double ny, double nz) {
        return Math.min(LARGEST, tree.importance(px, py, pz, nx, ny, nz));
    }

    private double importance(int light, double px, double py, double pz, double nx, double ny, double nz) {
        return Math.min(LARGEST, lights[light].importance(px, py, pz, nx, ny, nz));
    }
}
