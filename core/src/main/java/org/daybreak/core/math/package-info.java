/**
 * Scalar kernels, frames, bounds, affine transforms and the conversions between measures.
 *
 * <p>Everything here is plain {@code double} arithmetic. Functions for hot paths take and return primitives or write
 * into an array of the caller. This package is the lowest of the core: it may depend on vecmath only, for the types of
 * the public scene interface.
 */
@NullMarked
package org.daybreak.core.math;

import org.jspecify.annotations.NullMarked;
