package org.daybreak.core.geometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.core.math.Bounds;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.Significance;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;

class EmitterTreeTest {
    /** False-alarm rate of each statistical test. */
    private static final double SIGNIFICANCE = 1e-4;

    private final RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);

    private double between(double from, double to) {
        return from + (to - from) * random.nextDouble();
    }

    private double[] direction() {
        double z = between(-1, 1);
        double phi = between(0, 2 * Math.PI);
        double r = Math.sqrt(1 - z * z);
        return new double[] {r * Math.cos(phi), r * Math.sin(phi), z};
    }

    private EmissionBounds emitter() {
        double x = between(-10, 10);
        double y = between(-1, 1);
        double z = between(-10, 10);
        double[] axis = direction();
        double size = random.nextDouble() < 0.3 ? 0 : between(0, 0.5);
        Bounds box = new Bounds(x, y, z, x + size, y + 0.5 * size, z + size);
        double intensity = Math.exp(between(-3, 3));
        if (random.nextDouble() < 0.2) {
            return EmissionBounds.everywhere(box, intensity);
        }
        boolean surface = random.nextDouble() < 0.6;
        return new EmissionBounds(
                box,
                axis[0],
                axis[1],
                axis[2],
                surface ? between(0, 0.4) : between(0.1, 1.5),
                surface ? Math.PI / 2 : 0,
                intensity);
    }

    /** A point of an emitter and a direction that leaves it reach whatever lies there: the tree must be able to choose it. */
    @Test
    void everyEmitterThatContributesCanBeChosen() {
        for (int count : new int[] {1, 2, 3, 17, 400}) {
            EmissionBounds[] emitters = new EmissionBounds[count];
            for (int i = 0; i < count; i++) {
                emitters[i] = emitter();
            }
            EmitterTree tree = EmitterTree.of(emitters, 1);
            assertEquals(count, tree.size());
            for (int k = 0; k < 5000; k++) {
                int i = random.nextInt(count);
                EmissionBounds e = emitters[i];
                double x = between(e.box().minX(), e.box().maxX());
                double y = between(e.box().minY(), e.box().maxY());
                double z = between(e.box().minZ(), e.box().maxZ());
                double[] w = direction();
                double angle =
                        Math.acos(Math.max(-1, Math.min(1, w[0] * e.axisX() + w[1] * e.axisY() + w[2] * e.axisZ())));
                if (angle > Math.min(Math.PI, e.normalAngle() + e.spread())) {
                    continue;
                }
                double distance = Math.exp(between(-5, 3));
                double px = x + distance * w[0];
                double py = y + distance * w[1];
                double pz = z + distance * w[2];
                assertTrue(tree.probability(tree.leafOf(i), px, py, pz, 0, 0, 0) > 0);
                assertTrue(tree.importance(px, py, pz, 0, 0, 0) > 0);
                double[] n = direction();
                if (w[0] * n[0] + w[1] * n[1] + w[2] * n[2] < 0) {
                    assertTrue(tree.probability(tree.leafOf(i), px, py, pz, n[0], n[1], n[2]) > 0);
                }
            }
        }
    }

    @Test
    void probabilitiesAreTheFrequencies() {
        EmissionBounds[] emitters = new EmissionBounds[60];
        for (int i = 0; i < emitters.length; i++) {
            emitters[i] = emitter();
        }
        emitters[7] = emitters[7].scaled(0);
        double[] dest = new double[2];
        int points = 6;
        for (int leafSize : new int[] {1, 4}) {
            EmitterTree tree = EmitterTree.of(emitters, leafSize);
            assertEquals(59, tree.size());
            assertEquals(-1, tree.leafOf(7));
            for (int k = 0; k < points; k++) {
                double px = between(-12, 12);
                double py = between(-3, 0.2);
                double pz = between(-12, 12);
                int samples = 50_000;
                // A cell for each emitter, where leaves are their first one, and one for failure.
                long[] counts = new long[emitters.length + 1];
                double[] expected = new double[emitters.length + 1];
                double sum = 0;
                for (int i = 0; i < emitters.length; i++) {
                    int leaf = tree.leafOf(i);
                    if (leaf >= 0 && tree.emitter(tree.leafStart(leaf)) == i) {
                        double probability = tree.probability(leaf, px, py, pz, 0, 1, 0);
                        expected[i] = samples * probability;
                        sum += probability;
                    }
                }
                assertTrue(sum < 1 + 1e-12);
                expected[emitters.length] = samples * Math.max(0, 1 - sum);
                for (int i = 0; i < samples; i++) {
                    int leaf = tree.choose(px, py, pz, 0, 1, 0, random.nextDouble(), dest);
                    counts[leaf < 0 ? emitters.length : tree.emitter(tree.leafStart(leaf))]++;
                    if (leaf >= 0) {
                        assertEquals(tree.probability(leaf, px, py, pz, 0, 1, 0), dest[0], 1e-15);
                        assertTrue(dest[1] >= 0 && dest[1] < 1);
                    }
                }
                ZTest.assertNotRejected(
                        "choice",
                        ChiSquareTest.compare("choice", counts, expected).pValue(),
                        Significance.sidak(SIGNIFICANCE, 2 * points));
            }
        }
    }

    /** Equal emitters cannot be told apart: the tree stays shallow enough for the ways to fit into 64 bits. */
    @Test
    void equalAndGradedEmittersMakeAUsableTree() {
        EmissionBounds[] equal = new EmissionBounds[5000];
        EmissionBounds[] graded = new EmissionBounds[300];
        for (int i = 0; i < equal.length; i++) {
            equal[i] = EmissionBounds.everywhere(new Bounds(1, 2, 3, 1, 2, 3), 1);
        }
        for (int i = 0; i < graded.length; i++) {
            double x = Math.scalb(1.0, -i);
            graded[i] = EmissionBounds.everywhere(new Bounds(x, 0, 0, x, 0, 0), 1);
        }
        for (EmissionBounds[] emitters : new EmissionBounds[][] {equal, graded}) {
            EmitterTree tree = EmitterTree.of(emitters, 1);
            double sum = 0;
            for (int i = 0; i < emitters.length; i++) {
                sum += tree.probability(tree.leafOf(i), 3, 3, 3, 0, 0, 0);
            }
            assertEquals(1, sum, 1e-9);
        }
    }

    @Test
    void nothingIsChosenFromNothing() {
        EmitterTree none = EmitterTree.of(new EmissionBounds[0], 1);
        assertTrue(none.isEmpty());
        assertNull(none.bounds());
        assertEquals(-1, none.choose(0, 0, 0, 0, 0, 0, 0.5, new double[2]));
        assertEquals(0, none.importance(0, 0, 0, 0, 0, 0));
        EmitterTree one =
                EmitterTree.of(new EmissionBounds[] {EmissionBounds.everywhere(new Bounds(0, 0, 0, 0, 0, 0), 2)}, 1);
        assertFalse(one.isEmpty());
        assertNotNull(one.bounds());
        // At the very place of a lamp all is finite.
        assertTrue(Double.isFinite(one.importance(0, 0, 0, 0, 0, 0)));
        assertEquals(0, one.choose(0, 0, 0, 0, 0, 0, 0.5, new double[2]));
    }

    @Test
    void unionsHoldBothCones() {
        for (int k = 0; k < 2000; k++) {
            EmissionBounds a = emitter();
            EmissionBounds b = emitter();
            EmissionBounds both = a.union(b);
            assertEquals(a.intensity() + b.intensity(), both.intensity(), 1e-12);
            for (EmissionBounds e : new EmissionBounds[] {a, b}) {
                double cosine = e.axisX() * both.axisX() + e.axisY() * both.axisY() + e.axisZ() * both.axisZ();
                double between = Math.acos(Math.max(-1, Math.min(1, cosine)));
                assertTrue(Math.min(Math.PI, between + e.normalAngle()) <= both.normalAngle() + 1e-7);
                assertTrue(both.spread() >= e.spread());
                assertEquals(both.box(), both.box().union(e.box()));
            }
        }
    }
}
