package org.daybreak.core.scene;

import java.util.ArrayList;
import java.util.List;
import org.daybreak.core.geometry.BoundingSphere;

/** Gathers spheres and keeps their number small: the two whose union adds least to their volume become one. */
final class DeltaSpheres {
    /** Whoever aims at them looks at all of them each time. */
    private static final int MOST = 8;

    private final List<BoundingSphere> spheres = new ArrayList<>();

    /** Adds a sphere. */
    void add(BoundingSphere sphere) {
        spheres.add(sphere);
        if (spheres.size() > MOST) {
            mergeClosest();
        }
    }

    private void mergeClosest() {
        int first = 0;
        int second = 1;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < spheres.size(); i++) {
            for (int j = i + 1; j < spheres.size(); j++) {
                double growth =
                        volume(spheres.get(i).union(spheres.get(j))) - volume(spheres.get(i)) - volume(spheres.get(j));
                if (growth < least) {
                    least = growth;
                    first = i;
                    second = j;
                }
            }
        }
        BoundingSphere both = spheres.get(first).union(spheres.remove(second));
        spheres.set(first, both);
    }

    private static double volume(BoundingSphere sphere) {
        return sphere.radius() * sphere.radius() * sphere.radius();
    }

    /** The spheres. */
    List<BoundingSphere> build() {
        return List.copyOf(spheres);
    }
}
