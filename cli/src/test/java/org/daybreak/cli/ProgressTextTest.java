package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.daybreak.core.render.Progress;
import org.junit.jupiter.api.Test;

class ProgressTextTest {
    private static final Progress HALF = new Progress(0.5, 1000, 2.5e6, 30, 30, 0.0123);
    private static final Progress OPEN = new Progress(0.25, 1000, 999, 12, Double.NaN, Double.NaN);

    @Test
    void numbersAndTimes() {
        assertEquals("999", ProgressText.quantity(999));
        assertEquals("1.23 k", ProgressText.quantity(1234));
        assertEquals("346 M", ProgressText.quantity(345.6e6));
        assertEquals("0.05 s", ProgressText.duration(0.049));
        assertEquals("1:05 min", ProgressText.duration(65));
        assertEquals("2:00:01 h", ProgressText.duration(7201));
    }

    @Test
    void lines() {
        assertEquals(" 50.0 %  2.50 M samples/s  30.00 s left  error 1.23 %", ProgressText.of(HALF));
        assertEquals(" 25.0 %  999 samples/s  12.00 s so far", ProgressText.of(OPEN));
    }

    @Test
    void terminalLineIsBlankedAtTheEnd() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        LineProgress line = new LineProgress(new PrintStream(bytes, true, StandardCharsets.UTF_8));
        line.progress(HALF);
        line.progress(OPEN);
        line.close();
        List<String> texts = List.of(bytes.toString(StandardCharsets.UTF_8).split("\r", -1));
        int length = ProgressText.of(HALF).length();
        assertEquals(List.of("", ProgressText.of(HALF)), texts.subList(0, 2));
        assertEquals(length, texts.get(2).length());
        assertEquals(ProgressText.of(OPEN).length(), texts.get(3).length());
        assertEquals("", texts.get(3).trim());
        assertEquals("", texts.get(4));
    }

    @Test
    void plainLinesComeEveryFiveSeconds() {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        PlainProgress plain = new PlainProgress(new PrintStream(bytes, true, StandardCharsets.UTF_8));
        for (int i = 0; i <= 48; i++) {
            plain.progress(new Progress(0.5, 1, 1, i * 0.25, 1, 1));
        }
        assertEquals(2, bytes.toString(StandardCharsets.UTF_8).lines().count());
    }
}
