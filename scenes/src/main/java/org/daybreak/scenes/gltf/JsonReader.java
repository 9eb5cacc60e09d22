package org.daybreak.scenes.gltf;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonLocation;
import com.fasterxml.jackson.core.JsonParseException;
import com.fasterxml.jackson.core.JsonParser;
import com.fasterxml.jackson.core.JsonToken;
import com.fasterxml.jackson.core.StreamReadConstraints;
import com.fasterxml.jackson.core.StreamReadFeature;
import java.io.IOException;
import org.jspecify.annotations.Nullable;

/** Reads JSON text into values that know where they stand. */
final class JsonReader {
    /** Deeper nesting than any glTF extension has. */
    private static final int DEEPEST = 128;

    private JsonReader() {}

    /**
     * Reads a document: one value and nothing behind it. Names that an object has twice are refused.
     *
     * @param bytes holds the text in UTF-8
     * @throws com.fasterxml.jackson.core.JsonProcessingException with the place, if the text is no JSON
     */
    static JsonValue read(byte[] bytes, int offset, int length) throws IOException {
        JsonFactory factory = JsonFactory.builder()
                .enable(StreamReadFeature.STRICT_DUPLICATE_DETECTION)
                // Embedded buffers are strings; a string is never longer than the file.
                .streamReadConstraints(StreamReadConstraints.builder()
                        .maxStringLength(Integer.MAX_VALUE)
                        .maxNestingDepth(DEEPEST + 1)
                        .build())
                .build();
        try (JsonParser parser = factory.createParser(bytes, offset, length)) {
            JsonValue root = null;
            JsonValue container = null;
            int depth = 0;
            for (JsonToken token = parser.nextToken(); token != null; token = parser.nextToken()) {
                if (token == JsonToken.END_OBJECT || token == JsonToken.END_ARRAY) {
                    depth--;
                    container = container == null ? null : container.parent();
                } else if (token != JsonToken.FIELD_NAME) {
                    if (root != null && container == null) {
                        throw new JsonParseException(parser, "there is more behind the end of the document");
                    }
                    JsonValue value = value(parser, token, container);
                    root = root == null ? value : root;
                    if (container != null) {
                        container.append(value);
                    }
                    if (token.isStructStart()) {
                        if (++depth > DEEPEST) {
                            throw new JsonParseException(
                                    parser, "arrays and objects are nested more than " + DEEPEST + " levels deep");
                        }
                        container = value;
                    }
                }
            }
            if (root == null) {
                throw new JsonParseException(parser, "the document is empty");
            }
            return root;
        }
    }

    private static JsonValue value(JsonParser parser, JsonToken token, @Nullable JsonValue container)
            throws IOException {
        JsonLocation location = parser.currentTokenLocation();
        double number = token == JsonToken.VALUE_TRUE ? 1 : token.isNumeric() ? parser.getDoubleValue() : 0;
        String text = token == JsonToken.VALUE_STRING ? parser.getText() : "";
        return new JsonValue(
                kind(token),
                container,
                parser.currentName(),
                location.getLineNr(),
                location.getColumnNr(),
                number,
                text);
    }

    private static JsonValue.Kind kind(JsonToken token) {
        return switch (token) {
            case START_OBJECT -> JsonValue.Kind.OBJECT;
            case START_ARRAY -> JsonValue.Kind.ARRAY;
            case VALUE_STRING -> JsonValue.Kind.TEXT;
            case VALUE_TRUE, VALUE_FALSE -> JsonValue.Kind.TRUTH;
            case VALUE_NULL -> JsonValue.Kind.NULL;
            default -> JsonValue.Kind.NUMBER;
        };
    }
}
