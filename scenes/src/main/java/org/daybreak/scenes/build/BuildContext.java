package org.daybreak.scenes.build;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SceneDescription;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.daybreak.scenes.image.ImageLoader;
import org.daybreak.scenes.model.ModelReader;
import org.jspecify.annotations.Nullable;

/** What all builders of one scene share: the description, the problems, images, and which objects are being built. */
final class BuildContext {
    /** References could chain objects deeper than any stack. */
    private static final int NESTING = 64;

    /** Materials and textures have some ten parts each; one that is used twice by what is used twice soon has billions. */
    private static final int MOST_PARTS = 1 << 12;

    private final SceneDescription description;
    private final ImageLoader images;
    private final ProblemList problems;
    private final IdentityHashMap<ObjectDescription, Properties> checked = new IdentityHashMap<>();
    private final List<ObjectDescription> building = new ArrayList<>();
    private final IdentityHashMap<ObjectDescription, Integer> parts = new IdentityHashMap<>();
    /** Parts so far of what is being built by {@link #shared}. */
    private int partsSoFar;

    private final Set<Path> files = new LinkedHashSet<>();

    BuildContext(SceneDescription description, ImageLoader images, ProblemList problems) {
        this.description = description;
        this.images = images;
        this.problems = problems;
        files.addAll(description.files());
    }

    /** All files that the scene was read from so far, the main file first. */
    List<Path> files() {
        return List.copyOf(files);
    }

    ImageLoader images() {
        return images;
    }

    void error(SourceLocation location, String message) {
        problems.error(location, message);
    }

    void warning(SourceLocation location, String message) {
        problems.warning(location, message);
    }

    ProblemList problems() {
        return problems;
    }

    /** The object a value stands for, or null if it is none or, which is reported, a name nothing has. */
    @Nullable
    ObjectDescription object(PropertyDescription property) {
        if (property.value() instanceof Value.Nested nested) {
            return nested.object();
        }
        if (property.value() instanceof Value.Reference reference) {
            ObjectDescription object = description.ids().get(reference.id());
            if (object == null) {
                problems.unknownName(
                        property.location(),
                        "no object has the id '" + reference.id() + "'",
                        reference.id(),
                        description.ids().keySet());
            }
            return object;
        }
        return null;
    }

    /** An object's properties, checked against the table; null if its type is unknown. Errors are reported once. */
    @Nullable
    Properties properties(ObjectDescription object) {
        if (checked.containsKey(object)) {
            return checked.get(object);
        }
        PluginDefinition plugin = Plugins.find(object.kind(), object.type());
        Properties properties = null;
        if (plugin == null) {
            Map<String, PluginDefinition> known = new TreeMap<>(Plugins.ofKind(object.kind()));
            problems.unknownName(
                    object.location(),
                    object.kind().element() + " type '" + object.type() + "' is not supported",
                    object.type(),
                    known.keySet());
        } else {
            properties = new Properties(object, plugin, this);
        }
        checked.put(object, properties);
        return properties;
    }

    /**
     * Builds an object that may contain others by reference.
     *
     * @return what the builder returns, or null if the object contains itself or nests too deep, which is reported
     */
    <T> @Nullable T build(ObjectDescription object, SourceLocation usedAt, Supplier<@Nullable T> builder) {
        if (building.contains(object)) {
            error(usedAt, "the object with the id '" + object.id() + "' contains itself");
            return null;
        }
        if (building.size() == NESTING) {
            error(usedAt, "objects are nested more than " + NESTING + " levels deep");
            return null;
        }
        building.add(object);
        try {
            return builder.get();
        } finally {
            building.remove(building.size() - 1);
        }
    }

    /**
     * Builds an object that others may share, once. What is asked of it later goes to each part as often as there are ways to
     * it, so their number is bounded.
     *
     * @param built what has been built, to which this is added
     * @param placeholder stands for the object after an error that has been reported
     * @param builder returns null after such an error
     */
    <T> T shared(
            IdentityHashMap<ObjectDescription, T> built,
            ObjectDescription object,
            SourceLocation usedAt,
            T placeholder,
            Supplier<@Nullable T> builder) {
        T known = built.get(object);
        if (known == null) {
            int outer = partsSoFar;
            partsSoFar = 1;
            T made = build(object, usedAt, builder);
            if (made != null && partsSoFar > MOST_PARTS) {
                error(
                        usedAt,
                        object.label() + " has more than " + MOST_PARTS
                                + " parts, each counted as often as it is used");
                made = null;
            }
            known = made == null ? placeholder : made;
            built.put(object, known);
            parts.put(object, made == null ? 1 : partsSoFar);
            partsSoFar = outer;
        }
        partsSoFar += parts.getOrDefault(object, 1);
        return known;
    }

    /**
     * Finds a file: beside the scene file that names it, else beside the main scene file, else in the folders the scene
     * lists.
     *
     * @return the file, or null if it is not there or cannot be read, which is reported
     */
    @Nullable
    Path file(String given, SourceLocation location) {
        Path found;
        try {
            found = description.resolve(given, location.file());
        } catch (InvalidPathException e) {
            error(location, "'" + given + "' is no file name: " + e.getReason());
            return null;
        }
        String problem = null;
        if (!Files.exists(found)) {
            problem = "the file " + found + " does not exist";
        } else if (Files.isDirectory(found)) {
            problem = found + " is a directory, not a file";
        } else if (!Files.isReadable(found)) {
            problem = "the file " + found + " cannot be read: permission denied";
        } else if (isEmpty(found)) {
            problem = "the file " + found + " is empty";
        }
        if (problem != null) {
            error(location, problem);
            return null;
        }
        files.add(found);
        return found;
    }

    /** What cannot be told is left to the reader of the file to report. */
    private static boolean isEmpty(Path file) {
        try {
            return Files.size(file) == 0;
        } catch (IOException e) {
            return false;
        }
    }

    /** The scene's main object. */
    ObjectDescription root() {
        return description.root();
    }

    /** Whether the description is that of a model, which gets camera and light elsewhere. */
    boolean isModel() {
        return description.root().type().equals(ModelReader.MODEL);
    }

    static String article(ObjectKind kind) {
        return (kind == ObjectKind.INTEGRATOR || kind == ObjectKind.EMITTER ? "an <" : "a <") + kind.element() + ">";
    }
}
