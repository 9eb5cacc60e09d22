/**
 * Turns description records into the scene graph: one table says which objects and properties exist, and checks, nearest
 * names and documentation derive from it.
 *
 * <p>May depend on: {@code scenes.description}, {@code scenes.mesh}, {@code scenes.image}, {@code core}.
 */
@NullMarked
package org.daybreak.scenes.build;

import org.jspecify.annotations.NullMarked;
