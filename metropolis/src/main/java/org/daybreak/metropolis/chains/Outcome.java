package org.daybreak.metropolis.chains;

/** How a proposal ended. */
public enum Outcome {
    /** There is a path, which may be accepted or not. */
    PROPOSED,
    /** A ray left the scene, or met nothing where the path needs a vertex. */
    MISSED,
    /** A walk along a chain of delta lobes did not arrive where the path needs it, or does not lead back. */
    UNREACHABLE,
    /** Something stands between two vertices. */
    OCCLUDED,
    /** A vertex came to lie on a material that scatters in another way than the move needs. */
    KIND_CHANGED,
    /** The film position lies outside of the film. */
    OFF_FILM,
    /** The path carries no light: a vertex scatters nothing, a light faces away, or limits of depth leave the path out. */
    BLACK
}
