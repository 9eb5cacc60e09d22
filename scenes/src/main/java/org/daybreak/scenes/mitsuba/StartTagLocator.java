package org.daybreak.scenes.mitsuba;

/**
 * Finds where start tags begin. StAX only knows where a tag ends, so this walks over the same text in step with the parser:
 * the n-th call of {@link #advance} stands at the n-th start tag. It relies on the parser for well-formedness.
 */
final class StartTagLocator {
    private final String text;
    private int position;
    private int line = 1;
    private int lineStart;
    private int startLine = 1;
    private int startColumn = 1;

    StartTagLocator(String text) {
        this.text = text;
    }

    /** Goes to the next start tag. */
    void advance() {
        while (true) {
            int tag = text.indexOf('<', position);
            if (tag < 0) {
                moveTo(text.length());
                return;
            }
            moveTo(tag);
            if (text.startsWith("<!--", tag)) {
                moveTo(after("-->", tag + 4));
            } else if (text.startsWith("<![CDATA[", tag)) {
                moveTo(after("]]>", tag + 9));
            } else if (text.startsWith("<?", tag)) {
                moveTo(after("?>", tag + 2));
            } else if (text.startsWith("</", tag)) {
                moveTo(after(">", tag + 2));
            } else {
                startLine = line;
                startColumn = tag - lineStart + 1;
                moveTo(endOfTag(tag));
                return;
            }
        }
    }

    /** Line of the start tag, from 1. */
    int line() {
        return startLine;
    }

    /** Column of the start tag, from 1. */
    int column() {
        return startColumn;
    }

    private int after(String end, int from) {
        int found = text.indexOf(end, from);
        return found < 0 ? text.length() : found + end.length();
    }

    /** Attribute values may contain {@code >}. */
    private int endOfTag(int tag) {
        char quote = 0;
        for (int i = tag + 1; i < text.length(); i++) {
            char c = text.charAt(i);
            if (quote != 0) {
                if (c == quote) {
                    quote = 0;
                }
            } else if (c == '"' || c == '\'') {
                quote = c;
            } else if (c == '>') {
                return i + 1;
            }
        }
        return text.length();
    }

    private void moveTo(int target) {
        for (int i = position; i < target; i++) {
            char c = text.charAt(i);
            // XML counts a lone carriage return as a line end, and a pair with a line feed once.
            if (c == '\n' || (c == '\r' && !(i + 1 < text.length() && text.charAt(i + 1) == '\n'))) {
                line++;
                lineStart = i + 1;
            }
        }
        position = target;
    }
}
