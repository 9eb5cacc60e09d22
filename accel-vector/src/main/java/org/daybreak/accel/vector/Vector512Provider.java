package org.daybreak.accel.vector;

import java.util.Optional;
import org.daybreak.core.accel.Intersector;
import org.daybreak.core.accel.IntersectorProvider;
import org.daybreak.core.accel.PrimitiveSet;
import org.jspecify.annotations.Nullable;

/** Provides BVHs for 512-bit vectors. */
public final class Vector512Provider implements IntersectorProvider {
    private static final int BITS = 512;

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
        return Vector512Intersector.build(primitives, threads, started());
    }

    @Override
    public void warmUp() {
        started();
    }

    @Override
    public boolean awaitFullSpeed(long milliseconds) throws InterruptedException {
        return started().await(milliseconds);
    }

    private synchronized WarmUp started() {
        WarmUp current = warmUp;
        if (current == null) {
            current = Vector512Intersector.warmUp();
            warmUp = current;
        }
        return current;
    }
}
