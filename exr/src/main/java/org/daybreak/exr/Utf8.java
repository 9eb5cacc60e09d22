package org.daybreak.exr;

import java.nio.ByteBuffer;
import java.nio.charset.CharacterCodingException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Comparator;
import org.jspecify.annotations.Nullable;

/** Texts as they stand in a header. */
final class Utf8 {
    /** The order in which channels are stored: by unsigned bytes, as C's {@code strcmp}. */
    static final Comparator<String> BYTE_ORDER = (a, b) -> Arrays.compareUnsigned(encode(a), encode(b));

    private Utf8() {}

    static byte[] encode(String text) {
        return text.getBytes(StandardCharsets.UTF_8);
    }

    /** The text, or null if the bytes are not UTF-8: then they cannot be written back from a string unchanged. */
    static @Nullable String decodeOrNull(byte[] bytes) {
        try {
            return StandardCharsets.UTF_8
                    .newDecoder()
                    .decode(ByteBuffer.wrap(bytes))
                    .toString();
        } catch (CharacterCodingException e) {
            return null;
        }
    }
}
