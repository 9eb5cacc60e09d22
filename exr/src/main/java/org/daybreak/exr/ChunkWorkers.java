package org.daybreak.exr;

import java.io.IOException;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/**
 * Runs the packing and unpacking of chunks, on threads of its own or, with one thread, at once on the caller's. Waiting
 * does not end at an interrupt: an image that is written after Ctrl-C must still be whole. The thread's interrupt flag
 * stays set.
 */
final class ChunkWorkers implements AutoCloseable {
    /** Below this many raw bytes the start of threads costs more than it brings. */
    private static final long MIN_PARALLEL_BYTES = 1 << 20;

    /** Raw bytes, packed bytes and a codec's work space. */
    static final int BUFFERS_PER_SLOT = 3;

    private final @Nullable ExecutorService pool;
    private final int slotCount;

    /**
     * Starts the workers.
     *
     * @param threads most threads to use
     * @param layout the chunks
     */
    ChunkWorkers(int threads, ChunkLayout layout) {
        int chunkCount = layout.chunkCount();
        int used = Math.min(threads, chunkCount);
        if (layout.rawBytes() < MIN_PARALLEL_BYTES
                || !isRoomFor(2L * used * BUFFERS_PER_SLOT * layout.maxRawLength())) {
            used = 1;
        }
        if (used == 1) {
            pool = null;
            slotCount = 1;
        } else {
            pool = Executors.newFixedThreadPool(used, task -> {
                Thread thread = new Thread(task, "exr-chunks");
                thread.setDaemon(true);
                return thread;
            });
            // Twice the threads: one half is worked on while the other is read from or written to the file.
            slotCount = Math.min(2 * used, chunkCount);
        }
    }

    /**
     * A thread of a pool that runs out of memory outside its task would leave the caller waiting for ever, so threads
     * are only used where memory is ample; garbage that is not yet collected counts as used.
     */
    private static boolean isRoomFor(long bytes) {
        Runtime runtime = Runtime.getRuntime();
        long free = runtime.maxMemory() - runtime.totalMemory() + runtime.freeMemory();
        return bytes < free / 2;
    }

    /** The number of chunks that are under way at a time; each needs buffers and a codec of its own. */
    int slotCount() {
        return slotCount;
    }

    FutureTask<@Nullable Void> start(Callable<@Nullable Void> work) {
        FutureTask<@Nullable Void> task = new FutureTask<>(work);
        if (pool == null) {
            task.run();
        } else {
            pool.execute(task);
        }
        return task;
    }

    /** Waits for the end of the work and throws what it has thrown. */
    static void await(FutureTask<@Nullable Void> task) throws IOException {
        boolean interrupted = false;
        try {
            while (true) {
                try {
                    task.get();
                    return;
                } catch (InterruptedException e) {
                    interrupted = true;
                } catch (ExecutionException e) {
                    throw unwrap(e);
                }
            }
        } finally {
            if (interrupted) {
                Thread.currentThread().interrupt();
            }
        }
    }

    private static IOException unwrap(ExecutionException e) {
        Throwable cause = e.getCause();
        if (cause instanceof IOException failure) {
            return failure;
        }
        if (cause instanceof Error error) {
            throw error;
        }
        // Work declares no other checked exception.
        throw new IllegalStateException(cause);
    }

    /** Ends the threads. Work that was started is finished first, as it uses buffers and codecs of the caller. */
    @Override
    public void close() {
        if (pool == null) {
            return;
        }
        pool.shutdown();
        boolean interrupted = false;
        boolean done = false;
        while (!done) {
            try {
                done = pool.awaitTermination(1, TimeUnit.DAYS);
            } catch (InterruptedException e) {
                interrupted = true;
            }
        }
        if (interrupted) {
            Thread.currentThread().interrupt();
        }
    }
}
