package org.daybreak.accel.vector;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The classes for 256 and 512 bits are one source with the number replaced; edit one, then {@code sed s/512/256/g}. */
class KernelsInStepTest {
    private static final Path SOURCES = Path.of("src/main/java/org/daybreak/accel/vector");

    @ParameterizedTest
    @ValueSource(strings = {"Intersector", "Provider"})
    void differOnlyInWidth(String suffix) throws IOException {
        assertEquals(read("Vector512" + suffix).replace("512", "256"), read("Vector256" + suffix));
    }

    @Test
    void wideKernelUsesWideSpecies() throws IOException {
        assertTrue(read("Vector512Intersector").contains("FloatVector.SPECIES_512"));
    }

    private static String read(String name) throws IOException {
        return Files.readString(SOURCES.resolve(name + ".java"), StandardCharsets.UTF_8);
    }
}
