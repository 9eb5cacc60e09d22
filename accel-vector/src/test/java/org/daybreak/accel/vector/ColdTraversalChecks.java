package org.daybreak.accel.vector;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.SplittableRandom;
import java.util.function.Function;
import org.daybreak.core.accel.Instance;
import org.daybreak.core.accel.Intersector;
import org.daybreak.core.accel.PrimitiveSet;
import org.daybreak.core.accel.Ray;
import org.daybreak.core.accel.SelfCheck;
import org.daybreak.core.testing.IntersectorChecks;

/** A kernel and the traversal that answers before it is compiled must agree to the last bit. */
final class ColdTraversalChecks {
    private ColdTraversalChecks() {}

    static void sameBits(Function<PrimitiveSet, Intersector> cold, Function<PrimitiveSet, Intersector> kernel) {
        SplittableRandom random = new SplittableRandom(8);
        PrimitiveSet level = IntersectorChecks.mixed(random, 300, 5, 0.2, 1, new Instance[0]);
        double[] placed = IntersectorChecks.randomAffine(random, 0.6, 1);
        for (int triangles : new int[] {1, 12, 100, 2000, 20_000}) {
            double size = 1 / Math.cbrt(triangles);
            Intersector a = cold.apply(withInstance(triangles, size, placed, cold.apply(level)));
            Intersector b = kernel.apply(withInstance(triangles, size, placed, kernel.apply(level)));
            Ray first = new Ray();
            Ray second = new Ray();
            int hits = 0;
            for (int i = 0; i < 40_000; i++) {
                SelfCheck.aim(first, random, i % 4 == 0 ? 1.5 : Double.POSITIVE_INFINITY);
                second.set(first.ox, first.oy, first.oz, first.dx, first.dy, first.dz, first.tMax);
                hits += a.intersect(first) ? 1 : 0;
                b.intersect(second);
                assertEquals(Double.doubleToRawLongBits(first.t), Double.doubleToRawLongBits(second.t));
                assertEquals(first.primitive, second.primitive);
                assertEquals(first.instance, second.instance);
                assertEquals(a.occluded(first), b.occluded(second));
            }
            assertTrue(hits > 1000);
        }
    }

    private static PrimitiveSet withInstance(int triangles, double size, double[] placed, Intersector level) {
        Instance[] instances = {new Instance(placed, level)};
        return IntersectorChecks.mixed(new SplittableRandom(triangles), triangles, 4, size, 1, instances);
    }
}
