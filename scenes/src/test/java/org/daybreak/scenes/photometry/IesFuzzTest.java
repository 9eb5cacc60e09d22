package org.daybreak.scenes.photometry;

import static java.nio.charset.StandardCharsets.ISO_8859_1;

import com.code_intelligence.jazzer.junit.DictionaryFile;
import com.code_intelligence.jazzer.junit.FuzzTest;
import java.io.IOException;
import org.daybreak.scenes.WhereJazzerAttaches;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.ExtendWith;

/**
 * Feeds arbitrary text to the reader of photometric files: it must be read or refused by an {@link IOException} with its
 * line, in bounded time and memory. In an ordinary build the inputs beside this class are run; docs/fuzzing.md tells how to
 * search for new ones.
 */
@Timeout(value = 10, threadMode = Timeout.ThreadMode.SEPARATE_THREAD)
@ExtendWith(WhereJazzerAttaches.class)
class IesFuzzTest {
    @DictionaryFile(resourcePath = "/org/daybreak/scenes/photometry/ies.dict")
    @FuzzTest(maxDuration = "")
    void ies(byte[] input) {
        try {
            IesReader.parse(new String(input, ISO_8859_1));
        } catch (IOException e) {
            if (!e.getMessage().startsWith("line ")) {
                throw new AssertionError("refused without the line", e);
            }
        }
    }
}
