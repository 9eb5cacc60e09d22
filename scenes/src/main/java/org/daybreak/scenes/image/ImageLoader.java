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
     * Reads an image that is contained in another file. Only loaders of formats that occur there need to.
     *
     * @param content what would be in a file
     * @param ending the file's ending, one of {@link #endings}
     * @throws IOException as for {@link #load(Path)}
     */
    default LoadedImage load(byte[] content, String ending) throws IOException {
        throw new IOException("images of type '" + ending + "' cannot be read from inside other files");
    }

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
