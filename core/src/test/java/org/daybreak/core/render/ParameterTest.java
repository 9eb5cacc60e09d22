package org.daybreak.core.render;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;

final class ParameterTest {
    private static final List<Parameter> PARAMETERS = List.of(
            Parameter.integer("maxDepth", "Recursion depth", -1, -1, Integer.MAX_VALUE, "Edges."),
            Parameter.real("exponent", "Heuristic exponent", 2, 0, Double.MAX_VALUE, "Beta."),
            Parameter.flag("jitter", "Jitter", true, "Jitter."),
            Parameter.choice("mode", "Mode", "a", List.of("a", "b"), "Mode."),
            Parameter.folder("views", "Views", "Views."));

    @Test
    void parsesEachType() {
        ParameterValues values = ParameterValues.parse(
                PARAMETERS,
                Map.of("maxDepth", " 7 ", "exponent", "0.5", "jitter", "False", "mode", "b", "views", "a b/c"),
                "path");
        assertEquals(7, values.integer("maxDepth"));
        assertEquals(0.5, values.real("exponent"));
        assertEquals(false, values.flag("jitter"));
        assertEquals("b", values.choice("mode"));
        assertEquals("a b/c", values.folder("views"));
        assertEquals("", ParameterValues.defaults(PARAMETERS).folder("views"));
        assertEquals(
                List.of("maxDepth", "exponent", "jitter", "mode", "views"),
                List.copyOf(values.asMap().keySet()));
        assertEquals(-1, ParameterValues.defaults(PARAMETERS).integer("maxDepth"));
    }

    @Test
    void namesWhatIsWrong() {
        assertMessage("maxDepth", "-2", "parameter 'maxDepth' is '-2' but must be a whole number, at least -1");
        assertMessage("maxDepth", "five", "parameter 'maxDepth' is 'five' but must be a whole number, at least -1");
        assertMessage("exponent", "NaN", "parameter 'exponent' is 'NaN' but must be a number, at least 0.0");
        assertMessage("jitter", "yes", "parameter 'jitter' is 'yes' but must be true or false");
        assertMessage("mode", "c", "parameter 'mode' is 'c' but must be one of a, b");
        assertMessage("views", "a\0b", "parameter 'views' is 'a\0b' but must be the name of a folder");
        ParameterException e = assertThrows(
                ParameterException.class, () -> ParameterValues.parse(PARAMETERS, Map.of("maxdept", "3"), "path"));
        assertTrue(
                e.getMessage().contains("'path' has no parameter 'maxdept'; did you mean 'maxDepth'?"), e.getMessage());
    }

    private static void assertMessage(String name, String text, String message) {
        ParameterException e = assertThrows(
                ParameterException.class, () -> ParameterValues.parse(PARAMETERS, Map.of(name, text), "path"));
        assertEquals(message, e.getMessage());
    }
}
