package org.daybreak.cli;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;

/** Runs the program inside the test and keeps what it says. */
final class Cli {
    /** What a run left: exit code and texts. */
    record Result(int code, String out, String err) {
        /** The messages, without progress. */
        List<String> messages() {
            return err.lines().filter(line -> line.startsWith("daybreak: ")).toList();
        }
    }

    private Cli() {}

    static Result run(Object... args) {
        ByteArrayOutputStream out = new ByteArrayOutputStream();
        ByteArrayOutputStream err = new ByteArrayOutputStream();
        Charset charset = Charset.defaultCharset();
        List<String> texts = new ArrayList<>();
        for (Object arg : args) {
            texts.add(arg.toString());
        }
        int code = Main.run(
                texts.toArray(new String[0]), new PrintStream(out, true, charset), new PrintStream(err, true, charset));
        return new Result(code, out.toString(charset), err.toString(charset));
    }

    /** Names of the files in a folder, sorted. */
    static List<String> files(Path folder) throws IOException {
        try (Stream<Path> list = Files.list(folder)) {
            return list.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }
}
