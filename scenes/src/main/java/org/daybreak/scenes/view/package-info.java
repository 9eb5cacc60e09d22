/**
 * Camera, light and material for models that come without: what lets a bare mesh be rendered.
 *
 * <p>May depend on: {@code core}.
 */
@NullMarked
package org.daybreak.scenes.view;

import org.jspecify.annotations.NullMarked;
