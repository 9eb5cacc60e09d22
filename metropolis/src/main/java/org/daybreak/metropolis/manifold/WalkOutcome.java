package org.daybreak.metropolis.manifold;

/** How a walk on a specular manifold ended. */
public enum WalkOutcome {
    /** The chain leads to the target. */
    CONVERGED,
    /** The step that was left at last met nothing. */
    MISSED,
    /** The step that was left at last met a surface without the delta lobe that the chain needs, or the lobe led elsewhere. */
    KIND_CHANGED,
    /** The chain does not change differentiably: at a caustic, at a grazing angle, or where a surface has no derivatives. */
    SINGULAR,
    /** The target lies behind the last vertex of the chain. */
    BEHIND,
    /** Neither steps nor shorter ones came near enough within the number of iterations. */
    STALLED,
    /** The walk back does not lead to where it started: another chain joins the same ends. */
    NOT_REVERSIBLE
}
