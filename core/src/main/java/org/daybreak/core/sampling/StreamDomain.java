package org.daybreak.core.sampling;

/**
 * What random numbers are for. Streams of different domains are independent also when their seed and indices are
 * equal, so that one part of an algorithm that draws more numbers does not shift those of another.
 */
public enum StreamDomain {
    /** Samples of a pixel; index = pixel, sub-index = sample. */
    PIXEL(1),
    /** Points on the lens that are drawn apart from a pixel. */
    LENS(2),
    /** Paths that start at a light; index = path. */
    LIGHT_PATH(3),
    /** Connections between subpaths; index = path. */
    CONNECTION(4),
    /** Candidates for the start of Markov chains; index = candidate. */
    BOOTSTRAP(5),
    /** Markov chains; index = chain. */
    CHAIN(6),
    /** Photons; index = pass, sub-index = photon. */
    PHOTON(7),
    /** Random choices in the making of a scene. */
    SCENE(8),
    /** Inputs of self-checks. */
    SELF_CHECK(9);

    private final int id;

    StreamDomain(int id) {
        this.id = id;
    }

    /** The number that enters the hash. It never changes, as pictures depend on it; order and name may. */
    int id() {
        return id;
    }
}
