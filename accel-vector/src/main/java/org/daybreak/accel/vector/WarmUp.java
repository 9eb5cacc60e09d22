package org.daybreak.accel.vector;

import java.util.SplittableRandom;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.Function;
import org.daybreak.core.accel.Instance;
import org.daybreak.core.accel.Intersector;
import org.daybreak.core.accel.PrimitiveSet;
import org.daybreak.core.accel.Quadric;
import org.daybreak.core.accel.Ray;
import org.daybreak.core.accel.SelfCheck;
import org.daybreak.core.accel.WideBvh;

/**
 * Gets a vector kernel compiled while {@link ColdTraversal} answers. Before the optimising compiler has seen it, each
 * vector operation of a kernel is a call that takes microseconds: the first two seconds of a rendering would pass at
 * some thousand rays a second, where the cold traversal makes hundreds of thousands.
 *
 * <p>A daemon thread sends rays through the kernel in a small scene. Once the kernel is faster than the
 * cold traversal there, and its answers are right, it is used; a kernel that never gets there, as the compiler boxes its
 * vectors or is off, never is.
 */
final class WarmUp {
    /** A kernel that is not fast by then stays unused. */
    private static final long LIMIT_NANOS = TimeUnit.SECONDS.toNanos(120);

    private static final int TRIANGLES = 600;
    private static final int BATCH = 128;

    private static final double[] PLACE = {0.3, 0, 0.1, -0.4, 0, 0.3, 0, 0.5, 0, 0.1, 0.3, 0.2};

    /**
     * Batches in a row in which the kernel must be the faster. Boxed vectors are a hundred times slower than the cold traversal
     * and the compiled kernel no more than three times faster in this small scene, so a margin would only keep good kernels out.
     */
    private static final int CONFIRMATIONS = 4;

    private final CountDownLatch end = new CountDownLatch(1);
    private volatile boolean ready;

    /**
     * Starts the thread.
     *
     * @param name of the kernel
     * @param width number of lanes
     * @param maker makes an intersector that uses the kernel in any case
     */
    WarmUp(String name, int width, Function<WideBvh, Intersector> maker) {
        Thread thread = new Thread(() -> run(width, maker), name + "-warm-up");
        thread.setDaemon(true);
        thread.start();
    }

    /** Whether the kernel may be used. */
    boolean isReady() {
        return ready;
    }

    /** What is used at the moment, in words. */
    String state() {
        if (ready) {
            return "";
        }
        return end.getCount() > 0
                ? ", one lane at a time until compiled"
                : ", one lane at a time: vectors are slow here";
    }

    /** Waits until the kernel may be used, or is given up, or the time is over. */
    boolean await(long milliseconds) throws InterruptedException {
        return end.await(milliseconds, TimeUnit.MILLISECONDS) && ready;
    }

    private void run(int width, Function<WideBvh, Intersector> maker) {
        try {
            Intersector kernel = scene(width, maker);
            Intersector cold = scene(width, bvh -> new ColdTraversal(bvh, width));
            Ray ray = new Ray();
            SplittableRandom random = new SplittableRandom(1);
            long start = System.nanoTime();
            int confirmations = 0;
            while (confirmations < CONFIRMATIONS) {
                long seed = random.nextLong();
                long before = System.nanoTime();
                query(kernel, ray, seed);
                long middle = System.nanoTime();
                query(cold, ray, seed);
                long after = System.nanoTime();
                confirmations = middle - before < after - middle ? confirmations + 1 : 0;
                if (after - start > LIMIT_NANOS) {
                    return;
                }
            }
            ready = SelfCheck.compare(cold, kernel).isEmpty();
        } catch (RuntimeException | LinkageError e) {
            // The cold traversal goes on answering; the description of the intersector tells.
            ready = false;
        } finally {
            end.countDown();
        }
    }

    /** Holds all kinds of primitives: code that was never run would be compiled anew when it is first needed. */
    private static Intersector scene(int width, Function<WideBvh, Intersector> maker) {
        Intersector level = maker.apply(WideBvh.build(SelfCheck.scene(TRIANGLES / 10), width, 1));
        Instance[] instances = {new Instance(PLACE, level)};
        PrimitiveSet set = SelfCheck.scene(TRIANGLES);
        Quadric[] quadrics = new Quadric[set.quadricCount()];
        for (int i = 0; i < quadrics.length; i++) {
            quadrics[i] = set.quadric(i);
        }
        return maker.apply(
                WideBvh.build(new PrimitiveSet(set.positions(), set.triangles(), quadrics, instances), width, 1));
    }

    private static int query(Intersector intersector, Ray ray, long seed) {
        SplittableRandom random = new SplittableRandom(seed);
        int hits = 0;
        for (int i = 0; i < BATCH; i++) {
            SelfCheck.aim(ray, random, i % 4 == 0 ? 2 : Double.POSITIVE_INFINITY);
            hits += intersector.intersect(ray) ? 1 : 0;
            hits += intersector.occluded(ray) ? 1 : 0;
        }
        return hits;
    }
}
