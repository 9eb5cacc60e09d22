/**
 * Antialiasing methods: where in a pixel samples are taken and which numbers the paths through them use.
 *
 * <p>May depend on: {@code org.daybreak.core.render}, {@code org.daybreak.core.sampling}.
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.antialiasing;
