/**
 * Reading and writing of image files: OpenEXR scanline images, PFM, and 8-bit PNG for display.
 *
 * <p>OpenEXR is read by {@link org.daybreak.exr.ExrReader} and written by {@link org.daybreak.exr.ExrWriter}, both in
 * plain Java. {@link org.daybreak.exr.ExrImage} holds the pixels and {@link org.daybreak.exr.ExrHeader} what the file
 * says about them. Compressions are cut off behind one seam: a {@code ChunkCodec} turns the raw bytes of a chunk into
 * packed bytes and back, and {@link org.daybreak.exr.Compression} chooses it. A new compression is a new codec and one
 * more case there.
 *
 * <p>Every failure that comes from a file (missing, truncated, garbage, unsupported, disk full) is one
 * {@link org.daybreak.exr.ImageFileException} that names the file. Writers write to a temporary file beside the target
 * and move it into place ({@link org.daybreak.exr.AtomicFiles}); a failed write leaves nothing behind.
 *
 * <p>Depends on the JDK only; of {@code java.desktop} only ImageIO and BufferedImage are used, which need no display.
 *
 * @see <a href="https://openexr.com/en/latest/OpenEXRFileLayout.html">OpenEXR file layout</a>
 */
@NullMarked
package org.daybreak.exr;

import org.jspecify.annotations.NullMarked;
