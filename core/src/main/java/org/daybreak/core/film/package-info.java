/**
 * The film: linear double accumulation of samples and splats, reconstruction filters, moments and auxiliary images.
 *
 * <p>May depend on: {@code core.math}, {@code core.color}.
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.core.film;
