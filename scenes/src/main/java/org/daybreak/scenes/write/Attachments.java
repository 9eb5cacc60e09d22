package org.daybreak.scenes.write;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.AtomicMoveNotSupportedException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.DigestOutputStream;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.LinkedHashSet;
import java.util.Set;
import java.util.concurrent.ThreadLocalRandom;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A scene file and the folder of the files that it refers to. All are written into a hidden folder beside the scene file and
 * moved to their places at the end, the scene file last. The names of the others contain a digest of their content, so that
 * a file that an older scene file of the same name refers to is never replaced by another: at any moment the scene
 * file that is there is complete.
 */
final class Attachments implements AutoCloseable {
    /** Hexadecimal digits of the digest in names: 48 bits. */
    private static final int DIGEST_DIGITS = 12;

    private static final int LONGEST_STEM = 40;

    /** What the name of a file from an earlier conversion ends in. */
    private static final Pattern OLDER_DIGEST = Pattern.compile("-[0-9a-f]{" + DIGEST_DIGITS + "}$");

    private final Path scene;
    private final Path staging;
    private final Path folder;
    private final Set<String> names = new LinkedHashSet<>();

    /** Writes the content of a file. */
    @FunctionalInterface
    interface Content {
        void writeTo(OutputStream out) throws IOException;
    }

    /**
     * Prepares the files of a scene.
     *
     * @param scene the scene file that will be written or replaced
     * @throws IOException if nothing can be written there
     */
    Attachments(Path scene) throws IOException {
        Path place = Files.exists(scene) ? scene.toRealPath() : scene.toAbsolutePath();
        String name = String.valueOf(place.getFileName());
        int dot = name.lastIndexOf('.');
        this.scene = place;
        this.folder = place.resolveSibling((dot > 0 ? name.substring(0, dot) : name) + "_files");
        this.staging = Files.createDirectory(place.resolveSibling(
                ".daybreak-" + Long.toHexString(ThreadLocalRandom.current().nextLong()) + ".tmp"));
    }

    /**
     * Adds a file.
     *
     * @param stem what its name begins with
     * @param ending what its name ends in, without the dot
     * @return its name relative to the scene file, with slashes
     */
    String add(String stem, String ending, Content content) throws IOException {
        MessageDigest digest = sha256();
        Path unnamed = staging.resolve("unnamed");
        write(unnamed, out -> {
            DigestOutputStream digesting = new DigestOutputStream(out, digest);
            content.writeTo(digesting);
        });
        String legal = OLDER_DIGEST.matcher(stem).replaceFirst("").replaceAll("[^A-Za-z0-9_-]", "_");
        String name = legal.substring(0, Math.min(LONGEST_STEM, legal.length())) + "-"
                + HexFormat.of().formatHex(digest.digest()).substring(0, DIGEST_DIGITS) + "." + ending;
        move(unnamed, staging.resolve(name));
        names.add(name);
        return folder.getFileName() + "/" + name;
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new AssertionError("every Java platform has SHA-256", e);
        }
    }

    private static void write(Path file, Content content) throws IOException {
        try (OutputStream out = new BufferedOutputStream(Files.newOutputStream(file), 1 << 16)) {
            content.writeTo(out);
        }
    }

    /**
     * Writes the scene file and puts everything into place.
     *
     * @throws IOException if that fails; then nothing has changed
     */
    void commit(Content sceneText) throws IOException {
        Path text = staging.resolve("scene");
        write(text, sceneText);
        Set<Path> made = new LinkedHashSet<>();
        boolean complete = false;
        try {
            if (Files.exists(folder) && !Files.isDirectory(folder)) {
                throw new IOException(folder + " is no directory");
            }
            if (!names.isEmpty() && !Files.exists(folder)) {
                Files.createDirectory(folder);
                made.add(folder);
            }
            for (String name : names) {
                Path target = folder.resolve(name);
                if (!Files.exists(target)) {
                    made.add(target);
                }
                move(staging.resolve(name), target);
            }
            move(text, scene);
            complete = true;
        } finally {
            if (!complete) {
                made.stream().filter(path -> !path.equals(folder)).forEach(Attachments::deleteQuietly);
                made.stream().filter(folder::equals).forEach(Attachments::deleteQuietly);
            }
        }
    }

    private static void move(Path from, Path to) throws IOException {
        try {
            Files.move(from, to, StandardCopyOption.ATOMIC_MOVE);
        } catch (AtomicMoveNotSupportedException e) {
            Files.move(from, to, StandardCopyOption.REPLACE_EXISTING);
        }
    }

    /** Removes what has not been put into place. */
    @Override
    public void close() throws IOException {
        try (Stream<Path> left = Files.list(staging)) {
            left.forEach(Attachments::deleteQuietly);
        }
        Files.delete(staging);
    }

    private static void deleteQuietly(Path file) {
        try {
            Files.deleteIfExists(file);
        } catch (IOException e) {
            // The error that led here is the one to report, and it is on its way.
            file.toFile().deleteOnExit();
        }
    }
}
