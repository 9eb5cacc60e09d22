/**
 * Tests across modules: renderers against closed forms, against reference images, against each other and against
 * themselves.
 *
 * <p>May depend on: all modules.
 */
@NullMarked
package org.daybreak.convergence;

import org.jspecify.annotations.NullMarked;
