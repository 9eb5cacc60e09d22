package org.daybreak.exr;

import com.code_intelligence.jazzer.junit.DictionaryFile;
import com.code_intelligence.jazzer.junit.FuzzTest;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Feeds arbitrary bytes to the readers: each file must be read or refused by {@link ImageFileException}, in bounded time and
 * memory. In an ordinary build the inputs beside this class are run; docs/fuzzing.md tells how to search for new ones.
 */
@Timeout(value = 10, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@ExtendWith(WhereJazzerAttaches.class)
class ReaderFuzzTest {
    private static final String NAME = "fuzzed";

    private interface Reading {
        void read() throws ImageFileException;
    }

    /** A file, or what stands in for one that the reader would refuse at its first comparison: an {@link ExrRecipe}. */
    @DictionaryFile(resourcePath = "/org/daybreak/exr/exr.dict")
    @FuzzTest(maxDuration = "")
    void exr(byte[] input) {
        boolean complete = input.length >= Integer.BYTES
                && ByteBuffer.wrap(input).order(ByteOrder.LITTLE_ENDIAN).getInt() == HeaderParser.MAGIC;
        byte[] file = complete ? input : ExrRecipe.file(input);
        isReadOrRefused(() -> ExrReader.readParts(NAME, file, 1));
    }

    @DictionaryFile(resourcePath = "/org/daybreak/exr/hdr.dict")
    @FuzzTest(maxDuration = "")
    void radianceHdr(byte[] input) {
        isReadOrRefused(() -> RadianceHdr.read(NAME, input));
    }

    @DictionaryFile(resourcePath = "/org/daybreak/exr/pfm.dict")
    @FuzzTest(maxDuration = "")
    void pfm(byte[] input) {
        isReadOrRefused(() -> Pfm.read(NAME, input));
    }

    private static void isReadOrRefused(Reading reading) {
        try {
            reading.read();
        } catch (ImageFileException e) {
            // Readers tell when memory runs out; a file as small as these must not bring that about.
            if (!e.getMessage().startsWith(NAME + ": ")
                    || e.reason().startsWith("the image is too large for the Java heap, which")) {
                throw new AssertionError("not a proper refusal", e);
            }
            for (Throwable cause = e.getCause(); cause != null; cause = cause.getCause()) {
                if (cause instanceof Error) {
                    throw new AssertionError("not a proper refusal", e);
                }
            }
        }
    }
}
