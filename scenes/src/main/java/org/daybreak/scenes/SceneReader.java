package org.daybreak.scenes;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import org.daybreak.scenes.build.SceneBuilder;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.SceneDescription;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.gltf.GltfReader;
import org.daybreak.scenes.image.ImageLoader;
import org.daybreak.scenes.image.StandardImageLoader;
import org.daybreak.scenes.mitsuba.MitsubaReader;
import org.daybreak.scenes.model.ModelReader;
import org.daybreak.scenes.view.AutoView;

/**
 * Reads scene files. Thread-safe if the image loader is; every call stands alone.
 *
 * <pre>{@code
 * SceneFile file = new SceneReader().load(Path.of("scene.xml"), Map.of("spp", "256"));
 * }</pre>
 */
public final class SceneReader {
    private final ImageLoader images;

    /** Creates a reader that knows the image formats of the JDK. */
    public SceneReader() {
        this(new StandardImageLoader());
    }

    /** Creates a reader with a loader for the images that scenes refer to. */
    public SceneReader(ImageLoader images) {
        this.images = images;
    }

    /**
     * Reads a scene in the XML format of Mitsuba, a glTF file (gltf, glb) or a mesh (obj, ply, stl). What the latter two lack
     * of camera and light comes from {@link AutoView}.
     *
     * @param file the file; names in it are relative to it
     * @param defines values for {@code $name} in attributes; they go before {@code <default>} values
     * @return the scene, what it asks of the renderer, and warnings
     * @throws SceneException with every error in the file and the files it refers to
     */
    public SceneFile load(Path file, Map<String, String> defines) throws SceneException {
        ProblemList problems = new ProblemList();
        if (ModelReader.isModel(file) || GltfReader.isGltf(file)) {
            return loadModel(file, defines, problems);
        }
        Optional<SceneDescription> description = MitsubaReader.read(file, defines, problems);
        if (description.isEmpty()) {
            problems.throwIfErrors();
            problems.error(SourceLocation.of(file), "the scene cannot be read");
            throw new SceneException(problems.errors());
        }
        SceneBuilder.Result result = SceneBuilder.build(description.get(), images, problems);
        problems.throwIfErrors();
        return new SceneFile(result.graph(), result.request(), problems.warnings(), result.files());
    }

    private SceneFile loadModel(Path file, Map<String, String> defines, ProblemList problems) throws SceneException {
        for (String name : new TreeSet<>(defines.keySet())) {
            problems.error(
                    SourceLocation.of(file), "only XML has attributes that could use the definition '" + name + "'");
        }
        Optional<SceneDescription> description = GltfReader.isGltf(file)
                ? GltfReader.read(file, problems)
                : Optional.of(ModelReader.read(file, images, problems));
        if (description.isEmpty()) {
            throw new SceneException(problems.errors());
        }
        SceneBuilder.Result result = SceneBuilder.build(description.get(), images, problems);
        problems.throwIfErrors();
        try {
            AutoView.complete(result.graph(), ModelReader.zPointsUp(file) ? AutoView.UpAxis.Z : AutoView.UpAxis.Y);
        } catch (IllegalArgumentException e) {
            problems.error(SourceLocation.of(file), String.valueOf(e.getMessage()));
            throw new SceneException(problems.errors());
        }
        return new SceneFile(result.graph(), result.request(), problems.warnings(), result.files());
    }
}
