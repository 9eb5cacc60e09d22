/**
 * The ways to change a path (Veach 1997, §11.4; thesis §5.2): each proposes a path and knows with which density it does.
 *
 * <p>May depend on what {@code org.daybreak.metropolis} may.
 */
@org.jspecify.annotations.NullMarked
package org.daybreak.metropolis.strategy;
