package org.daybreak.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.regex.Pattern;

/** Runs the program in a virtual machine of its own, in a folder that also keeps what it says. */
final class ChildJvm {
    /** Far beyond what the slowest machine needs; a hang is an error then. */
    private static final long MOST_SECONDS = 120;

    private static final List<String> LOGS = List.of("stderr.log", "stdout.log");

    /** Exit code and messages. */
    record Result(int code, String err) {}

    private final Process process;
    private final Path folder;

    private ChildJvm(Process process, Path folder) {
        this.process = process;
        this.folder = folder;
    }

    /** The command that runs the program with the class path of this test. */
    static List<String> command(List<String> jvmOptions, List<String> args) {
        List<String> command = new ArrayList<>();
        command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
        command.addAll(jvmOptions);
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), "org.daybreak.cli.Main"));
        command.addAll(args);
        return command;
    }

    static ChildJvm start(Path folder, List<String> command) throws IOException {
        ProcessBuilder builder = new ProcessBuilder(command)
                .directory(folder.toFile())
                .redirectOutput(folder.resolve("stdout.log").toFile())
                .redirectError(folder.resolve("stderr.log").toFile());
        return new ChildJvm(builder.start(), folder);
    }

    /** Waits until a line of the messages matches. */
    void awaitMessage(Pattern line) throws IOException, InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(MOST_SECONDS);
        while (!line.matcher(err()).find()) {
            if (!process.isAlive() || System.nanoTime() > end) {
                process.destroyForcibly();
                throw new IOException("'" + line + "' does not appear in: " + lastLines());
            }
            Thread.sleep(50);
        }
    }

    /** Sends a signal, such as INT. */
    void signal(String name) throws IOException, InterruptedException {
        new ProcessBuilder("kill", "-" + name, Long.toString(process.pid()))
                .inheritIO()
                .start()
                .waitFor();
    }

    Result await() throws IOException, InterruptedException {
        if (!process.waitFor(MOST_SECONDS, TimeUnit.SECONDS)) {
            process.destroyForcibly();
            throw new IOException("the program does not end; it said: " + lastLines());
        }
        return new Result(process.exitValue(), err());
    }

    static List<String> filesWithoutLogs(Path folder) throws IOException {
        return Cli.files(folder).stream().filter(name -> !LOGS.contains(name)).toList();
    }

    private String lastLines() throws IOException {
        String err = err();
        return err.substring(Math.max(0, err.length() - 2000));
    }

    private String err() throws IOException {
        return Files.readString(folder.resolve("stderr.log"));
    }
}
