/**
 * Writes scenes as files of the native format: from descriptions, in which all readers express what they read, so that
 * nothing is lost on the way.
 *
 * <p>May depend on: {@code scenes.description}, {@code scenes.build}, {@code scenes.mesh}, {@code scenes.view}, {@code core}.
 */
@NullMarked
package org.daybreak.scenes.write;

import org.jspecify.annotations.NullMarked;
