/** Readers of photometric data of luminaires. */
@org.jspecify.annotations.NullMarked
package org.daybreak.scenes.photometry;
