/**
 * The weights of bidirectional path tracing on the paths of all shipped scenes, checked against densities that are
 * rebuilt from the vertices alone. In the package of the module for its package-private path containers.
 */
@NullMarked
package org.daybreak.bidirectional;

import org.jspecify.annotations.NullMarked;
