package org.daybreak.cli.partial;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;

/** Keys of the identity of a render, and the digest of a scene. */
public final class RenderIdentity {
    /** Name and version of the program. */
    public static final String SOFTWARE = "software";

    /** Digest of the scene, see {@link #sceneDigest}. */
    public static final String SCENE = "scene";

    /** Identifier of the renderer. */
    public static final String RENDERER = "renderer";

    /** Parameters of the renderer as JSON. */
    public static final String PARAMETERS = "parameters";

    /** Identifier of the antialiasing method. */
    public static final String ANTIALIASING = "antialiasing";

    /** Parameters of the antialiasing method as JSON. */
    public static final String ANTIALIASING_PARAMETERS = "antialiasing parameters";

    /** Seed. */
    public static final String SEED = "seed";

    /** Samples per pixel that were asked for. */
    public static final String SAMPLES_PER_PIXEL = "samples per pixel";

    /** Error at which the render ends; 0 for never. */
    public static final String TARGET_ERROR = "target error";

    /** Width and height in pixels. */
    public static final String SIZE = "size";

    /** The part of the image that is rendered. */
    public static final String CROP = "crop";

    /** Reconstruction filter. */
    public static final String FILTER = "filter";

    /** Auxiliary images. */
    public static final String LAYERS = "layers";

    static final int DIGEST_LENGTH = 64;

    private RenderIdentity() {}

    /**
     * SHA-256 of all that a scene depends on: the bytes of its files, in order, and the definitions that were given. The names
     * and places of the files do not enter.
     *
     * @throws UncheckedIOException if a file cannot be read
     */
    public static String sceneDigest(List<Path> files, Map<String, String> defines) {
        MessageDigest digest = sha256();
        for (Map.Entry<String, String> define : new TreeMap<>(defines).entrySet()) {
            digest.update((define.getKey() + "=" + define.getValue() + "\0").getBytes(StandardCharsets.UTF_8));
        }
        byte[] buffer = new byte[1 << 16];
        for (Path file : files) {
            MessageDigest content = sha256();
            try (InputStream in = Files.newInputStream(file)) {
                for (int n = in.read(buffer); n >= 0; n = in.read(buffer)) {
                    content.update(buffer, 0, n);
                }
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
            digest.update(content.digest());
        }
        return HexFormat.of().formatHex(digest.digest());
    }

    private static MessageDigest sha256() {
        try {
            return MessageDigest.getInstance("SHA-256");
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java platform has SHA-256", e);
        }
    }
}
