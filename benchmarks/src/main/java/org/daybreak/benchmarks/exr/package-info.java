/** Speed of the OpenEXR codec, compared with the official library by {@code benchmarks/exr_speed.py}. */
@NullMarked
package org.daybreak.benchmarks.exr;

import org.jspecify.annotations.NullMarked;
