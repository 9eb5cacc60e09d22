/**
 * What all renderers by Markov chains share: start-up by resampled seeds, chains as units of work, direct light apart, two stages, error and
 * convergence, the report ({@link org.daybreak.metropolis.chains.ChainRenderer}). A {@link
 * org.daybreak.metropolis.chains.ChainAlgorithm} says what a state is and how it moves.
 *
 * <p>May depend on: {@code org.daybreak.core}, {@code org.daybreak.antialiasing}, {@code org.daybreak.tracing},
 * {@code org.daybreak.bidirectional}; on no other package of this module.
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.metropolis.chains;
