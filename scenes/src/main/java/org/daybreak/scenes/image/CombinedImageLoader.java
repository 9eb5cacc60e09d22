package org.daybreak.scenes.image;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Set;
import java.util.TreeSet;

/** Two loaders, the first of which goes first. */
final class CombinedImageLoader implements ImageLoader {
    private final ImageLoader first;
    private final ImageLoader second;
    private final Set<String> endings;

    CombinedImageLoader(ImageLoader first, ImageLoader second) {
        this.first = first;
        this.second = second;
        Set<String> all = new TreeSet<>(first.endings());
        all.addAll(second.endings());
        this.endings = Set.copyOf(all);
    }

    @Override
    public Set<String> endings() {
        return endings;
    }

    @Override
    public LoadedImage load(Path file) throws IOException {
        return (first.endings().contains(ImageLoader.ending(file)) ? first : second).load(file);
    }

    @Override
    public LoadedImage load(byte[] content, String ending) throws IOException {
        return (first.endings().contains(ending) ? first : second).load(content, ending);
    }
}
