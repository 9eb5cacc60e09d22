/**
 * Readers for triangle mesh files: Wavefront OBJ and PLY, and what they share. They know nothing of scene files.
 *
 * <p>May depend on: {@code core.geometry}, vecmath.
 */
@NullMarked
package org.daybreak.scenes.mesh;

import org.jspecify.annotations.NullMarked;
