package org.daybreak.metropolis.strategy;

import org.daybreak.metropolis.chains.Outcome;

/**
 * Why the last operation on a path has failed. One object per worker, shared by all that build its paths: proposals
 * fail too often for an exception or an object each time.
 */
final class Failure {
    private Outcome outcome = Outcome.MISSED;
    private boolean escaped;

    /** Notes why. Returns false, as what has failed does. */
    boolean because(Outcome why) {
        escaped = false;
        outcome = why;
        return false;
    }

    /** Notes that a ray has left the scene. Returns false. */
    boolean becauseRayEscaped() {
        because(Outcome.MISSED);
        escaped = true;
        return false;
    }

    /** Why the last operation that returned false has failed. */
    Outcome outcome() {
        return outcome;
    }

    /** True if it failed because its ray has left the scene: on the way to a light at infinity that is none. */
    boolean escaped() {
        return escaped;
    }
}
