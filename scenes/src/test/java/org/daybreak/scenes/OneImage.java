package org.daybreak.scenes;

import java.nio.file.Path;
import java.util.Set;
import org.daybreak.scenes.image.ImageLoader;
import org.daybreak.scenes.image.LoadedImage;

/** Stands in for the decoders of images where these are not what is tested: all PNG and JPEG files hold the same two pixels. */
public final class OneImage implements ImageLoader {
    @Override
    public Set<String> endings() {
        return Set.of("png", "jpg");
    }

    @Override
    public LoadedImage load(Path file) {
        return new LoadedImage.Bytes(2, 1, 4, new byte[] {0, 1, 2, 3, 90, 120, -1, -1});
    }

    @Override
    public LoadedImage load(byte[] content, String ending) {
        return load(Path.of(ending));
    }
}
