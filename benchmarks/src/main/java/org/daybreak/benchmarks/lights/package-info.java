/** How the cost of choosing a light grows with their number. */
@org.jspecify.annotations.NullMarked
package org.daybreak.benchmarks.lights;
