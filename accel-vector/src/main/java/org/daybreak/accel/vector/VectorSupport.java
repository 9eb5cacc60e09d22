package org.daybreak.accel.vector;

import java.util.Optional;
import jdk.incubator.vector.FloatVector;

/** Tells where vector kernels run well. */
final class VectorSupport {
    /** On older releases the compiler boxes vectors in the traversal loop. */
    private static final int LEAST_RELEASE = 25;

    private VectorSupport() {}

    /**
     * Why vectors of this width should not be used here; empty if they should.
     *
     * @param bits width of the registers
     */
    static Optional<String> unavailability(int bits) {
        int release = Runtime.version().feature();
        if (release < LEAST_RELEASE) {
            return Optional.of("vectors are fast from JDK " + LEAST_RELEASE + " on, this is " + release);
        }
        if (ModuleLayer.boot().findModule("jdk.incubator.vector").isEmpty()) {
            return Optional.of(
                    "module jdk.incubator.vector is absent; start java with --add-modules" + " jdk.incubator.vector");
        }
        String mode = System.getProperty("java.vm.info", "");
        if (!mode.contains("mixed mode") || mode.contains("emulated-client")) {
            return Optional.of("the optimising compiler is off (" + mode + ")");
        }
        int preferred = Species.preferredBits();
        if (preferred < bits) {
            return Optional.of("the widest fast registers here have " + preferred + " bits");
        }
        return Optional.empty();
    }

    /** Loads only where the module is present. */
    private static final class Species {
        static int preferredBits() {
            return FloatVector.SPECIES_PREFERRED.vectorBitSize();
        }
    }
}
