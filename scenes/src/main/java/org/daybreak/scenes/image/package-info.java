/**
 * Images that scenes refer to. The formats of the JDK are read here; others come in through
 * {@link org.daybreak.scenes.image.ImageLoader}.
 *
 * <p>May depend on: JDK.
 */
@NullMarked
package org.daybreak.scenes.image;

import org.jspecify.annotations.NullMarked;
