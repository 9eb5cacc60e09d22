package org.daybreak.scenes;

import static java.nio.charset.StandardCharsets.UTF_8;

import java.io.IOException;
import java.net.URI;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;

/**
 * A folder of files in memory, for tests that write too many to burden a disk: the root of a zip file system, which keeps
 * what is written until it is closed. No name leads out of it.
 */
public final class MemoryFolder implements AutoCloseable {
    /** Zip file systems hold on to every stream that was opened, so a new one takes over now and then. */
    private static final int MOST_WRITES = 1 << 12;

    private final Path archive;
    private final Map<String, byte[]> contents = new HashMap<>();
    private FileSystem files;
    private int writes;

    /**
     * Creates an empty folder.
     *
     * @param scratch where the archive may appear when a file system is closed
     */
    public MemoryFolder(Path scratch) throws IOException {
        archive = scratch.resolve("files.zip");
        files = open();
    }

    private FileSystem open() throws IOException {
        return FileSystems.newFileSystem(
                URI.create("jar:" + archive.toUri()), Map.of("create", "true", "compressionMethod", "STORED"));
    }

    /**
     * Writes a file.
     *
     * @return its path, which is valid until the next call
     */
    public Path write(String name, byte[] bytes) throws IOException {
        contents.put(name, bytes);
        if (++writes % MOST_WRITES == 0) {
            close();
            files = open();
            for (Map.Entry<String, byte[]> file : contents.entrySet()) {
                Files.write(files.getPath("/", file.getKey()), file.getValue());
            }
        }
        return Files.write(files.getPath("/", name), bytes);
    }

    /** Writes a file of text, as {@link #write(String, byte[])}. */
    public Path write(String name, String text) throws IOException {
        return write(name, text.getBytes(UTF_8));
    }

    @Override
    public void close() throws IOException {
        files.close();
        Files.deleteIfExists(archive);
    }
}
