/**
 * OpenEXR, Radiance HDR and PFM for {@link javax.imageio.ImageIO}, which finds the classes here by
 * {@code META-INF/services}. Readers give images of 32-bit floats in linear RGB ({@code CS_LINEAR_RGB}) or linear grey,
 * with the very numbers of the file; nothing is scaled, clamped or tone-mapped. Writers take such images as they are, and
 * decode sRGB images to linear light.
 *
 * <p>The interface of ImageIO knows neither layers nor attributes; programs that need them use
 * {@link org.daybreak.exr.ExrReader} and {@link org.daybreak.exr.ExrWriter}.
 *
 * <p>Depends on the JDK and {@code org.daybreak.exr} only.
 */
@NullMarked
package org.daybreak.exr.imageio;

import org.jspecify.annotations.NullMarked;
