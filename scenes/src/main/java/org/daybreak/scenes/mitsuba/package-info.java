/**
 * Reads the XML of Mitsuba 3 into description records. Knows elements, attributes, substitution, inclusion and transforms, but
 * not which objects and properties exist.
 *
 * <p>May depend on: {@code scenes.description}, {@code core.render} (nearest names), {@code core.color}, vecmath.
 */
@NullMarked
package org.daybreak.scenes.mitsuba;

import org.jspecify.annotations.NullMarked;
