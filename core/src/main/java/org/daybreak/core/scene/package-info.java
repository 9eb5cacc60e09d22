/**
 * Scenes: the editable {@link org.daybreak.core.scene.SceneGraph} in vecmath types, its compilation into the immutable,
 * thread-safe {@link org.daybreak.core.scene.Scene}, and the rays that are cast into that.
 *
 * <p>May depend on: {@code core.math}, {@code core.color}, {@code core.sampling}, {@code core.geometry},
 * {@code core.accel}, {@code core.material}, {@code core.light}, {@code core.camera}, {@code core.film} (settings).
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.core.scene;
