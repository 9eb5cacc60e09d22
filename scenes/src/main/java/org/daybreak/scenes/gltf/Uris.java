package org.daybreak.scenes.gltf;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.Base64;
import java.util.Locale;
import java.util.regex.Pattern;

/** URIs of buffers and images: data in the document, or names of files relative to it. */
final class Uris {
    private static final Pattern SCHEME = Pattern.compile("[A-Za-z][A-Za-z0-9+.-]*:.*", Pattern.DOTALL);

    private Uris() {}

    /**
     * Data that a URI holds.
     *
     * @param mediaType type of the content in lower case, may be empty
     * @param bytes the content
     */
    record Data(String mediaType, byte[] bytes) {}

    /** True if a URI holds the data itself. */
    static boolean isData(String uri) {
        return uri.regionMatches(true, 0, "data:", 0, 5);
    }

    /** Decodes a data URI (RFC 2397), which must be in base64. */
    static Data data(JsonValue uri) throws GltfException {
        String text = uri.text();
        int comma = text.indexOf(',');
        String header = comma < 0 ? "" : text.substring(5, comma).toLowerCase(Locale.ROOT);
        if (!header.endsWith(";base64")) {
            throw uri.error("must be a data URI in base64 or a relative file name");
        }
        int semicolon = header.indexOf(';');
        try {
            return new Data(header.substring(0, semicolon), Base64.getDecoder().decode(text.substring(comma + 1)));
        } catch (IllegalArgumentException e) {
            throw uri.error("is damaged: " + e.getMessage());
        }
    }

    /** The file name that a relative URI stands for. */
    static String name(JsonValue uri) throws GltfException {
        String text = uri.text();
        if (SCHEME.matcher(text).matches() || text.startsWith("/") || text.startsWith("\\")) {
            throw uri.error("must be a relative file name, not '" + JsonValue.quotable(text) + "'");
        }
        return decoded(uri, text);
    }

    /**
     * The regular file that a relative URI names.
     *
     * @param document the file that the URI stands in
     */
    static Path file(JsonValue uri, Path document) throws GltfException {
        Path file;
        try {
            file = document.resolveSibling(name(uri));
        } catch (InvalidPathException e) {
            throw uri.error("is no file name: '" + JsonValue.quotable(uri.text()) + "'");
        }
        if (!Files.exists(file)) {
            throw uri.error("names the file " + JsonValue.quotable(file.toString()) + ", which does not exist");
        }
        if (!Files.isRegularFile(file)) {
            throw uri.error("names " + JsonValue.quotable(file.toString()) + ", which is no regular file");
        }
        return file;
    }

    private static String decoded(JsonValue uri, String text) throws GltfException {
        if (text.indexOf('%') < 0) {
            return text;
        }
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        byte[] source = text.getBytes(StandardCharsets.UTF_8);
        for (int i = 0; i < source.length; i++) {
            if (source[i] != '%') {
                bytes.write(source[i]);
                continue;
            }
            int high = i + 2 < source.length ? Character.digit(source[i + 1], 16) : -1;
            int low = i + 2 < source.length ? Character.digit(source[i + 2], 16) : -1;
            if (high < 0 || low < 0) {
                throw uri.error("has a '%' without two hexadecimal digits behind it");
            }
            bytes.write(16 * high + low);
            i += 2;
        }
        return bytes.toString(StandardCharsets.UTF_8);
    }
}
