/**
 * Metropolis light transport (Veach 1997, chapter 11; thesis, chapter 5): Markov chains of light paths whose stationary density
 * is what they bring to the image. What all such renderers share — start-up by resampled seeds, chains as units of work, direct
 * light apart, two stages, the report — is in {@code ChainRenderer}; a {@link
 * org.daybreak.metropolis.ChainAlgorithm} says what a state is and how it moves.
 *
 * <p>May depend on: {@code org.daybreak.core}, {@code org.daybreak.antialiasing}, {@code org.daybreak.tracing},
 * {@code org.daybreak.bidirectional}.
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.metropolis;
