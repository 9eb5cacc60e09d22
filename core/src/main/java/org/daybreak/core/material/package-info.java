/**
 * Materials: scattering functions with sample, evaluate and density in both transport directions, and textures.
 *
 * <p>May depend on: {@code core.math}, {@code core.color}, {@code core.sampling}, {@code core.geometry}.
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.core.material;
