package org.daybreak.core.testing;

import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.junit.jupiter.api.Test;

class AllocationTest {
    @Test
    void workThatAllocatesNothingPasses() {
        double[] sum = new double[1];
        Allocation.assertNone("step", 1000, 40, () -> sum[0]++);
        assertTrue(sum[0] > 0);
    }

    @Test
    void fewBytesPerUnitAreFoundOut() {
        Object[] kept = new Object[1];
        AssertionError e = assertThrows(
                AssertionError.class, () -> Allocation.assertNone("step", 1000, 3, () -> kept[0] = new byte[2000]));
        assertTrue(e.getMessage().contains("bytes per step"), e.getMessage());
    }
}
