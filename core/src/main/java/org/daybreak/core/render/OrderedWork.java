package org.daybreak.core.render;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * Work cut into numbered units that any number of threads compute, while their results are committed strictly in the order
 * of the numbers: so sums of floating-point numbers come out the same, bit for bit, whatever the number of threads.
 *
 * <p>A unit's result lives in a slot. There are a few more slots than threads and they are reused; a thread that is ahead of
 * the oldest unfinished unit by that many units waits. Memory is bounded and there is no barrier.
 *
 * <p>Threads are made for one {@link #run} and end with it. They are daemons, so a host program can always exit.
 *
 * @param <S> result of a unit
 */
public abstract class OrderedWork<S> {
    private static final int SLOTS_PER_THREAD = 4;
    private static final long WATCH_MILLISECONDS = 100;

    private final Object lock = new Object();
    private final List<S> slots = new ArrayList<>();
    private boolean[] finished = new boolean[0];
    private long claimed;
    private long committed;
    private boolean exhausted;
    private boolean committing;
    private int waiting;
    private @Nullable Throwable failure;

    /** Creates the work; {@link #run} may be called once. */
    protected OrderedWork() {}

    /** Computes units; one object per thread. */
    public interface Worker<S> {
        /** Computes a unit that {@link OrderedWork#claim} has described in the slot. */
        void compute(long unit, S slot);
    }

    /** Makes a slot. */
    protected abstract S newSlot();

    /** Makes a worker. Called in the caller's thread before the work starts. */
    protected abstract Worker<S> newWorker();

    /**
     * Describes the next unit in its slot. Called in the order of the numbers, from one thread at a time.
     *
     * @return false if there is no further unit; it is then not asked again
     */
    protected abstract boolean claim(long unit, S slot);

    /**
     * True if the next unit can be described only when all units before it are committed: it then waits for them. Called before
     * {@link #claim}, under the same guard, and maybe several times.
     */
    protected boolean needsCommits() {
        return false;
    }

    /** Takes over a finished unit's result. Called in the order of the numbers, from one thread at a time. */
    protected abstract void commit(long unit, S slot);

    /**
     * Called in the caller's thread several times a second while the work goes on: for progress. Never called concurrently
     * with itself.
     */
    protected abstract void watch();

    /**
     * Does the work; returns when every claimed unit has been committed.
     *
     * <p>If a worker, {@link #claim}, {@link #commit} or {@link #watch} throws, no further unit is claimed or committed, and
     * the exception is thrown again here once all threads have ended. If the calling thread is interrupted, no
     * further unit is claimed, the claimed ones are finished, and its interrupt flag is set again on return.
     *
     * @param threads number of threads, at least 1
     */
    public final void run(int threads) {
        int capacity = Math.multiplyExact(threads, SLOTS_PER_THREAD);
        finished = new boolean[capacity];
        for (int i = 0; i < capacity; i++) {
            slots.add(newSlot());
        }
        CountDownLatch ended = new CountDownLatch(threads);
        List<Thread> workers = new ArrayList<>();
        for (int i = 0; i < threads; i++) {
            Worker<S> worker = newWorker();
            Thread thread = new Thread(() -> work(worker, ended), "daybreak-worker-" + i);
            thread.setDaemon(true);
            workers.add(thread);
        }
        workers.forEach(Thread::start);
        boolean interrupted = watchUntilDone(ended);
        for (Thread thread : workers) {
            interrupted |= joinUninterruptibly(thread);
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
        rethrow();
    }

    /** Waits apart from the workers' lock, so that no commit wakes the caller up. */
    private boolean watchUntilDone(CountDownLatch ended) {
        boolean interrupted = false;
        while (true) {
            try {
                if (ended.await(WATCH_MILLISECONDS, TimeUnit.MILLISECONDS)) {
                    return interrupted;
                }
            } catch (InterruptedException e) {
                interrupted = true;
                synchronized (lock) {
                    exhausted = true;
                    lock.notifyAll();
                }
            }
            try {
                watch();
            } catch (RuntimeException | Error e) {
                fail(e);
            }
        }
    }

    private static boolean joinUninterruptibly(Thread thread) {
        boolean interrupted = false;
        while (true) {
            try {
                thread.join();
                return interrupted;
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
    }

    private void rethrow() {
        Throwable cause = failure;
        if (cause instanceof RuntimeException e) {
            throw e;
        }
        if (cause instanceof Error e) {
            throw e;
        }
    }

    private void work(Worker<S> worker, CountDownLatch ended) {
        try {
            while (true) {
                long unit;
                synchronized (lock) {
                    unit = claimNext();
                }
                if (unit < 0) {
                    return;
                }
                int slot = slotOf(unit);
                worker.compute(unit, slots.get(slot));
                synchronized (lock) {
                    finished[slot] = true;
                }
                commitFinished();
            }
        } catch (RuntimeException | Error e) {
            fail(e);
        } finally {
            ended.countDown();
        }
    }

    /** The next unit to compute, -1 if there is none. The lock is held. */
    private long claimNext() {
        while (!exhausted && (claimed - committed >= finished.length || (claimed > committed && needsCommits()))) {
            waiting++;
            try {
                lock.wait();
            } catch (InterruptedException e) {
                // Nobody but this class knows the thread, so an interrupt can only mean that the program is going down.
                exhausted = true;
            } finally {
                waiting--;
            }
        }
        if (exhausted) {
            return -1;
        }
        if (!claim(claimed, slots.get(slotOf(claimed)))) {
            exhausted = true;
            lock.notifyAll();
            return -1;
        }
        return claimed++;
    }

    /** Commits what is next in order and finished, unless another thread is at it. */
    private void commitFinished() {
        synchronized (lock) {
            if (committing) {
                return;
            }
            committing = true;
        }
        while (true) {
            long unit;
            synchronized (lock) {
                unit = committed;
                if (failure != null || !finished[slotOf(unit)]) {
                    committing = false;
                    return;
                }
            }
            commit(unit, slots.get(slotOf(unit)));
            synchronized (lock) {
                finished[slotOf(unit)] = false;
                committed++;
                if (waiting > 0) {
                    lock.notifyAll();
                }
            }
        }
    }

    private int slotOf(long unit) {
        return (int) (unit % finished.length);
    }

    private void fail(Throwable e) {
        synchronized (lock) {
            if (failure == null) {
                failure = e;
            }
            exhausted = true;
            lock.notifyAll();
        }
    }
}
