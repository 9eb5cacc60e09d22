package org.daybreak.accel.vector;

import java.util.Optional;
import org.daybreak.core.accel.Intersector;
import org.daybreak.core.accel.IntersectorProvider;
import org.daybreak.core.accel.PrimitiveSet;
import org.jspecify.annotations.Nullable;

/** Provides BVHs for 256-bit vectors. */
public final class Vector256Provider implements IntersectorProvider {
    private static final int BITS = 256;

    private @Nullable WarmUp warmUp;

    @Override
    public String id() {
        return "vector" + BITS;
    }

    @Override
    public String description() {
        return "BVH with " + BITS / 32 + " children, " + BITS + "-bit vectors";
    }

    @Override
    public int priority() {
        return BITS;
    }

    @Override
    public Optional<String> unavailability() {
        return VectorSupport.unavailability(BITS);
    }

    @Override
    public Intersector build(PrimitiveSet primitives, int threads) {
        return Vector256Intersector.build(primitives, threads, warmUp());
    }

    @Override
    public boolean awaitFullSpeed(long milliseconds) throws InterruptedException {
        return warmUp().await(milliseconds);
    }

    private synchronized WarmUp warmUp() {
        WarmUp started = warmUp;
        if (started == null) {
            started = Vector256Intersector.warmUp();
            warmUp = started;
        }
        return started;
    }
}
