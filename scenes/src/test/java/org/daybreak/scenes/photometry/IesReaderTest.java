package org.daybreak.scenes.photometry;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.daybreak.core.light.PhotometricProfile;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class IesReaderTest {
    private static final String HEADER = "IESNA:LM-63-2002\r\n[TEST] none\r\n[MANUFAC] nobody\r\n";
    private static final String BODY = "1 1000 2 3 2 1 2 0.1 0.2 0\n0.5 1 30\n0 45 90\n0 90\n100 80, 60\n40 30\n20\n";

    @TempDir
    Path folder;

    @Test
    void readsAngularIntensitiesWithAllFactors() throws IOException {
        Path file = folder.resolve("lamp.ies");
        Files.writeString(file, HEADER + "TILT=NONE\r\n" + BODY);
        PhotometricProfile profile = IesReader.read(file);
        // The multiplier 2 and the ballast factor ½ cancel.
        assertEquals(100, profile.maximum());
        assertEquals(60, profile.candela(1, 0, 0), 1e-9);
        assertEquals(20, profile.candela(0, 1, 0), 1e-9);
        double half = Math.sqrt(0.5);
        assertEquals(80, profile.candela(half, 0, half), 1e-9);
    }

    @Test
    void skipsTiltData() throws IOException {
        String tilt = "TILT=INCLUDE\n1\n3\n0 45 90\n1 0.9 0.8\n";
        assertEquals(100, IesReader.parse(HEADER + tilt + BODY).maximum());
        // Files of 1986 have no first line of their own.
        assertEquals(100, IesReader.parse("A lamp\nTILT=NONE\n" + BODY).maximum());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "0 45 90|0 45 x5|line 7: 'x5' is no vertical angle",
                "0 45 90|0 90 45|vertical angles must ascend",
                "0 90|10 90|horizontal angles must go from 0",
                "20|-20|must not be negative",
                "2 1 2|2 2 2|line 5: type B photometry is not supported",
                "2 1 2|2 3 2|type A photometry",
                "1 1000|0 1000|the number of lamps must be a whole number",
                "3 2 1|3.5 2 1|the number of vertical angles must be a whole number",
                "3 2 1|300000 400000 1|more than",
            })
    void tellsWhatIsWrong(String from, String to, String message) {
        String body = BODY.replace(from, to);
        IOException e = assertThrows(IOException.class, () -> IesReader.parse(HEADER + "TILT=NONE\n" + body));
        String text = String.valueOf(e.getMessage());
        assertTrue(text.startsWith("line ") && text.contains(message), text);
    }

    @Test
    void refusesWhatIsNoSuchFile() {
        assertTrue(message("").contains("no line TILT="));
        assertTrue(message("hello\nworld").contains("no IES file"));
        assertTrue(message("TILT=lamp.tlt\n").contains("TILT must be NONE or INCLUDE but is 'LAMP.TLT'"));
        assertTrue(message("TILT=NONE\n1 1000 1").contains("the file ends where a number of vertical angles"));
    }

    private static String message(String text) {
        return String.valueOf(
                assertThrows(IOException.class, () -> IesReader.parse(text)).getMessage());
    }
}
