/**
 * Intersectors on the incubating Vector API: one kernel for 256-bit and one for 512-bit registers. Found by {@link
 * java.util.ServiceLoader}; used only where the API runs well.
 *
 * <p>May depend on {@code org.daybreak.core.accel} and {@code jdk.incubator.vector}.
 */
@NullMarked
package org.daybreak.accel.vector;

import org.jspecify.annotations.NullMarked;
