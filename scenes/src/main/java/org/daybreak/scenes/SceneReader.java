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
        SceneBuilder.Result result = read(file, defines, problems).result();
        return new SceneFile(result.graph(), result.request(), problems.warnings(), result.files());
    }

    /**
     * A scene with what it was built from.
     *
     * @param description what its files say
     * @param result what that amounts to, additions included
     * @param additions what the files leave out
     */
    record Described(SceneDescription description, SceneBuilder.Result result, AutoView.Additions additions) {}

    /**
     * Reads and builds a scene as {@link #load} does.
     *
     * @param problems receives the warnings
     * @throws SceneException as {@link #load} does
     */
    Described read(Path file, Map<String, String> defines, ProblemList problems) throws SceneException {
        boolean model = ModelReader.isModel(file) || GltfReader.isGltf(file);
        Optional<SceneDescription> found =
                model ? describeModel(file, defines, problems) : MitsubaReader.read(file, defines, problems);
        if (found.isEmpty()) {
            problems.throwIfErrors();
            problems.error(SourceLocation.of(file), "the scene cannot be read");
            throw new SceneException(problems.errors());
        }
        SceneDescription description = found.get();
        SceneBuilder.Result result = SceneBuilder.build(description, images, problems);
        problems.throwIfErrors();
        if (!model) {
            return new Described(description, result, AutoView.Additions.NONE);
        }
        try {
            AutoView.UpAxis up = ModelReader.zPointsUp(file) ? AutoView.UpAxis.Z : AutoView.UpAxis.Y;
            return new Described(description, result, AutoView.complete(result.graph(), up));
        } catch (IllegalArgumentException e) {
            problems.error(SourceLocation.of(file), String.valueOf(e.getMessage()));
            throw new SceneException(problems.errors());
        }
    }

    private Optional<SceneDescription> describeModel(Path file, Map<String, String> defines, ProblemList problems) {
        for (String name : new TreeSet<>(defines.keySet())) {
            problems.error(
                    SourceLocation.of(file), "only XML has attributes that could use the definition '" + name + "'");
        }
        return GltfReader.isGltf(file)
                ? GltfReader.read(file, problems)
                : Optional.of(ModelReader.read(file, images, problems));
    }
}
