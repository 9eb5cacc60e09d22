package org.daybreak.core.testing;

import static org.junit.jupiter.api.Assertions.assertTrue;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;

/** Tests whether code allocates. */
public final class Allocation {
    private Allocation() {}

    /**
     * Fails unless a round of work comes that allocates less than a byte per unit: until the code is compiled, escape analysis has not
     * removed what it will.
     *
     * @param unit what the work consists of, for the message
     * @param units number of units in a round
     * @param rounds most rounds before the one that must allocate nothing
     * @param round does the work of a round, in this thread
     */
    public static void assertNone(String unit, int units, int rounds, Runnable round) {
        ThreadMXBean threads = (ThreadMXBean) ManagementFactory.getThreadMXBean();
        for (int warm = 0; ; warm++) {
            long before = threads.getCurrentThreadAllocatedBytes();
            round.run();
            double perUnit = (threads.getCurrentThreadAllocatedBytes() - before) / (double) units;
            if (perUnit < 1) {
                return;
            }
            assertTrue(warm < rounds, perUnit + " bytes per " + unit);
        }
    }
}
