package org.daybreak.scenes.image;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Set;

/**
 * Reads image files for textures and environments. Programs pass one that knows the formats they have on board and may fall
 * back on {@link StandardImageLoader}.
 */
public interface ImageLoader {
    /** File name endings that can be read, in lower case without the dot. */
    Set<String> endings();

    /**
     * Reads an image.
     *
     * @param file a file that exists, with one of the endings
     * @throws IOException with a message fit for users, without the file's name, if it cannot be read
     */
    LoadedImage load(Path file) throws IOException;

    /**
     * A loader that asks this one for the endings it knows and another for the rest.
     *
     * @param other the other loader
     */
    default ImageLoader or(ImageLoader other) {
        return new CombinedImageLoader(this, other);
    }

    /** The ending of a file's name in lower case without the dot, empty if it has none. */
    static String ending(Path file) {
        Path last = file.getFileName();
        String name = last == null ? "" : last.toString();
        return name.substring(name.lastIndexOf('.') + 1).toLowerCase(java.util.Locale.ROOT);
    }
}
