package org.daybreak.exr;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.function.Executable;
import org.junit.jupiter.api.io.TempDir;

class AtomicFilesTest {
    private static final byte[] OLD = {1, 2, 3};
    private static final byte[] NEW = {4, 5};

    @TempDir
    Path directory;

    private List<String> names() throws IOException {
        try (Stream<Path> files = Files.list(directory)) {
            return files.map(file -> String.valueOf(file.getFileName()))
                    .sorted()
                    .toList();
        }
    }

    private static String reason(Executable action) {
        return assertThrows(ImageFileException.class, action).reason();
    }

    @Test
    void filesAreCreatedAndReplaced() throws IOException {
        Path file = directory.resolve("a.bin");
        AtomicFiles.write(file, OLD);
        assertArrayEquals(OLD, Files.readAllBytes(file));
        AtomicFiles.write(file, NEW);
        assertArrayEquals(NEW, Files.readAllBytes(file));
        assertEquals(List.of("a.bin"), names());
    }

    @Test
    void aRelativeNameWithoutDirectoryWorks() throws IOException {
        Path file = Path.of("atomic-files-test.tmp");
        try {
            AtomicFiles.write(file, NEW);
            assertArrayEquals(NEW, Files.readAllBytes(file));
        } finally {
            Files.deleteIfExists(file);
        }
    }

    @Test
    void aSymbolicLinkIsFollowed() throws IOException {
        Path file = Files.write(directory.resolve("real.bin"), OLD);
        Path link = Files.createSymbolicLink(directory.resolve("link.bin"), file);
        AtomicFiles.write(link, NEW);
        assertTrue(Files.isSymbolicLink(link));
        assertArrayEquals(NEW, Files.readAllBytes(file));
    }

    @Test
    void aFullDiskLeavesTheOldFileAndNothingElse() throws IOException {
        Path file = Files.write(directory.resolve("a.exr"), OLD);
        // What the operating system says when a write meets a full disk.
        ImageFileException e = assertThrows(
                ImageFileException.class,
                () -> AtomicFiles.write(file, target -> {
                    target.write(NEW);
                    throw new IOException("No space left on device");
                }));
        assertEquals(file + ": cannot be written: No space left on device", e.getMessage());
        assertArrayEquals(OLD, Files.readAllBytes(file));
        assertEquals(List.of("a.exr"), names());
    }

    @Test
    void anUnexpectedExceptionLeavesNothing() throws IOException {
        assertThrows(
                IllegalStateException.class,
                () -> AtomicFiles.write(directory.resolve("a.exr"), target -> {
                    throw new IllegalStateException();
                }));
        assertEquals(List.of(), names());
    }

    @Test
    void targetsThatCannotBeWritten() throws IOException {
        ExrImage image = TestPatterns.rgb("smooth", PixelType.HALF, 2, 2).build();
        assertEquals("cannot be written: is a directory", reason(() -> ExrWriter.write(directory, image)));
        Path missing = directory.resolve("missing");
        assertEquals(
                "cannot be written: there is no directory " + missing,
                reason(() -> ExrWriter.write(missing.resolve("a.exr"), image)));
        Path device = Path.of("/dev/null");
        if (Files.exists(device)) {
            assertEquals(
                    "cannot be written: is not a regular file",
                    reason(() -> PngWriter.write(device, 1, 1, new float[3])));
        }
        assertEquals(
                "cannot be written: is a directory",
                reason(() -> Pfm.write(directory, new PfmImage(1, 1, 1, new float[1]))));
        assertEquals(List.of(), names());
    }

    @Test
    void aDirectoryWithoutPermission() throws IOException {
        Path closed = Files.createDirectory(directory.resolve("closed"));
        try {
            assumeTrue(
                    closed.toFile().setWritable(false) && !Files.isWritable(closed),
                    "skipped: this user writes to every directory");
            assertEquals(
                    "cannot be written: permission is denied",
                    reason(() -> AtomicFiles.write(closed.resolve("a.exr"), NEW)));
        } finally {
            assertTrue(closed.toFile().setWritable(true));
        }
    }
}
