/**
 * Shapes and points on them: triangle meshes, analytic shapes, and the {@link org.daybreak.core.geometry.SurfacePoint}
 * that every intersection, material and light speaks of.
 *
 * <p>May depend on: {@code core.math}, {@code core.sampling}, {@code core.accel}.
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.core.geometry;
