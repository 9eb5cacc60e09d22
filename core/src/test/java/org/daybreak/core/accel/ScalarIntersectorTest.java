package org.daybreak.core.accel;

import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ScalarIntersectorTest {
    private static final PrimitiveSet[] NO_LEVELS = {};
    private final IntersectorProvider provider = new ScalarProvider();

    @ParameterizedTest
    @ValueSource(doubles = {1, 1e-18, 1e-4, 1e4, 1e12})
    void trianglesAtAnyScale(double scale) {
        SplittableRandom random = new SplittableRandom(1);
        for (int count : new int[] {1, 2, 4, 5, 17, 100, 1000}) {
            PrimitiveSet set = IntersectorChecks.randomTriangles(random, count, count < 17 ? 1 : 0.3, scale);
            IntersectorChecks.agreesWithBruteForce(provider, set, NO_LEVELS, random, scale, 2000, 1);
        }
    }

    @Test
    void mixedPrimitivesAndInstances() {
        SplittableRandom random = new SplittableRandom(2);
        for (int round = 0; round < 5; round++) {
            PrimitiveSet[] levels = new PrimitiveSet[6];
            Instance[] instances = new Instance[6];
            for (int i = 0; i < 6; i++) {
                levels[i] = IntersectorChecks.mixed(random, 20 * i, 5, 0.3, 1, new Instance[0]);
                instances[i] =
                        new Instance(IntersectorChecks.randomAffine(random, 0.6, 1), provider.build(levels[i], 1));
            }
            PrimitiveSet set = IntersectorChecks.mixed(random, 100, 9, 0.2, 1, instances);
            IntersectorChecks.agreesWithBruteForce(provider, set, levels, random, 1, 4000, 1);
        }
    }
}
