package org.daybreak.core.accel;

import java.util.Optional;

/** Provides the BVH with scalar traversal; always available. */
public final class ScalarProvider implements IntersectorProvider {
    @Override
    public String id() {
        return "scalar";
    }

    @Override
    public String description() {
        return "BVH with 4 children, scalar code, runs anywhere";
    }

    @Override
    public int priority() {
        return 0;
    }

    @Override
    public Optional<String> unavailability() {
        return Optional.empty();
    }

    @Override
    public Intersector build(PrimitiveSet primitives, int threads) {
        return ScalarIntersector.build(primitives, threads);
    }
}
