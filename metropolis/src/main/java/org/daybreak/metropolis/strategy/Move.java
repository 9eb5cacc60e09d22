package org.daybreak.metropolis.strategy;

/**
 * What a proposal replaces: of a path x the vertices between two that stay, of a path y those that take their place. Mutable, owned
 * by one worker.
 */
public final class Move {
    /** The last vertex that stays on the side of the light; -1 if none does. The same index in both paths. */
    int kept;

    /** The first vertex that stays on the side of the lens, in the path that is left; k + 1 if none does. */
    int oldEnd;

    /** The same vertex in the path that is proposed. */
    int newEnd;

    /** Of strategies that can change the same vertices from either side: true if they began on the side of the lens. */
    boolean towardsLight;

    /** Creates a move. */
    public Move() {}

    /** Sets all. */
    void set(int keptVertex, int oldEndVertex, int newEndVertex) {
        kept = keptVertex;
        oldEnd = oldEndVertex;
        newEnd = newEndVertex;
    }

    /** Makes it the move back. */
    public void reverse() {
        int swapped = oldEnd;
        oldEnd = newEnd;
        newEnd = swapped;
    }
}
