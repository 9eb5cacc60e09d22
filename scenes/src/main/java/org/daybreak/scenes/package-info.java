/**
 * Reads scene files into the scene graph in three steps: text to description records ({@code scenes.mitsuba}, {@code
 * scenes.model}), records to scene graph ({@code scenes.build}), and this package, which joins them for callers.
 *
 * <p>Files mean what they mean to Mitsuba 3.9, with these differences.
 *
 * <ul>
 *   <li>The axis of {@code <rotate>} is normalised; Mitsuba shears if it is not of length 1.
 *   <li>Mirroring keeps the outside of a sphere outside; Mitsuba turns it inside out. For meshes without normals both let
 *       the winding in world space decide.
 *   <li>Vertices that lack a normal in a file that has some get a computed one; in Mitsuba it is undefined.
 *   <li>More is accepted: polygons in PLY, negative OBJ indices, non-uniformly scaled spheres, {@code #rrggbb},
 *       {@code <srgb>}, integers where floats are meant, references to what stands further down.
 *   <li>Less is accepted: an id, property or definition given twice, properties that contradict each other, negative
 *       radiance, reflectances above 1 from any source.
 *   <li>Nothing is clipped in front of or behind the camera, and lights cannot be hidden from it.
 *   <li>Samplers only say how many samples to take.
 * </ul>
 *
 * <p>May depend on: all packages of {@code scenes}, {@code core}.
 */
@NullMarked
package org.daybreak.scenes;

import org.jspecify.annotations.NullMarked;
