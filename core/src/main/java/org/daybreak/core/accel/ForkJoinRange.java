package org.daybreak.core.accel;

import java.util.concurrent.ForkJoinPool;
import java.util.concurrent.RecursiveAction;
import java.util.function.Supplier;

/** Loops over ranges that are cut in halves and run in parallel. */
final class ForkJoinRange extends RecursiveAction {
    private static final long serialVersionUID = 1L;

    /** What to do with a part of the range. */
    interface Body {
        /** Handles the elements from, inclusive, to, exclusive. */
        void run(int from, int to);
    }

    private final int from;
    private final int to;
    private final int grain;
    private final transient Body body;

    private ForkJoinRange(int from, int to, int grain, Body body) {
        this.from = from;
        this.to = to;
        this.grain = grain;
        this.body = body;
    }

    /**
     * Runs the body over a range; in parallel only inside a pool that {@link #inPool} made.
     *
     * @param grain parts of at most twice this size are not cut
     */
    static void run(int count, int grain, Body body) {
        if (count < 2 * grain || !isParallel()) {
            body.run(0, count);
        } else {
            new ForkJoinRange(0, count, grain, body).invoke();
        }
    }

    @Override
    protected void compute() {
        if (to - from < 2 * grain) {
            body.run(from, to);
            return;
        }
        int middle = (from + to) >>> 1;
        invokeAll(new ForkJoinRange(from, middle, grain, body), new ForkJoinRange(middle, to, grain, body));
    }

    /** Whether the caller runs in a pool that {@link #inPool} made. */
    static boolean isParallel() {
        return Thread.currentThread() instanceof BuildThread;
    }

    private static final class BuildThread extends java.util.concurrent.ForkJoinWorkerThread {
        BuildThread(ForkJoinPool pool) {
            super(pool);
            setName("bvh-build-" + getPoolIndex());
        }
    }

    /** Runs a computation with the given number of threads, which end with it; with one, in the calling thread. */
    static <T> T inPool(int threads, Supplier<T> computation) {
        if (threads <= 1) {
            return computation.get();
        }
        ForkJoinPool pool = new ForkJoinPool(threads, BuildThread::new, null, false);
        try {
            return pool.submit(computation::get).join();
        } catch (IllegalArgumentException e) {
            // Each task that passes an exception on wraps it in one of the same type.
            IllegalArgumentException first = e;
            while (first.getCause() instanceof IllegalArgumentException cause) {
                first = cause;
            }
            throw first;
        } finally {
            pool.shutdown();
        }
    }
}
