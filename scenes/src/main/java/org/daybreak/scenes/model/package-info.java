/**
 * Reads files that hold a bare model, without camera and light, into description records.
 *
 * <p>May depend on: {@code scenes.description}, {@code scenes.mesh}.
 */
@NullMarked
package org.daybreak.scenes.model;

import org.jspecify.annotations.NullMarked;
