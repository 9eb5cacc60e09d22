package org.daybreak.metropolis.chains;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.junit.jupiter.api.Test;

class ChainConvergenceTest {
    private static final FilmSettings FILM = new FilmSettings(40, 40, ReconstructionFilter.BOX);

    /**
     * Chains that jump to a uniform position once in a while.
     *
     * @param rounds of 100 steps each
     * @param persistence steps between jumps on average
     */
    private static ChainConvergence run(int chains, int rounds, double persistence) {
        ChainConvergence convergence = new ChainConvergence(FILM, 5, 5 + chains);
        SplatBuffer splats = new SplatBuffer();
        for (int chain = 5; chain < 5 + chains; chain++) {
            RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, chain, 0);
            double x = 40 * random.nextDouble();
            double y = 40 * random.nextDouble();
            for (int round = 0; round < rounds; round++) {
                splats.clear();
                for (int step = 0; step < 100; step++) {
                    if (random.nextDouble() < 1 / persistence) {
                        x = 40 * random.nextDouble();
                        y = 40 * random.nextDouble();
                    }
                    splats.add(x, y, 1, 1, 1);
                }
                convergence.add(chain, splats, 100);
            }
        }
        return convergence;
    }

    @Test
    void tellsChainsThatMixFromThoseThatDoNot() {
        assertEquals(1, run(50, 40, 1).rHat(), 0.03);
        assertTrue(run(50, 40, 20).rHat() < 1.05);
        assertTrue(run(50, 40, 100_000).rHat() > 2);
        // 4000 steps of a chain that jumps every thousand: it has been in four places.
        double few = run(50, 40, 1000).rHat();
        assertTrue(few > ChainConvergence.LIMIT && few < 2, () -> "R̂ " + few);
    }

    /** Chains that stay where they are: the number of those in a region is binomial with probability 1/16. */
    @Test
    void brightnessOfRegionsIsKnownFromTheNumberOfChains() {
        for (int chains : new int[] {100, 2000}) {
            double error = run(chains, 5, 1e9).regionError();
            // The darkest of 16 regions counts: a little more.
            double expected = Math.sqrt(15.0 / chains);
            assertTrue(error > expected && error < 1.8 * expected, () -> chains + " chains: " + error);
        }
        assertTrue(run(100, 40, 1).regionError() < 0.02);
        assertTrue(Double.isNaN(run(1, 40, 1).regionError()));
    }

    @Test
    void isUnknownWithoutEnoughToCompare() {
        assertTrue(Double.isNaN(run(3, 40, 1).rHat()));
        assertTrue(Double.isNaN(run(50, 3, 1).rHat()));
        assertTrue(Double.isNaN(new ChainConvergence(FILM, 0, 50).rHat()));
    }

    @Test
    void allTheSameIsConverged() {
        ChainConvergence convergence = new ChainConvergence(FILM, 0, 10);
        SplatBuffer splats = new SplatBuffer();
        splats.add(1, 1, 1, 1, 1);
        for (int round = 0; round < 10; round++) {
            for (int chain = 0; chain < 10; chain++) {
                convergence.add(chain, splats, 1);
            }
        }
        assertEquals(1, convergence.rHat());
        assertEquals(0, convergence.regionError(), 1e-15);
    }

    @Test
    void isSaved() {
        ChainConvergence convergence = run(10, 10, 50);
        StateWriter out = new StateWriter();
        convergence.save(out);
        ChainConvergence same = new ChainConvergence(FILM, 5, 15);
        same.load(new StateReader(out.toArray()));
        assertEquals(convergence.rHat(), same.rHat());
    }
}
