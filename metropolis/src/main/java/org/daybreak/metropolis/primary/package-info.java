/**
 * Markov chains over the random numbers that a sample of bidirectional path tracing is made of, its primary sample space:
 * primary-sample-space Metropolis light transport (Kelemen et al. 2002) and multiplexed Metropolis light transport (Hachisuka
 * et al. 2014).
 *
 * <p>May depend on what {@code org.daybreak.metropolis} may.
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.metropolis.primary;
