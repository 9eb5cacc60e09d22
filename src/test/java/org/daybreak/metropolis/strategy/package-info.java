/** Densities of mutations of Metropolis light transport, against others that are computed from the vertices alone. */
@NullMarked
package org.daybreak.metropolis.strategy;

import org.jspecify.annotations.NullMarked;
