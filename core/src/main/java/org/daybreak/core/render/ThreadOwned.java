package org.daybreak.core.render;

import java.lang.ref.WeakReference;
import java.util.function.Consumer;
import java.util.function.Supplier;

/**
 * What a thread works with, kept where no other thread writes. What two threads write to all the time must not share a cache
 * line, or each write waits for the other's: a third of the speed may be lost to that, from one start of the virtual machine to the next.
 * What a thread allocates lies together, and apart from what others allocate, until the garbage collector moves it. So it is
 * made by the thread that uses it, and anew after a collection. As what is hot allocates nothing, collections are soon over.
 *
 * @param <T> what is owned; holds nothing that must outlive it but what {@code retire} takes over
 */
public final class ThreadOwned<T> {
    /** Making it anew may take this part of the time. */
    private static final double LARGEST_SHARE = 0.02;

    private final Supplier<? extends T> maker;
    private final Consumer<? super T> retire;
    private T current;
    private long readyAt = System.nanoTime();

    /** Cleared by the collection that moves what is as young. */
    private WeakReference<Object> unmoved = new WeakReference<>(null);

    /**
     * Makes the first one, in the calling thread, whose failures then are the caller's.
     *
     * @param maker makes one; all do the same
     * @param retire takes over from one that will not be used any more what it has counted
     */
    public ThreadOwned(Supplier<? extends T> maker, Consumer<? super T> retire) {
        this.maker = maker;
        this.retire = retire;
        current = maker.get();
    }

    /** The one to use now, by the thread that calls: a new one if the last may have been moved. Valid until the next call. */
    public T renewed() {
        if (unmoved.get() == null && System.nanoTime() - readyAt >= 0) {
            T old = current;
            long before = System.nanoTime();
            unmoved = new WeakReference<>(new Object());
            current = maker.get();
            // Not before: if making fails, the old one is still there to be counted.
            retire.accept(old);
            long after = System.nanoTime();
            readyAt = after + (long) ((after - before) / LARGEST_SHARE);
        }
        return current;
    }

    /** The one that was used last. */
    public T current() {
        return current;
    }
}
