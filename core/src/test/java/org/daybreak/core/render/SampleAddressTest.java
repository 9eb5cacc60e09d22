package org.daybreak.core.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class SampleAddressTest {
    @Test
    void readsWhatLogsSay() {
        NonFiniteLog log = new NonFiniteLog();
        log.addSample(Long.MIN_VALUE, 3, 65535, 1L << 40);
        SampleAddress address = SampleAddress.parse(log.addresses().get(0));
        assertEquals(new SampleAddress(Long.MIN_VALUE, 3, 65535, 1L << 40), address);
        assertEquals(log.addresses().get(0), address.toString());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "",
                "seed 0",
                "seed 0, pixel (1, 2)",
                "seed 0, light subpath 7",
                "seed 0, pixel (-1, 2), sample 0",
                "seed 9999999999999999999, pixel (1, 2), sample 0"
            })
    void refusesOtherTexts(String text) {
        assertEquals(
                "'" + text + "' is no address of a sample, such as 'seed 0, pixel (3, 4), sample 5'",
                assertThrows(ParameterException.class, () -> SampleAddress.parse(text))
                        .getMessage());
    }
}
