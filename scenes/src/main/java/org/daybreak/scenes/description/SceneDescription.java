package org.daybreak.scenes.description;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * All that a scene file and the files it includes say. Immutable.
 *
 * @param file the main file
 * @param root the scene
 * @param ids the objects that have a name
 * @param folders further folders in which the scene's files are searched
 * @param files the files that were read so far, the main file first
 */
public record SceneDescription(
        Path file, ObjectDescription root, Map<String, ObjectDescription> ids, List<Path> folders, List<Path> files) {
    /** Copies the collections. */
    public SceneDescription {
        ids = java.util.Collections.unmodifiableMap(new LinkedHashMap<>(ids));
        folders = List.copyOf(folders);
        files = List.copyOf(files);
    }
}
