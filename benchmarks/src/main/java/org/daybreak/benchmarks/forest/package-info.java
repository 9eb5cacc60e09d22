/** Memory and build time of scenes of very many instances. */
@NullMarked
package org.daybreak.benchmarks.forest;

import org.jspecify.annotations.NullMarked;
