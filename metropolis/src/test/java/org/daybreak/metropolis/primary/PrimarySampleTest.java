package org.daybreak.metropolis.primary;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.ZTest;
import org.daybreak.metropolis.chains.StateReader;
import org.daybreak.metropolis.chains.StateWriter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/**
 * Chains with a target on the numbers themselves, that reads other coordinates in one half of the space than in the other, as paths do.
 * They start from exact samples of the target, so that after any number of steps they must be exact samples, and independent of each
 * other.
 */
class PrimarySampleTest {
    private static final int FAR = 1 << 30;
    private static final double BORDER = 0.4;
    private static final int BINS = 4;

    /** A function of coordinate 7 and, on one side of the border, of 1000, on the other of 5 and 2³⁰; at most 4. */
    private interface Target {
        double left(double x, double y);

        double right(double x, double z, double w);
    }

    private static final Target CONSTANT = new Target() {
        @Override
        public double left(double x, double y) {
            return 1;
        }

        @Override
        public double right(double x, double z, double w) {
            return 1;
        }
    };

    private static final Target UNEVEN = new Target() {
        @Override
        public double left(double x, double y) {
            return 0.2 + x + 2 * y * y;
        }

        @Override
        public double right(double x, double z, double w) {
            return 0.1 + 3 * x * Math.abs(z - w);
        }
    };

    private double lastX;
    private double lastY;

    private double evaluate(Target target, PrimarySample numbers) {
        numbers.setDimension(7);
        double x = numbers.next();
        lastX = x;
        if (x < BORDER) {
            numbers.setDimension(1000);
            lastY = numbers.next();
            return target.left(x, lastY);
        }
        numbers.setDimension(FAR);
        double w = numbers.next();
        numbers.setDimension(5);
        return target.right(x, numbers.next(), w);
    }

    /**
     * Counts states after some steps by coordinate 7 and 1000; where the target does not read the latter, it is read after the last step.
     */
    private long[] counts(Target target, SmallStep step, double large, int steps, int chains) {
        long[] counts = new long[BINS * BINS * 2];
        for (int chain = 0; chain < chains; chain++) {
            RandomStream random = new RandomStream(5, StreamDomain.SELF_CHECK, chain, 0);
            PrimarySample numbers = new PrimarySample(step);
            double value;
            do {
                numbers.begin(random);
                value = evaluate(target, numbers);
            } while (random.nextDouble() * 4 >= value);
            double x = lastX;
            double y = lastY;
            for (int i = 0; i < steps; i++) {
                numbers.propose(random.nextDouble() < large, random);
                double proposed = evaluate(target, numbers);
                if (random.nextDouble() < proposed / value) {
                    numbers.accept();
                    value = proposed;
                    x = lastX;
                    y = lastY;
                }
            }
            if (x >= BORDER) {
                numbers.propose(false, random);
                numbers.setDimension(1000);
                y = numbers.next();
            }
            counts[cell(x, y)]++;
        }
        return counts;
    }

    private static int cell(double x, double y) {
        boolean left = x < BORDER;
        double along = left ? x / BORDER : (x - BORDER) / (1 - BORDER);
        return ((left ? 0 : BINS) + (int) (along * BINS)) * BINS + (int) (y * BINS);
    }

    private static double[] expected(Target target, int chains) {
        double[] cells = new double[BINS * BINS * 2];
        int n = 120;
        double sum = 0;
        for (int i = 0; i < n; i++) {
            double x = (i + 0.5) / n;
            for (int j = 0; j < n; j++) {
                double y = (j + 0.5) / n;
                double value = 0;
                if (x < BORDER) {
                    value = target.left(x, y);
                } else {
                    for (int k = 0; k < n; k++) {
                        // The midpoints of z and w; y is uniform.
                        value += target.right(x, (k + 0.5) / n, y) / n;
                    }
                }
                sum += value;
                if (x < BORDER) {
                    cells[cell(x, y)] += value;
                } else {
                    for (int b = 0; b < BINS; b++) {
                        cells[cell(x, (b + 0.5) / BINS)] += value / BINS;
                    }
                }
            }
        }
        for (int i = 0; i < cells.length; i++) {
            cells[i] *= chains / sum;
        }
        return cells;
    }

    /** The target stays the distribution; false-alarm rate 1e-4 for each row. */
    @ParameterizedTest
    @CsvSource({
        "true, 0, 12",
        "true, 0.3, 12",
        "true, 1, 3",
        "false, 0, 1",
        "false, 0, 2",
        "false, 0, 25",
        "false, 0.1, 25",
        "false, 0.5, 8",
        "false, 1, 4"
    })
    void targetIsStationary(boolean constant, double large, int steps) {
        Target target = constant ? CONSTANT : UNEVEN;
        int chains = 30_000;
        long[] counts = counts(target, new SmallStep(0.05, 0.4), large, steps, chains);
        double p = ChiSquareTest.compare("states", counts, expected(target, chains))
                .pValue();
        ZTest.assertNotRejected("states", p, 1e-4);
        double other = ChiSquareTest.compare("states", counts, expected(constant ? UNEVEN : CONSTANT, chains))
                .pValue();
        assertTrue(other < 1e-10, "another target is found out");
    }

    /** From a start far off, small steps of the defaults' size find the target: they do move, and by themselves. */
    @Test
    void smallStepsFindTheTarget() {
        SmallStep step = new SmallStep(1.0 / 64, 0.25);
        int chains = 4_000;
        long[] counts = new long[BINS * BINS * 2];
        for (int chain = 0; chain < chains; chain++) {
            RandomStream random = new RandomStream(6, StreamDomain.SELF_CHECK, chain, 0);
            PrimarySample numbers = new PrimarySample(step);
            numbers.begin(random);
            numbers.set(7, 0.1);
            numbers.set(1000, 0.1);
            double value = evaluate(UNEVEN, numbers);
            double x = lastX;
            double y = lastY;
            for (int i = 0; i < 400; i++) {
                numbers.propose(false, random);
                double proposed = evaluate(UNEVEN, numbers);
                if (random.nextDouble() < proposed / value) {
                    numbers.accept();
                    value = proposed;
                    x = lastX;
                    y = lastY;
                }
            }
            if (x >= BORDER) {
                numbers.propose(false, random);
                numbers.setDimension(1000);
                y = numbers.next();
            }
            counts[cell(x, y)]++;
        }
        double p = ChiSquareTest.compare("states", counts, expected(UNEVEN, chains))
                .pValue();
        ZTest.assertNotRejected("states", p, 1e-4);
    }

    @Test
    void numberIsTheSameHoweverOftenItIsRead() {
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        PrimarySample numbers = new PrimarySample(new SmallStep(0.01, 0.1));
        numbers.begin(random);
        for (int round = 0; round < 4; round++) {
            double[] first = new double[200];
            for (int i = 0; i < first.length; i++) {
                numbers.setDimension(i * 100_003);
                assertEquals(i * 100_003, numbers.dimension());
                first[i] = numbers.next();
            }
            for (int i = first.length - 1; i >= 0; i--) {
                numbers.setDimension(i * 100_003);
                assertEquals(first[i], numbers.next());
            }
            numbers.propose(round == 1, random);
        }
        assertEquals(200, numbers.size());
    }

    /** A rejected proposal leaves the state: what is proposed next is near it, not near what was rejected. */
    @Test
    void rejectedProposalsLeaveNoTrace() {
        RandomStream random = new RandomStream(2, StreamDomain.SELF_CHECK, 0, 0);
        double largest = 1e-6;
        PrimarySample numbers = new PrimarySample(new SmallStep(1e-7, largest));
        numbers.begin(random);
        numbers.setDimension(3);
        double value = numbers.next();
        for (int i = 0; i < 1000; i++) {
            numbers.propose(i % 3 == 0, random);
            numbers.setDimension(3);
            double proposed = numbers.next();
            assertNotEquals(value, proposed);
            if (i % 3 != 0) {
                assertEquals(value, proposed, 1.01 * largest);
            }
        }
    }

    /** A coordinate that has not been read for n accepted steps has moved n times by then. */
    @Test
    void missedStepsAreMadeUpFor() {
        double size = 1e-4;
        SmallStep step = new SmallStep(size, size);
        int missed = 99;
        double squares = 0;
        int chains = 2000;
        for (int chain = 0; chain < chains; chain++) {
            RandomStream random = new RandomStream(3, StreamDomain.SELF_CHECK, chain, 0);
            PrimarySample numbers = new PrimarySample(step);
            numbers.begin(random);
            numbers.set(8, 0.5);
            for (int i = 0; i < missed; i++) {
                numbers.propose(false, random);
                numbers.accept();
            }
            numbers.propose(false, random);
            numbers.setDimension(8);
            double moved = (numbers.next() - 0.5) / size;
            squares += moved * moved;
        }
        // The mean square of a walk of n unit steps is n, with variance 2n² − 2n.
        double n = missed + 1.0;
        ZTest.assertNotRejected(
                "mean square", ZTest.known(squares / chains, Math.sqrt((2 * n * n - 2 * n) / chains), n), 1e-4);
    }

    @Test
    void savedStateGoesOnWithTheSameBits() {
        SmallStep step = new SmallStep(0.01, 0.3);
        RandomStream random = new RandomStream(4, StreamDomain.SELF_CHECK, 0, 0);
        PrimarySample numbers = new PrimarySample(step);
        numbers.begin(random);
        walk(numbers, random, 300);
        StateWriter out = new StateWriter();
        numbers.save(out);
        PrimarySample loaded = new PrimarySample(step);
        loaded.load(new StateReader(out.toArray()));
        RandomStream again = new RandomStream(4, StreamDomain.SELF_CHECK, 0, 0);
        again.skipTo(random.position());
        assertEquals(walk(numbers, random, 300), walk(loaded, again, 300));
        assertEquals(numbers.size(), loaded.size());
    }

    private static double walk(PrimarySample numbers, RandomStream random, int steps) {
        double sum = 0;
        for (int i = 0; i < steps; i++) {
            numbers.propose(random.nextDouble() < 0.1, random);
            int reads = 20 + (int) (100 * random.nextDouble());
            for (int j = 0; j < reads; j++) {
                numbers.setDimension((int) (400 * random.nextDouble()) << 20);
                sum += numbers.next() * (j + 1);
            }
            if (random.nextDouble() < 0.6) {
                numbers.accept();
            }
        }
        return sum;
    }

    @Test
    void numbersOfOneChainAreNotCopied() {
        PrimarySample numbers = new PrimarySample(new SmallStep(0.01, 0.3));
        assertThrows(UnsupportedOperationException.class, numbers::copy);
    }
}
