package org.daybreak.scenes.mitsuba;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.Charset;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.IllegalCharsetNameException;
import java.nio.charset.StandardCharsets;
import java.nio.charset.UnsupportedCharsetException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Reads XML files as text: byte order mark first, then the encoding that the declaration names, else UTF-8. */
final class XmlText {
    /** Descriptions are text written by people and exporters; geometry lies in files of its own. */
    private static final long LARGEST_FILE = 1L << 29;

    private static final int DECLARATION_LENGTH = 200;
    private static final Pattern ENCODING =
            Pattern.compile("^<\\?xml[^>]*?\\sencoding\\s*=\\s*[\"']([A-Za-z0-9._-]+)[\"']");

    private XmlText() {}

    /**
     * Reads a file.
     *
     * @throws IOException with a message fit for users, without the file's name
     */
    static String read(Path file) throws IOException {
        if (Files.isDirectory(file)) {
            throw new IOException("this is a directory, not a scene file");
        }
        if (!Files.exists(file)) {
            throw new IOException("the file does not exist");
        }
        if (!Files.isRegularFile(file)) {
            // A pipe or device may never end.
            throw new IOException("this is no regular file");
        }
        if (!Files.isReadable(file)) {
            throw new IOException("the file cannot be read: permission denied");
        }
        long size = Files.size(file);
        if (size > LARGEST_FILE) {
            throw new IOException("the file has " + size + " bytes but a scene file may have " + LARGEST_FILE);
        }
        byte[] bytes = Files.readAllBytes(file);
        String text = decode(bytes);
        if (text.isBlank()) {
            throw new IOException("the file is empty");
        }
        return text;
    }

    private static String decode(byte[] bytes) throws IOException {
        int b0 = bytes.length > 0 ? bytes[0] & 0xff : -1;
        int b1 = bytes.length > 1 ? bytes[1] & 0xff : -1;
        int b2 = bytes.length > 2 ? bytes[2] & 0xff : -1;
        if (b0 == 0xef && b1 == 0xbb && b2 == 0xbf) {
            return decode(bytes, 3, StandardCharsets.UTF_8);
        }
        if (b0 == 0xfe && b1 == 0xff) {
            return decode(bytes, 2, StandardCharsets.UTF_16BE);
        }
        if (b0 == 0xff && b1 == 0xfe) {
            return decode(bytes, 2, StandardCharsets.UTF_16LE);
        }
        String start = new String(bytes, 0, Math.min(bytes.length, DECLARATION_LENGTH), StandardCharsets.ISO_8859_1);
        Matcher matcher = ENCODING.matcher(start);
        String name = matcher.find() ? matcher.group(1) : "UTF-8";
        try {
            return decode(bytes, 0, Charset.forName(name));
        } catch (IllegalCharsetNameException | UnsupportedCharsetException e) {
            throw new IOException("the encoding '" + name + "' is not known", e);
        }
    }

    private static String decode(byte[] bytes, int offset, Charset charset) throws IOException {
        try {
            return charset.newDecoder()
                    .onMalformedInput(CodingErrorAction.REPORT)
                    .onUnmappableCharacter(CodingErrorAction.REPORT)
                    .decode(ByteBuffer.wrap(bytes, offset, bytes.length - offset))
                    .toString();
        } catch (CharacterCodingException e) {
            throw new IOException("the file is not valid " + charset + " text", e);
        }
    }
}
