package org.daybreak.cli;

import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import org.daybreak.exr.ExrChannel;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.daybreak.exr.ExrWriter;
import org.daybreak.exr.ImageFileException;
import org.daybreak.exr.PixelType;
import org.daybreak.scenes.image.ImageLoader;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code daybreak convert}: an image in another format, or a scene in the native one. */
@Command(
        name = "convert",
        description = {
            "Converts an image: from exr, pfm, hdr, png, jpg, bmp or gif to exr, pfm, hdr, png or jpg.",
            "Values are linear in exr, pfm and hdr; the others are 8-bit sRGB, clamped.",
            "Converts a scene or model (xml, gltf, glb, obj, ply, stl) to a scene (xml) with meshes and textures in a"
                    + " folder NAME_files beside it."
        },
        footer = {
            "",
            "Examples:",
            "  daybreak convert picture.exr picture.jpg",
            "  daybreak convert --exposure 1.5 picture.exr brighter.png",
            "  daybreak convert --layer albedo picture.exr albedo.pfm",
            "  daybreak convert model.glb -o scene.xml"
        })
final class ConvertCommand implements Callable<Integer> {
    private static final String SCENE = "xml";

    private final Session session;

    @Parameters(index = "0", paramLabel = "INPUT", description = "The image, scene or model.")
    private Path input = Path.of("");

    @Parameters(index = "1", arity = "0..1", paramLabel = "FILE", description = "File to write; the ending decides.")
    private @Nullable Path file;

    @Option(
            names = {"-o", "--output"},
            paramLabel = "FILE",
            description = "File to write, in place of the second argument.")
    private @Nullable Path option;

    @Option(names = "--exposure", paramLabel = "STOPS", description = "Multiplies the colour by 2^STOPS; default: 0.")
    private double exposure;

    @Option(names = "--layer", paramLabel = "LAYER", description = "Takes this layer of an exr file as the colour.")
    private String layer = "";

    @Option(names = "-D", paramLabel = "NAME=VALUE", description = "Value for $NAME in the scene; may be repeated.")
    private Map<String, String> defines = new LinkedHashMap<>();

    /** The file to write. */
    private Path output = Path.of("");

    ConvertCommand(Session session) {
        this.session = session;
    }

    @Override
    public Integer call() {
        Path given = file == null ? option : file;
        if (given == null || (file != null && option != null)) {
            throw new CommandException(ExitCode.USAGE, "give the file to write once: convert INPUT FILE");
        }
        output = given;
        if (Scenes.isScene(input)) {
            convertScene();
        } else {
            convertImage();
        }
        return ExitCode.OK.number();
    }

    private void convertScene() {
        if (!ImageLoader.ending(output).equals(SCENE)) {
            throw new CommandException(
                    ExitCode.USAGE,
                    input + " is a scene or model, which converts to xml only, not to '" + output + "'");
        }
        if (exposure != 0 || !layer.isEmpty()) {
            throw new CommandException(ExitCode.USAGE, "--exposure and --layer are for images, not for scenes");
        }
        OutputFile.checkWritable(List.of(output));
        Scenes.convert(input, defines, output, session);
    }

    private void convertImage() {
        if (ImageLoader.ending(output).equals(SCENE)) {
            throw new CommandException(ExitCode.USAGE, input + " is no scene or model, so it does not convert to xml");
        }
        if (!defines.isEmpty()) {
            throw new CommandException(ExitCode.USAGE, "-D is for scenes, not for images");
        }
        OutputFile target = OutputFile.of(output);
        if (target.format() == OutputFile.Format.DAYBREAK) {
            throw new CommandException(ExitCode.USAGE, "images cannot be converted to the format daybreak");
        }
        if (!(Math.abs(exposure) <= 100)) {
            throw new CommandException(ExitCode.USAGE, "--exposure is " + exposure + " but must be from -100 to 100");
        }
        OutputFile.checkWritable(List.of(output));
        try {
            if (target.format() == OutputFile.Format.EXR
                    && layer.isEmpty()
                    && ImageLoader.ending(input).equals("exr")) {
                rewrite();
            } else {
                convert(target);
            }
        } catch (ImageFileException e) {
            throw new CommandException(ExitCode.OUTPUT, String.valueOf(e.getMessage()), e);
        }
    }

    /** From OpenEXR to OpenEXR: all layers, attributes, windows and number types stay. */
    private void rewrite() throws ImageFileException {
        ExrImage image;
        try {
            image = ExrReader.read(input);
        } catch (ImageFileException e) {
            throw new CommandException(ExitCode.INPUT, String.valueOf(e.getMessage()), e);
        }
        ExrImage.Builder builder = ExrImage.builder(image.width(), image.height())
                .dataWindowOrigin(
                        image.header().dataWindow().xMin(),
                        image.header().dataWindow().yMin())
                .displayWindow(image.header().displayWindow())
                .pixelAspectRatio(image.header().pixelAspectRatio())
                .screenWindow(
                        image.header().screenWindowCenter(), image.header().screenWindowWidth())
                .attributes(image.header().attributes());
        for (ExrChannel channel : image.header().channels()) {
            if (channel.type() == PixelType.UINT) {
                builder.uintChannel(channel.name(), image.uintSamples(channel.name()));
            } else {
                float[] samples = image.samples(channel.name());
                builder.channel(channel.name(), channel.type(), isColor(channel.name()) ? scaled(samples) : samples);
            }
        }
        ExrWriter.write(output, builder.build());
    }

    private static boolean isColor(String channel) {
        return List.of("R", "G", "B", "Y").contains(channel);
    }

    private void convert(OutputFile target) throws ImageFileException {
        ImageData image = ImageData.read(input);
        Map<String, float[]> color = color(image);
        if (target.format() == OutputFile.Format.EXR) {
            float[] alpha = image.channels().get(layer.isEmpty() ? "A" : layer + ".A");
            ExrImage.Builder builder = ExrImage.builder(image.width(), image.height());
            color.forEach((name, samples) -> builder.channel(name, PixelType.FLOAT, samples));
            if (alpha != null) {
                builder.channel("A", PixelType.FLOAT, alpha);
            }
            ExrWriter.write(output, builder.build());
        } else {
            target.writeColor(image.width(), image.height(), List.copyOf(color.values()));
        }
    }

    /** Red, green and blue, or grey, of the layer, exposed. */
    private Map<String, float[]> color(ImageData image) {
        String prefix = layer.isEmpty() ? "" : layer + ".";
        for (List<String> names : List.of(List.of("R", "G", "B"), List.of("Y"), List.of("X", "Y", "Z"), List.of("Z"))) {
            Map<String, float[]> found = new LinkedHashMap<>();
            for (String name : names) {
                float[] samples = image.channels().get(prefix + name);
                if (samples != null) {
                    found.put(
                            names.size() == 1 ? "Y" : "RGB".substring(found.size(), found.size() + 1), scaled(samples));
                }
            }
            if (found.size() == names.size()) {
                return found;
            }
        }
        throw new CommandException(
                layer.isEmpty() ? ExitCode.INPUT : ExitCode.USAGE,
                input + ": has no colour" + (layer.isEmpty() ? "" : " in the layer '" + layer + "'") + ", only "
                        + String.join(", ", image.channels().keySet()));
    }

    private float[] scaled(float[] samples) {
        if (exposure == 0) {
            return samples;
        }
        double factor = Math.pow(2, exposure);
        float[] values = new float[samples.length];
        for (int i = 0; i < values.length; i++) {
            values[i] = (float) (samples[i] * factor);
        }
        return values;
    }
}
