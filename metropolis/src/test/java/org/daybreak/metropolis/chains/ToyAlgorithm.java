package org.daybreak.metropolis.chains;

import java.util.List;
import java.util.concurrent.locks.LockSupport;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;

/**
 * Chains on the film itself: a state is a film position, and what it brings is a known function. With u and v from 0 to 1 across
 * the film it is colour·(1 + 20·u⁸), but black above v = ¼.
 */
final class ToyAlgorithm implements ChainAlgorithm {
    static final double RED = 2;
    static final double GREEN = 0.5;
    static final double BLUE = 0.25;
    private static final double DARK = 0.25;
    private static final double PEAK = 20;
    private static final int POWER = 8;
    private static final double LUMINANCE = Spectrum.luminance(RED, GREEN, BLUE);

    /** What is out of the ordinary. */
    enum Fault {
        NONE,
        /** There is no light at all. */
        DARK,
        /** One candidate in 500 finds light. */
        RARE,
        /** One in a thousand proposals is not a number. */
        NOT_FINITE,
        /** Chains never leave the cell of 1/16 of the film that they start in. */
        STUCK,
        /** Each step takes a tenth of a millisecond. */
        SLOW
    }

    private final Fault fault;
    private final boolean expectedValues;

    ToyAlgorithm() {
        this(Fault.NONE, true);
    }

    ToyAlgorithm(Fault fault, boolean expectedValues) {
        this.fault = fault;
        this.expectedValues = expectedValues;
    }

    /** Mean of the function, in units of the colour, over a pixel. */
    static double mean(int x, int y, int width, int height) {
        double lit = Math.max(0, (y + 1.0) / height - Math.max(DARK, (double) y / height)) * height;
        return lit * (1 + PEAK / (POWER + 1) * width * (power((x + 1.0) / width) - power((double) x / width)));
    }

    private static double power(double u) {
        return Math.pow(u, POWER + 1);
    }

    /** ∫ f*. */
    static double brightness() {
        return LUMINANCE * (1 - DARK) * (1 + PEAK / (POWER + 1));
    }

    @Override
    public String id() {
        return "toy";
    }

    @Override
    public List<String> moves() {
        return List.of("jump", "walk");
    }

    @Override
    public List<String> warnings() {
        return List.of("this is a toy");
    }

    @Override
    public ChainWorker newWorker(Scene scene, Camera camera, long seed, int shortest) {
        return new Worker(camera.width(), camera.height(), seed);
    }

    private static final class ToyChain extends Chain {
        double u;
        double v;

        ToyChain(long seed, int number) {
            super(seed, number);
        }

        @Override
        protected void saveState(StateWriter out) {
            out.put(u);
            out.put(v);
        }

        @Override
        protected void loadState(StateReader in) {
            u = in.nextDouble();
            v = in.nextDouble();
        }
    }

    private final class Worker implements ChainWorker {
        private final int width;
        private final int height;
        private final long seed;
        private final RandomStream random = new RandomStream();
        private final double[] candidate = new double[4];
        private ImageImportance importance = ImageImportance.UNIFORM;
        private long rays;

        Worker(int width, int height, long seed) {
            this.width = width;
            this.height = height;
            this.seed = seed;
        }

        /** The function in units of the colour. */
        private double shade(double u, double v) {
            return v < DARK || fault == Fault.DARK ? 0 : 1 + PEAK * Math.pow(u, POWER);
        }

        private double target(double u, double v) {
            return shade(u, v) * LUMINANCE * importance.at(u * width, v * height);
        }

        @Override
        public void setImportance(ImageImportance newImportance) {
            importance = newImportance;
        }

        private void draw(long index) {
            random.seat(seed, StreamDomain.BOOTSTRAP, index, 0);
            for (int i = 0; i < candidate.length; i++) {
                candidate[i] = random.nextDouble();
            }
        }

        /** Two states, which share the weight. */
        @Override
        public void candidate(long index, Candidates found) {
            draw(index);
            rays++;
            double rarity = 1;
            if (fault == Fault.RARE) {
                rarity = 500;
                if (random.nextDouble() >= 1 / rarity) {
                    return;
                }
            }
            for (int i = 0; i < 2; i++) {
                double u = candidate[2 * i];
                double v = candidate[2 * i + 1];
                double weight = target(u, v) / 2 * rarity;
                if (weight > 0) {
                    found.found(i, u * width, v * height, weight);
                }
            }
        }

        @Override
        public Chain newChain(int number) {
            return new ToyChain(seed, number);
        }

        @Override
        public void start(Chain chain, long index, int number) {
            draw(index);
            ToyChain toy = (ToyChain) chain;
            toy.u = candidate[2 * number];
            toy.v = candidate[2 * number + 1];
        }

        @Override
        public void advance(Chain chain, long steps, SplatBuffer splats, ChainStatistics statistics) {
            ToyChain toy = (ToyChain) chain;
            for (long i = 0; i < steps; i++) {
                step(toy, splats, statistics);
                toy.steps++;
                if (fault == Fault.SLOW) {
                    LockSupport.parkNanos(100_000);
                }
            }
            statistics.steps += steps;
        }

        private void step(ToyChain toy, SplatBuffer splats, ChainStatistics statistics) {
            int move = toy.random.nextDouble() < 0.3 ? 0 : 1;
            double du = toy.random.nextDouble();
            double dv = toy.random.nextDouble();
            double u = move == 0 ? du : wrap(toy.u + 0.2 * (du - 0.5));
            double v = move == 0 ? dv : wrap(toy.v + 0.2 * (dv - 0.5));
            if (fault == Fault.STUCK) {
                u = (Math.floor(toy.u * 4) + du) / 4;
                v = (Math.floor(toy.v * 4) + dv) / 4;
            }
            double choice = toy.random.nextDouble();
            double here = target(toy.u, toy.v);
            double there = target(u, v);
            if (fault == Fault.NOT_FINITE && toy.random.nextDouble() < 1e-3) {
                statistics.nonFinite++;
                there = 0;
            }
            statistics.count(move, there > 0 ? Outcome.PROPOSED : Outcome.BLACK);
            double a = Math.min(1, there / here);
            statistics.addAcceptance(move, a);
            boolean accepted = choice < a;
            if (expectedValues) {
                splat(toy.u, toy.v, 1 - a, splats);
                splat(u, v, a, splats);
            }
            if (accepted) {
                statistics.countAccepted(move, Math.hypot((u - toy.u) * width, (v - toy.v) * height));
                toy.u = u;
                toy.v = v;
                toy.rejections = 0;
            } else {
                toy.rejections++;
                statistics.longestRejection = Math.max(statistics.longestRejection, toy.rejections);
            }
            if (!expectedValues) {
                splat(toy.u, toy.v, 1, splats);
            }
        }

        private static double wrap(double x) {
            return x - Math.floor(x);
        }

        private void splat(double u, double v, double share, SplatBuffer splats) {
            if (share > 0) {
                double factor = share * shade(u, v) / target(u, v);
                splats.add(u * width, v * height, RED * factor, GREEN * factor, BLUE * factor);
            }
        }

        @Override
        public long rays(RayKind kind) {
            return kind == RayKind.CAMERA ? rays : 0;
        }
    }
}
