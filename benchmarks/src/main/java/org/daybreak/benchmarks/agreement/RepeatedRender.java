package org.daybreak.benchmarks.agreement;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import org.daybreak.cli.Main;

/**
 * Runs commands of the program {@code daybreak} on demand in one virtual machine, which saves the start of one for each of
 * many short renders. Each line of standard input holds the arguments of a command, separated by tabulators; the answer is the
 * exit code.
 */
public final class RepeatedRender {
    private RepeatedRender() {}

    /**
     * Runs until the input ends.
     *
     * @param arguments none
     * @throws IOException if the input cannot be read
     */
    public static void main(String[] arguments) throws IOException {
        BufferedReader commands = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        for (String line = commands.readLine(); line != null; line = commands.readLine()) {
            System.out.println(Main.run(line.split("\t"), System.err, System.err));
        }
    }
}
