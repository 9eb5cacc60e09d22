/**
 * Random numbers with an address, low-discrepancy points, warps from the unit square, and tabulated distributions.
 *
 * <p>The same seed and address give the same numbers, whatever thread asks. All uniform numbers lie in [0, 1). Each
 * {@code toX} warp has its density {@code toXPdf} beside it. May depend on {@code org.daybreak.core.math} only.
 */
@NullMarked
package org.daybreak.core.sampling;

import org.jspecify.annotations.NullMarked;
