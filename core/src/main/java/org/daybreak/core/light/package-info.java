/**
 * Emitters with sampling, evaluation and densities for both transport directions, and the choice among many lights.
 *
 * <p>May depend on: {@code core.math}, {@code core.color}, {@code core.sampling}, {@code core.geometry},
 * {@code core.material} (textures only).
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.core.light;
