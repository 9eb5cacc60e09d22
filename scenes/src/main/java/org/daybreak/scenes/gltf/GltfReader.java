package org.daybreak.scenes.gltf;

import com.fasterxml.jackson.core.JsonProcessingException;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.SceneDescription;
import org.daybreak.scenes.description.SourceLocation;

/**
 * Reads glTF 2.0 files. Whatever a file holds, it is read or refused with errors that name the file and the JSON pointer of what
 * is wrong; what it can ask for of memory and time is bounded.
 */
public final class GltfReader {
    private GltfReader() {}

    /** Whether a file's ending is that of glTF. */
    public static boolean isGltf(Path file) {
        String name = String.valueOf(file.getFileName()).toLowerCase(Locale.ROOT);
        return name.endsWith(".gltf") || name.endsWith(".glb");
    }

    /**
     * Reads a file.
     *
     * @param file the file; names in it are relative to it
     * @param problems receives all errors and warnings
     * @return what the file says; empty if it cannot be read at all. The root is of type {@code model}, which may lack
     *     cameras and lights.
     */
    public static Optional<SceneDescription> read(Path file, ProblemList problems) {
        SourceLocation whole = SourceLocation.of(file);
        try {
            Container container = Container.read(file);
            Report report = new Report(file, container.text(), problems);
            try {
                checkVersion(container.root());
                Extensions.check(container.root(), report);
                if (problems.hasErrors()) {
                    return Optional.empty();
                }
                SceneWriter writer = new SceneWriter(container, report);
                ObjectDescription root = writer.scene();
                return Optional.of(new SceneDescription(file, root, Map.of(), List.of(), writer.files()));
            } catch (GltfException e) {
                report.error(e);
            }
        } catch (JsonProcessingException e) {
            SourceLocation place = e.getLocation() == null
                    ? whole
                    : new SourceLocation(
                            file, e.getLocation().getLineNr(), e.getLocation().getColumnNr());
            problems.error(place, "the JSON is damaged: " + e.getOriginalMessage());
        } catch (IOException e) {
            problems.error(whole, e.getMessage() == null ? "cannot be read: " + e : e.getMessage());
        } catch (OutOfMemoryError e) {
            problems.error(whole, "the scene does not fit into memory");
        }
        return Optional.empty();
    }

    private static void checkVersion(JsonValue root) throws GltfException {
        JsonValue asset = root.get("asset");
        JsonValue needed = asset.find("minVersion") == null ? asset.get("version") : asset.get("minVersion");
        String version = needed.text();
        if (!version.equals("2.0")) {
            throw needed.error("is " + JsonValue.quotable(version) + " but only glTF 2.0 is supported");
        }
        if (asset.text("version") == null || !asset.get("version").text().startsWith("2.")) {
            throw asset.get("version")
                    .error("is " + JsonValue.quotable(asset.get("version").text()) + " but only glTF 2.x is supported");
        }
    }
}
