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
    private int lineFeed = -1;
    private int carriageReturn = -1;
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
        int end = lineEnd(position);
        while (end < target) {
            lineStart = end + (text.startsWith("\r\n", end) ? 2 : 1);
            line++;
            end = lineEnd(lineStart);
        }
        position = target;
    }

    /** Where the line ends that an index is in. XML counts a lone carriage return, and a pair with a line feed once. */
    private int lineEnd(int from) {
        // Kept, as a search for what the text does not have goes through all of it.
        if (lineFeed < from) {
            lineFeed = find('\n', from);
        }
        if (carriageReturn < from) {
            carriageReturn = find('\r', from);
        }
        return Math.min(lineFeed, carriageReturn);
    }

    private int find(char c, int from) {
        int found = text.indexOf(c, from);
        return found < 0 ? text.length() : found;
    }
}
