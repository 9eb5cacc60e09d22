package org.daybreak.core.geometry;

import javax.vecmath.Tuple3d;

/** Argument checks shared by the shape descriptions. */
final class Shapes {
    private Shapes() {}

    static void requireFinite(String what, Tuple3d p) {
        if (!Double.isFinite(p.x) || !Double.isFinite(p.y) || !Double.isFinite(p.z)) {
            throw new IllegalArgumentException(what + " must be finite but is " + p);
        }
    }

    static void requirePositive(String what, double value) {
        if (!(value > 0) || !Double.isFinite(value)) {
            throw new IllegalArgumentException(what + " must be positive and finite but is " + value);
        }
    }
}
