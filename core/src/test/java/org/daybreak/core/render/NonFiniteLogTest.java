package org.daybreak.core.render;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

final class NonFiniteLogTest {
    @Test
    void countsAllAndKeepsTheFirst() {
        NonFiniteLog log = new NonFiniteLog();
        for (int i = 0; i < 12; i++) {
            log.addSample(5, i, 3, 7);
        }
        NonFiniteLog other = new NonFiniteLog();
        for (int i = 0; i < 12; i++) {
            other.addLightPath(5, i);
        }
        log.addAll(other);
        assertEquals(24, log.count());
        assertEquals(16, log.addresses().size());
        assertEquals("seed 5, pixel (0, 3), sample 7", log.addresses().get(0));
        assertEquals("seed 5, light subpath 3", log.addresses().get(15));
        log.clear();
        assertEquals(0, log.count());
    }
}
