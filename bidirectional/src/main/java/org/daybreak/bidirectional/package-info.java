/**
 * Bidirectional path tracing (Veach 1997, chapter 10; thesis, chapter 4): light and eye subpaths, their recombination in
 * all ways, and the weights that make one estimate of them.
 *
 * <p>May depend on: {@code org.daybreak.core}, {@code org.daybreak.tracing}.
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.bidirectional;
