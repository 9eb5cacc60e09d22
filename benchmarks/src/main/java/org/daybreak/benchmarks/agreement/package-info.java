/** Comparison of images with those of other renderers. */
@NullMarked
package org.daybreak.benchmarks.agreement;

import org.jspecify.annotations.NullMarked;
