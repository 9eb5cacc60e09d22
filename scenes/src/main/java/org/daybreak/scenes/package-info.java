/**
 * Reads scene files into the scene graph in three steps: text to description records ({@code scenes.mitsuba}), records to
 * scene graph ({@code scenes.build}), and this package, which joins them for callers.
 *
 * <p>May depend on: all packages of {@code scenes}, {@code core}.
 */
@NullMarked
package org.daybreak.scenes;

import org.jspecify.annotations.NullMarked;
