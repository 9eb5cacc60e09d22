/**
 * Specular manifolds (Jakob and Marschner 2012, “Manifold Exploration: A Markov Chain Monte Carlo Technique for Rendering Scenes
 * with Difficult Specular Transport”): chains of delta reflections and refractions between two vertices, how they change with their
 * ends, and walks that move an end. Knows nothing of Markov chains.
 *
 * <p>May depend on: {@code org.daybreak.core}.
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.metropolis.manifold;
