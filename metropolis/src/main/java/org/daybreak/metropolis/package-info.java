/**
 * Metropolis light transport (Veach 1997, chapter 11; thesis, chapter 5): Markov chains of light paths whose stationary density
 * is what they bring to the image. The ways to change a path are in {@code strategy}, chains over random numbers in {@code primary},
 * what all of them share in {@code chains}.
 *
 * <p>May depend on: {@code org.daybreak.core}, {@code org.daybreak.antialiasing}, {@code org.daybreak.tracing},
 * {@code org.daybreak.bidirectional}.
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.metropolis;
