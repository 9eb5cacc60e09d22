/**
 * What a scene file says, independent of its syntax and of the engine: objects with typed properties, each with the place in
 * the file it came from, and the collection of problems found on the way. Everything but {@link
 * org.daybreak.scenes.description.ProblemList} is immutable.
 *
 * <p>May depend on: vecmath, {@code core.render} (nearest names), {@code core.geometry} (meshes).
 */
@NullMarked
package org.daybreak.scenes.description;

import org.jspecify.annotations.NullMarked;
