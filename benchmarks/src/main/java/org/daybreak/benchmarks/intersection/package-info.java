/**
 * Speed of the ray intersectors: scenes, rays, and the comparison with Embree. The comparison itself needs the Foreign
 * Function and Memory API and lies in {@code src/main/java25}.
 */
@NullMarked
package org.daybreak.benchmarks.intersection;

import org.jspecify.annotations.NullMarked;
