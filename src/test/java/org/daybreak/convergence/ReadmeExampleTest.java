package org.daybreak.convergence;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * Compiles and runs the Java lines of the README and compiles those of the user guide, as they stand there: the block after a
 * mark such as {@code <!-- example: SmallScene -->}, as the body of {@code main} under imports of whole packages.
 */
class ReadmeExampleTest {
    private static final List<String> IMPORTS = List.of(
            "java.nio.file.*",
            "java.util.*",
            "javax.vecmath.*",
            "org.daybreak.antialiasing.*",
            "org.daybreak.core.camera.*",
            "org.daybreak.core.film.*",
            "org.daybreak.core.geometry.*",
            "org.daybreak.core.light.*",
            "org.daybreak.core.material.*",
            "org.daybreak.core.math.*",
            "org.daybreak.core.render.*",
            "org.daybreak.core.scene.*",
            "org.daybreak.exr.*",
            "org.daybreak.scenes.*");

    @Test
    void exampleRendersAPicture(@TempDir Path folder) throws IOException, InterruptedException {
        compile(folder, block("README.md", "SmallScene"));
        String output = run(folder);

        assertTrue(Pattern.compile("\\b100\\b").matcher(output).find(), () -> "no progress up to 100 %: " + output);
        List<Path> images;
        try (var files = Files.list(folder)) {
            images = files.filter(file -> file.toString().endsWith(".exr")).toList();
        }
        assertEquals(1, images.size(), () -> "files written: " + images);
        checkImage(ExrReader.read(images.get(0)));
    }

    @Test
    void exampleOfTheGuideCompiles(@TempDir Path folder) throws IOException {
        compile(folder, block("docs/guide.md", "RenderFile"));
    }

    private static String block(String file, String mark) throws IOException {
        String page = Files.readString(ShippedScenes.repository().resolve(file), StandardCharsets.UTF_8);
        Matcher block = Pattern.compile("<!-- example: " + mark + " -->\\s*```java\\R(.*?)\\R```", Pattern.DOTALL)
                .matcher(page);
        assertTrue(block.find(), () -> file + " has no Java block after <!-- example: " + mark + " -->");
        return block.group(1);
    }

    private static void compile(Path folder, String body) throws IOException {
        StringBuilder source = new StringBuilder();
        IMPORTS.forEach(name -> source.append("import ").append(name).append(";\n"));
        source.append("public class SmallScene {\n    public static void main(String[] args) throws Exception {\n");
        source.append(body).append("\n    }\n}\n");
        Path file = Files.writeString(folder.resolve("SmallScene.java"), source, StandardCharsets.UTF_8);
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        StringWriter messages = new StringWriter();
        List<String> options =
                List.of("-proc:none", "-cp", System.getProperty("java.class.path"), "-d", folder.toString());
        try (var files = compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8)) {
            boolean compiled = compiler.getTask(messages, files, null, options, null, files.getJavaFileObjects(file))
                    .call();
            assertTrue(compiled, () -> "the lines do not compile:\n" + messages + source);
        }
    }

    /** Runs the class in a virtual machine of its own, whose working directory is the folder. Returns what it prints. */
    private static String run(Path folder) throws IOException, InterruptedException {
        Path output = folder.resolve("output.txt");
        String separator = System.getProperty("path.separator");
        Process process = new ProcessBuilder(
                        Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                        "-cp",
                        folder + separator + System.getProperty("java.class.path"),
                        "SmallScene")
                .directory(folder.toFile())
                .redirectErrorStream(true)
                .redirectOutput(output.toFile())
                .start();
        try {
            assertTrue(process.waitFor(5, TimeUnit.MINUTES), "the example does not end");
        } finally {
            process.destroyForcibly();
        }
        String printed = Files.readString(output, StandardCharsets.UTF_8);
        assertEquals(0, process.exitValue(), () -> "the example fails:\n" + printed);
        return printed;
    }

    private static void checkImage(ExrImage image) {
        double sum = 0;
        double squares = 0;
        int pixels = image.width() * image.height();
        for (float value : image.samples("G")) {
            assertTrue(Float.isFinite(value) && value >= 0, () -> "a pixel is " + value);
            sum += value;
            squares += (double) value * value;
        }
        double mean = sum / pixels;
        double deviation = Math.sqrt(squares / pixels - mean * mean);
        assertTrue(mean > 0.01, () -> "the picture is black: its mean is " + mean);
        assertTrue(deviation > 0.1 * mean, () -> "the picture shows nothing: its deviation is " + deviation);
    }
}
