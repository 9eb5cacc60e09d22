package org.daybreak.core.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

@Timeout(60)
final class OrderedWorkTest {
    /** Squares of the unit numbers, computed at uneven speed. */
    private static class Squares extends OrderedWork<long[]> {
        final List<Long> results = new ArrayList<>();
        final AtomicInteger slots = new AtomicInteger();
        final AtomicInteger committing = new AtomicInteger();
        final AtomicLong failAt = new AtomicLong(-1);
        final long units;

        Squares(long units) {
            this.units = units;
        }

        @Override
        protected long[] newSlot() {
            slots.incrementAndGet();
            return new long[1];
        }

        @Override
        protected Worker<long[]> newWorker() {
            return (unit, slot) -> {
                if (unit == failAt.get()) {
                    throw new IllegalStateException("unit " + unit);
                }
                long work = ((unit * 2_654_435_761L) >>> 7) % 2000;
                long x = unit;
                for (long i = 0; i < work; i++) {
                    x = x * 31 + i;
                }
                slot[0] = x == 17 ? -1 : unit * unit;
            };
        }

        @Override
        protected boolean claim(long unit, long[] slot) {
            return unit < units;
        }

        @Override
        protected void commit(long unit, long[] slot) {
            assertEquals(1, committing.incrementAndGet());
            assertEquals(unit, results.size());
            results.add(slot[0]);
            committing.decrementAndGet();
        }

        @Override
        protected void watch() {}
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 8})
    void commitsEveryUnitInOrder(int threads) {
        Squares work = new Squares(5000);
        work.run(threads);
        assertEquals(5000, work.results.size());
        for (int i = 0; i < 5000; i++) {
            assertEquals((long) i * i, work.results.get(i));
        }
        assertEquals(4 * threads, work.slots.get());
    }

    @Test
    void noWorkIsFine() {
        Squares work = new Squares(0);
        work.run(3);
        assertTrue(work.results.isEmpty());
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 4})
    void aFailureReachesTheCaller(int threads) {
        Squares work = new Squares(1000);
        work.failAt.set(300);
        IllegalStateException e = assertThrows(IllegalStateException.class, () -> work.run(threads));
        assertEquals("unit 300", e.getMessage());
        assertTrue(work.results.size() <= 300);
    }

    @Test
    void failuresInEveryPartReachTheCaller() {
        Error error = new AssertionError("x");
        for (int part = 0; part < 3; part++) {
            int failing = part;
            Squares work = new Squares(1_000_000_000L) {
                @Override
                protected boolean claim(long unit, long[] slot) {
                    if (failing == 0 && unit == 20) {
                        throw error;
                    }
                    return super.claim(unit, slot);
                }

                @Override
                protected void commit(long unit, long[] slot) {
                    if (failing == 1 && unit == 20) {
                        throw error;
                    }
                }

                @Override
                protected void watch() {
                    if (failing == 2) {
                        throw error;
                    }
                }
            };
            assertSame(error, assertThrows(AssertionError.class, () -> work.run(2)));
        }
    }

    @Test
    void anInterruptEndsTheWorkAndIsPassedOn() {
        Squares work = new Squares(Long.MAX_VALUE);
        Thread.currentThread().interrupt();
        work.run(2);
        assertTrue(Thread.interrupted());
        assertFalse(Thread.currentThread().isInterrupted());
    }

    @Test
    void watchesFromTheCallersThread() {
        Thread caller = Thread.currentThread();
        AtomicInteger watched = new AtomicInteger();
        Squares work = new Squares(Long.MAX_VALUE) {
            @Override
            protected boolean claim(long unit, long[] slot) {
                return watched.get() < 3;
            }

            @Override
            protected void watch() {
                assertSame(caller, Thread.currentThread());
                watched.incrementAndGet();
            }
        };
        work.run(2);
        assertTrue(watched.get() >= 3);
    }

    /** Every tenth unit needs all before it: it is described after they were committed. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 7})
    void unitsThatNeedCommitsWaitForThem(int threads) {
        List<Integer> committedAtClaim = new ArrayList<>();
        List<Long> results = new ArrayList<>();
        new OrderedWork<long[]>() {
            private long claimed;

            @Override
            protected long[] newSlot() {
                return new long[1];
            }

            @Override
            protected Worker<long[]> newWorker() {
                return (unit, slot) -> slot[0] = unit;
            }

            @Override
            protected boolean needsCommits() {
                return claimed % 10 == 0;
            }

            @Override
            protected boolean claim(long unit, long[] slot) {
                if (unit % 10 == 0) {
                    synchronized (results) {
                        committedAtClaim.add(results.size());
                    }
                }
                claimed = unit + 1;
                return unit < 95;
            }

            @Override
            protected void commit(long unit, long[] slot) {
                synchronized (results) {
                    results.add(slot[0]);
                }
            }

            @Override
            protected void watch() {
                // Nobody looks.
            }
        }.run(threads);
        assertEquals(List.of(0, 10, 20, 30, 40, 50, 60, 70, 80, 90), committedAtClaim);
        assertEquals(95, results.size());
    }
}
