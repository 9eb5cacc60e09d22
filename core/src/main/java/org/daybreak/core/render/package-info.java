/**
 * The renderer interface: what a rendering algorithm offers (typed parameters) and what it is given (scene, camera, film,
 * context). Command line, Java callers and host programs all use these types and nothing else.
 *
 * <p>May depend on: all other packages of {@code core}.
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.core.render;
