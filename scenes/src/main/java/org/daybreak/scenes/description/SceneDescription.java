package org.daybreak.scenes.description;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
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

    /**
     * Finds a file that an object names: beside the scene file that names it, else beside the main scene file, else in the
     * folders the scene lists.
     *
     * @param given the name as it stands in the file
     * @param namedIn the file it stands in
     * @return the file; the first of these places if it is in none of them
     * @throws InvalidPathException if the name is none of a file
     */
    public Path resolve(String given, Path namedIn) {
        // Programs on Windows write the separators of their system.
        String name = given.indexOf('\\') >= 0 && !Files.exists(namedIn.resolveSibling(given))
                ? given.replace('\\', '/')
                : given;
        Path first = namedIn.resolveSibling(name);
        List<Path> places = new ArrayList<>(List.of(first, file.resolveSibling(name)));
        folders.forEach(folder -> places.add(folder.resolve(name)));
        return places.stream().filter(Files::exists).findFirst().orElse(first);
    }
}
