package org.daybreak.scenes.write;

import java.io.IOException;
import java.io.Writer;
import org.jspecify.annotations.Nullable;

/** Writes indented XML as the scene reader reads it: a dollar in an attribute is escaped, as it would start a name. */
final class XmlOutput {
    private static final String INDENT = "    ";

    private final Writer out;
    private int depth;
    /** Whether the last start tag has no end yet: it gets that of an empty element if nothing follows. */
    private boolean inTag;

    /** Starts a document. */
    XmlOutput(Writer out) throws IOException {
        this.out = out;
        out.write("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    }

    /**
     * Starts an element that may contain others.
     *
     * @param attributes names and values in turn; those whose value is null are left out
     */
    void open(String element, @Nullable String... attributes) throws IOException {
        endTag();
        indent();
        out.write("<" + element);
        for (int i = 0; i < attributes.length; i += 2) {
            String value = attributes[i + 1];
            if (value != null) {
                out.write(" " + attributes[i] + "=\"" + escaped(value) + "\"");
            }
        }
        inTag = true;
        depth++;
    }

    /** Ends the element. */
    void close(String element) throws IOException {
        depth--;
        if (inTag) {
            out.write("/>\n");
            inTag = false;
        } else {
            indent();
            out.write("</" + element + ">\n");
        }
    }

    /** Writes an element without content. */
    void leaf(String element, @Nullable String... attributes) throws IOException {
        open(element, attributes);
        close(element);
    }

    private void endTag() throws IOException {
        if (inTag) {
            out.write(">\n");
            inTag = false;
        }
    }

    private void indent() throws IOException {
        for (int i = 0; i < depth; i++) {
            out.write(INDENT);
        }
    }

    private static String escaped(String value) {
        StringBuilder text = new StringBuilder(value.length());
        for (int i = 0; i < value.length(); i++) {
            char c = value.charAt(i);
            switch (c) {
                case '&' -> text.append("&amp;");
                case '<' -> text.append("&lt;");
                case '"' -> text.append("&quot;");
                case '$' -> text.append("\\$");
                case '\t', '\n', '\r' -> text.append("&#").append((int) c).append(';');
                default -> text.append(c);
            }
        }
        return text.toString();
    }
}
