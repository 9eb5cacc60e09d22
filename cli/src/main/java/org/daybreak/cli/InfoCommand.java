package org.daybreak.cli;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import org.daybreak.cli.partial.PartialFilmFile;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.scenes.SceneFile;
import org.daybreak.scenes.image.ImageLoader;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code daybreak info}: what is in a scene, an image or a partial film. */
@Command(
        name = "info",
        description = {
            "Describes a scene (xml, gltf, glb), a model (obj, ply, stl), an image or a partial film (daybreak)."
        },
        footer = {
            "",
            "Examples:",
            "  daybreak info scene.xml      shapes, triangles, lights, camera, size of the index",
            "  daybreak info picture.exr    size, channels, attributes, smallest and largest values",
            "  daybreak info c.daybreak     what it is a render of, how far it is, checksums of its sums"
        })
final class InfoCommand implements Callable<Integer> {
    private final Session session;

    @Parameters(paramLabel = "FILE", description = "Scene, model, image or partial film.")
    private Path file = Path.of("");

    @Option(names = "-D", paramLabel = "NAME=VALUE", description = "Value for $NAME in the scene; may be repeated.")
    private Map<String, String> defines = new LinkedHashMap<>();

    InfoCommand(Session session) {
        this.session = session;
    }

    @Override
    public Integer call() {
        if (ImageLoader.ending(file).equals(PartialFilmFile.ENDING)) {
            PartialFilmSummary.of(file).forEach(this::line);
        } else if (ImageData.isImage(file)) {
            describe(ImageData.read(file));
        } else {
            SceneFile scene = Scenes.load(file, defines, session);
            Scene compiled = Scenes.compile(file, scene, SceneCompiler.Options.defaults());
            SceneSummary.of(scene, compiled).forEach(this::line);
        }
        return ExitCode.OK.number();
    }

    private void describe(ImageData image) {
        line("format", image.format());
        line("size", image.width() + "x" + image.height());
        image.attributes().forEach(this::line);
        image.channels()
                .forEach((name, samples) -> line(name, describe(image.types().get(name), samples)));
    }

    private static String describe(@org.jspecify.annotations.Nullable String type, float[] samples) {
        double sum = 0;
        double least = Double.POSITIVE_INFINITY;
        double most = Double.NEGATIVE_INFINITY;
        long finite = 0;
        for (float value : samples) {
            if (Float.isFinite(value)) {
                finite++;
                sum += value;
                least = Math.min(least, value);
                most = Math.max(most, value);
            }
        }
        String figures = finite == 0
                ? "no finite value"
                : String.format(Locale.ROOT, "minimum %.6g, mean %.6g, maximum %.6g", least, sum / finite, most);
        long others = samples.length - finite;
        return type + ", " + figures + (others == 0 ? "" : ", " + others + " infinite or not numbers");
    }

    private void line(String name, String value) {
        session.out().printf(Locale.ROOT, "%-16s %s%n", name, value);
    }
}
