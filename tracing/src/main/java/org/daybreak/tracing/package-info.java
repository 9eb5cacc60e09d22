/**
 * Path tracer, classic ray tracer and light tracer, and the pixelwise renderer that runs per-pixel algorithms on tiles.
 *
 * <p>May depend on: {@code org.daybreak.core}, {@code org.daybreak.antialiasing}.
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.tracing;
