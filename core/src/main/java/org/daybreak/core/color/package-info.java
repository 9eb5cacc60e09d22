/**
 * The spectral quantity of transport and the conversions to and from encoded colour.
 *
 * <p>May depend on {@code org.daybreak.core.math} only.
 */
@NullMarked
package org.daybreak.core.color;

import org.jspecify.annotations.NullMarked;
