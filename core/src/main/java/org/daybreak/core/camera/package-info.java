/**
 * Cameras that can be sampled from the film and from a point of the scene.
 *
 * <p>May depend on: {@code core.math}, {@code core.sampling}, {@code core.geometry}.
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.core.camera;
