package org.daybreak.scenes.mitsuba;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.daybreak.core.render.NearestName;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SceneDescription;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.jspecify.annotations.Nullable;

/**
 * Reads a scene file of Mitsuba 3, 2 or 0.6 and what it includes. One reader reads one scene. Document types are refused, so there are no
 * entities that could expand or reach out; depth of elements and of inclusion is limited.
 */
public final class MitsubaReader {
    /** Greatest number of files that include each other. */
    static final int INCLUDE_DEPTH = 16;

    /** Greatest number of files in a scene; one that is included twice by what is included twice soon makes billions. */
    private static final int MOST_FILES = 1 << 12;

    private static final Map<String, ObjectKind> KINDS =
            Arrays.stream(ObjectKind.values()).collect(Collectors.toUnmodifiableMap(ObjectKind::element, kind -> kind));

    private final ProblemList problems;
    private final Definitions definitions;
    private final Map<String, ObjectDescription> ids = new LinkedHashMap<>();
    private final List<Path> folders = new ArrayList<>();
    private final List<Path> open = new ArrayList<>();
    private final List<Path> files = new ArrayList<>();
    private boolean broken;

    private MitsubaReader(Map<String, String> defines, ProblemList problems) {
        this.definitions = new Definitions(defines);
        this.problems = problems;
    }

    /**
     * Reads a scene file.
     *
     * @param file the file
     * @param defines values of {@code $name}; they go before the {@code <default>} values in the files
     * @param problems receives all errors and warnings
     * @return what the files say; empty if part of it could not be read at all, so that further checks would find errors that
     *     are none
     */
    public static Optional<SceneDescription> read(Path file, Map<String, String> defines, ProblemList problems) {
        MitsubaReader reader = new MitsubaReader(defines, problems);
        List<PropertyDescription> content = reader.readFile(file, SourceLocation.of(file), true, false);
        for (String name : reader.definitions.unused()) {
            problems.error(
                    SourceLocation.of(file),
                    "no attribute uses the definition '" + name + "'"
                            + NearestName.hint(name, reader.definitions.defaults()));
        }
        if (reader.broken || content.size() != 1 || !(content.get(0).value() instanceof Value.Nested root)) {
            return Optional.empty();
        }
        return Optional.of(new SceneDescription(file, root.object(), reader.ids, reader.folders, reader.files));
    }

    /**
     * Reads a file.
     *
     * @param requestedAt where inclusion asks for it; errors about the file as a whole point there
     * @param main true for the scene's main file, whose root is returned; of included scenes the content is
     * @param old whether the file is in the dialect of Mitsuba 0.6 if it does not say
     */
    private List<PropertyDescription> readFile(Path file, SourceLocation requestedAt, boolean main, boolean old) {
        Path real = file.toAbsolutePath().normalize();
        if (open.contains(real)) {
            broken = true;
            problems.error(requestedAt, "the file includes itself: " + file);
            return List.of();
        }
        if (open.size() >= INCLUDE_DEPTH) {
            broken = true;
            problems.error(requestedAt, "files include each other more than " + INCLUDE_DEPTH + " levels deep");
            return List.of();
        }
        if (files.size() >= MOST_FILES) {
            broken = true;
            problems.error(requestedAt, "a scene may include files " + MOST_FILES + " times in all");
            return List.of();
        }
        String text;
        try {
            text = XmlText.read(file);
        } catch (IOException e) {
            broken = true;
            problems.error(requestedAt, (main ? "" : "cannot include " + file + ": ") + message(e));
            return List.of();
        }
        files.add(file);
        open.add(real);
        try {
            return XmlFileParser.parse(this, file, text, main, old);
        } finally {
            open.remove(open.size() - 1);
        }
    }

    private static String message(IOException e) {
        String message = e.getMessage();
        return message == null ? e.toString() : message;
    }

    /**
     * Reads the file that an {@code <include>} asks for.
     *
     * @param old whether it is in the dialect of Mitsuba 0.6 unless it says otherwise
     */
    List<PropertyDescription> include(String name, SourceLocation location, boolean old) {
        Path found = resolve(name, location);
        return found == null ? List.of() : readFile(found, location, false, old);
    }

    /** Adds a folder to search files in. */
    void addFolder(String name, SourceLocation location) {
        try {
            Path folder = location.file().resolveSibling(name);
            if (Files.isDirectory(folder)) {
                Path real = folder.toAbsolutePath().normalize();
                folders.removeIf(known -> known.toAbsolutePath().normalize().equals(real));
                folders.add(0, folder);
            } else {
                problems.error(location, "the folder '" + name + "' does not exist");
            }
        } catch (InvalidPathException e) {
            problems.error(location, "'" + name + "' is no folder name: " + e.getReason());
        }
    }

    /** A file beside the one that names it, else in the folders of the scene; it may not exist. Null after an error. */
    @Nullable
    Path resolve(String name, SourceLocation location) {
        try {
            Path sibling = location.file().resolveSibling(name);
            for (Path folder : folders) {
                Path candidate = folder.resolve(name);
                if (!Files.exists(sibling) && Files.exists(candidate)) {
                    return candidate;
                }
            }
            return sibling;
        } catch (InvalidPathException e) {
            broken = true;
            problems.error(location, "'" + name + "' is no file name: " + e.getReason());
            return null;
        }
    }

    /** Remembers an object by its name. */
    void addId(String id, ObjectDescription object, SourceLocation location) {
        ObjectDescription other = ids.putIfAbsent(id, object);
        if (other != null) {
            problems.error(location, "the id '" + id + "' is already taken at " + other.location());
        }
    }

    /** Gives an object a second name. */
    void addAlias(String id, String alias, SourceLocation location) {
        ObjectDescription object = ids.get(id);
        if (object == null) {
            problems.unknownName(location, "no object above has the id '" + id + "'", id, ids.keySet());
        } else {
            addId(alias, object, location);
        }
    }

    /** Notes that something is missing from the description, so that it must not be checked further. */
    void setBroken() {
        broken = true;
    }

    Definitions definitions() {
        return definitions;
    }

    ProblemList problems() {
        return problems;
    }

    /** The kind of object that an element stands for, or null. */
    static @Nullable ObjectKind kind(String element) {
        return KINDS.get(element);
    }
}
