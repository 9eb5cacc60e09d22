package org.daybreak.exr;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.channels.FileChannel;
import java.nio.file.AccessDeniedException;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.concurrent.ThreadLocalRandom;

/**
 * Writes whole files or nothing: the bytes go to a temporary file in the directory of the target, which is moved to the
 * target's name when all are written. Whoever reads the target sees the old file or the new one. If anything fails, the
 * temporary file is deleted and the target stays as it was.
 *
 * <p>A thread's interrupt flag does not stop a write, so that an image can be saved after an interrupt.
 */
public final class AtomicFiles {
    private AtomicFiles() {}

    /** Writes the content of a file. */
    @FunctionalInterface
    public interface Content {
        /**
         * Writes all bytes.
         *
         * @param file an empty file, open for reading and writing; closed by the caller
         * @throws IOException if that fails; the message is a reason without a file name
         */
        void writeTo(RandomAccessFile file) throws IOException;
    }

    /**
     * Writes a file from bytes.
     *
     * @param target file to create or replace
     * @param bytes the content
     * @throws ImageFileException if the file cannot be written
     */
    public static void write(Path target, byte[] bytes) throws ImageFileException {
        write(target, file -> file.write(bytes));
    }

    /**
     * Writes a file.
     *
     * @param target file to create or replace; a symbolic link is followed
     * @param content writes the bytes
     * @throws ImageFileException if the target is a directory or device, its directory is missing or not writable, the
     *     disk is full, or the content fails
     */
    public static void write(Path target, Content content) throws ImageFileException {
        write(target, content, false);
    }

    /**
     * Writes a file so that it survives the end of the process or of the machine at any moment: after that the target is the
     * old file or the new one, complete. The temporary file has always the same name, so that ends in the middle do
     * not leave more and more of them behind; at most one write to a target may be under way.
     *
     * @param target file to create or replace; a symbolic link is followed
     * @param content writes the bytes
     * @throws ImageFileException as {@link #write(Path, Content)} does
     */
    public static void writeDurably(Path target, Content content) throws ImageFileException {
        write(target, content, true);
    }

    private static void write(Path target, Content content, boolean durably) throws ImageFileException {
        Path temporary = null;
        try {
            Path place = place(target);
            temporary = durably ? createNamedBeside(place) : createBeside(place);
            try (RandomAccessFile file = new RandomAccessFile(temporary.toFile(), "rw")) {
                content.writeTo(file);
                if (durably) {
                    file.getFD().sync();
                }
            }
            move(temporary, place);
            temporary = null;
            if (durably) {
                syncFolder(place);
            }
        } catch (ImageFileException e) {
            throw e;
        } catch (AccessDeniedException e) {
            throw new ImageFileException(target, "cannot be written: permission is denied", e);
        } catch (IOException e) {
            throw new ImageFileException(target, "cannot be written: " + e.getMessage(), e);
        } catch (UnsupportedOperationException e) {
            throw new ImageFileException(target, "is not in the default file system", e);
        } finally {
            if (temporary != null) {
                deleteQuietly(temporary);
            }
        }
    }

    /** The absolute name that the move will replace. */
    private static Path place(Path target) throws IOException {
        if (Files.isDirectory(target)) {
            throw new ImageFileException(target, "cannot be written: is a directory");
        }
        if (Files.exists(target)) {
            // Moving a file over a device would replace the device.
            if (!Files.isRegularFile(target)) {
                throw new ImageFileException(target, "cannot be written: is not a regular file");
            }
            return target.toRealPath();
        }
        Path place = target.toAbsolutePath();
        Path directory = place.getParent();
        if (directory == null || !Files.isDirectory(directory)) {
            throw new ImageFileException(target, "cannot be written: there is no directory " + directory);
        }
        return place;
    }

    /** Unlike {@link Files#createTempFile} this leaves the permissions to the process's umask. */
    private static Path createBeside(Path place) throws IOException {
        String name =
                ".daybreak-" + Long.toHexString(ThreadLocalRandom.current().nextLong()) + ".tmp";
        return Files.createFile(place.resolveSibling(name));
    }

    private static Path createNamedBeside(Path place) throws IOException {
        Path temporary = place.resolveSibling("." + place.getFileName() + ".tmp");
        Files.deleteIfExists(temporary);
        return Files.createFile(temporary);
    }

    /** Makes the move last. Systems that cannot open folders keep the order of such changes themselves. */
    private static void syncFolder(Path place) {
        Path folder = place.getParent();
        if (folder == null) {
            return;
        }
        try (FileChannel channel = FileChannel.open(folder, StandardOpenOption.READ)) {
            channel.force(true);
        } catch (IOException e) {
            // The file itself is complete under its name; no more can be done here.
            return;
        }
    }

    private static void move(Path from, Path to) throws IOException {
        try {
            Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    private static void deleteQuietly(Path temporary) {
        try {
            Files.deleteIfExists(temporary);
        } catch (IOException e) {
            // The first error is the one to report, and it is on its way.
            temporary.toFile().deleteOnExit();
        }
    }
}
