package org.daybreak.benchmarks.exr;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.daybreak.exr.ExrWriteOptions;
import org.daybreak.exr.ExrWriter;

/**
 * Reads and writes OpenEXR files on demand, so that a script can take turns with another program. Each line of standard
 * input is {@code read THREADS FILE} or {@code write THREADS FILE}, which writes the image that was read last; the answer
 * is the time in seconds.
 */
public final class ExrSpeed {
    private ExrSpeed() {}

    /**
     * Runs until the input ends.
     *
     * @param arguments none
     * @throws IOException if a file cannot be read or written
     */
    public static void main(String[] arguments) throws IOException {
        BufferedReader commands = new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
        ExrImage image = null;
        for (String line = commands.readLine(); line != null; line = commands.readLine()) {
            String[] words = line.split(" ", 3);
            int threads = Integer.parseInt(words[1]);
            Path file = Path.of(words[2]);
            long start = System.nanoTime();
            if (words[0].equals("read")) {
                image = ExrReader.read(file, threads);
            } else if (image != null) {
                ExrWriter.write(file, image, ExrWriteOptions.defaults().withThreads(threads));
            }
            System.out.println((System.nanoTime() - start) / 1e9);
        }
    }
}
