package org.daybreak.scenes;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.description.SceneProblem;
import org.daybreak.scenes.image.ImageLoader;
import org.daybreak.scenes.write.PanoramaEncoder;
import org.daybreak.scenes.write.SceneWriter;

/**
 * Converts scenes and models of all formats that {@link SceneReader} reads to the native format. Thread-safe if the image
 * loader and the encoder are.
 */
public final class SceneConverter {
    private final SceneReader reader;
    private final PanoramaEncoder panoramas;

    /**
     * Creates a converter.
     *
     * @param images as for {@link SceneReader}: scenes are read to their last image, so that what is written is sound
     * @param panoramas encodes the light that models get which have none
     */
    public SceneConverter(ImageLoader images, PanoramaEncoder panoramas) {
        this.reader = new SceneReader(images);
        this.panoramas = panoramas;
    }

    /**
     * Reads a scene and writes it as {@link SceneWriter} says: all of it or nothing.
     *
     * @param input the scene or model
     * @param defines as for {@link SceneReader#load}
     * @param output the scene file to write, whose folder exists; other files get into a folder beside it
     * @return warnings about the input
     * @throws SceneException with every error in the input
     * @throws IOException if a file cannot be written
     */
    public List<SceneProblem> convert(Path input, Map<String, String> defines, Path output)
            throws SceneException, IOException {
        ProblemList problems = new ProblemList();
        SceneReader.Described scene = reader.read(input, defines, problems);
        SceneWriter.write(scene.description(), scene.result(), scene.additions(), panoramas, output);
        return problems.warnings();
    }
}
