package org.daybreak.cli;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.daybreak.core.render.NearestName;

/** How progress is shown. */
enum ProgressMode {
    /** One line that is rewritten on a terminal, else as {@link #PLAIN}. */
    AUTO,
    /** A line every few seconds. */
    PLAIN,
    /** A JSON object per line. */
    JSON,
    /** Not at all. */
    NONE;

    /** The mode of an option's value; {@link ExitCode#USAGE} if there is none. */
    static ProgressMode of(String text) {
        List<String> known = new ArrayList<>();
        for (ProgressMode mode : values()) {
            String id = mode.name().toLowerCase(Locale.ROOT);
            if (id.equals(text)) {
                return mode;
            }
            known.add(id);
        }
        throw new CommandException(
                ExitCode.USAGE, "there is no progress mode '" + text + "'" + NearestName.hint(text, known));
    }
}
