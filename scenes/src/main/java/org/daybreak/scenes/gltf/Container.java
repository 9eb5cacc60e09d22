package org.daybreak.scenes.gltf;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import org.jspecify.annotations.Nullable;

/**
 * A glTF file taken apart: its JSON document and, in a binary file, the buffer that comes with it (glTF 2.0 specification,
 * chapter 4).
 *
 * @param file the file
 * @param text true if the file is the JSON document itself, so that lines and columns mean something to its author
 * @param root the JSON document
 * @param bytes the whole file
 * @param bufferOffset where the binary chunk starts in {@code bytes}
 * @param bufferLength length of the binary chunk; −1 if there is none
 */
record Container(Path file, boolean text, JsonValue root, byte[] bytes, int bufferOffset, int bufferLength) {
    private static final int MAGIC = 0x46546c67;
    private static final int JSON_CHUNK = 0x4e4f534a;
    private static final int BINARY_CHUNK = 0x004e4942;
    private static final int HEADER_LENGTH = 12;
    private static final int CHUNK_HEADER_LENGTH = 8;

    /**
     * Reads a file; its first bytes say whether it is text or binary.
     *
     * @throws com.fasterxml.jackson.core.JsonProcessingException if the document is no JSON
     * @throws IOException with a message fit for users if the file cannot be read or is damaged
     */
    static Container read(Path file) throws IOException {
        byte[] bytes = content(file);
        ByteBuffer data = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        if (bytes.length < 4 || data.getInt(0) != MAGIC) {
            return new Container(file, true, JsonReader.read(bytes, 0, bytes.length), bytes, 0, -1);
        }
        if (bytes.length < HEADER_LENGTH + CHUNK_HEADER_LENGTH) {
            throw new IOException("the file ends within its header");
        }
        if (data.getInt(4) != 2) {
            throw new IOException("binary glTF of version " + Integer.toUnsignedString(data.getInt(4))
                    + " is not supported, only version 2");
        }
        long length = Integer.toUnsignedLong(data.getInt(8));
        if (length > bytes.length) {
            throw new IOException(
                    "the file is cut off: its header says " + length + " bytes but it has " + bytes.length);
        }
        JsonValue root = null;
        int bufferOffset = 0;
        int bufferLength = -1;
        long at = HEADER_LENGTH;
        for (int chunk = 0; at + CHUNK_HEADER_LENGTH <= length; chunk++) {
            long chunkLength = Integer.toUnsignedLong(data.getInt((int) at));
            int type = data.getInt((int) at + 4);
            at += CHUNK_HEADER_LENGTH;
            if (chunkLength > length - at) {
                throw new IOException("chunk " + chunk + " reaches beyond the end of the file");
            }
            if (chunk == 0) {
                if (type != JSON_CHUNK) {
                    throw new IOException("the first chunk must be JSON");
                }
                root = JsonReader.read(bytes, (int) at, (int) chunkLength);
            } else if (chunk == 1 && type == BINARY_CHUNK) {
                bufferOffset = (int) at;
                bufferLength = (int) chunkLength;
            }
            // Other chunks belong to extensions and are passed over, as the specification asks.
            at += chunkLength;
        }
        if (root == null) {
            throw new IOException("the file has no JSON chunk");
        }
        return new Container(file, false, root, bytes, bufferOffset, bufferLength);
    }

    private static byte[] content(Path file) throws IOException {
        if (!Files.exists(file)) {
            throw new IOException("the file does not exist");
        }
        if (!Files.isRegularFile(file)) {
            throw new IOException("this is no regular file");
        }
        if (Files.size(file) > Integer.MAX_VALUE - 8) {
            throw new IOException("files of more than 2 GB are not supported; keep buffers in files of their own");
        }
        return Files.readAllBytes(file);
    }

    /** The element of a top-level array that a value refers to by its index. */
    JsonValue resolve(JsonValue reference, String array) throws GltfException {
        JsonValue list = root.find(array);
        int size = list == null ? 0 : list.elements().size();
        int index = reference.integer(0, Integer.MAX_VALUE);
        if (list == null || index >= size) {
            throw reference.error("refers to " + array + "/" + index + " but there "
                    + (size == 1 ? "is 1" : "are " + (size == 0 ? "none" : Integer.toString(size))));
        }
        return list.elements().get(index);
    }

    /** The element that a member of an object refers to, or null if the member is missing. */
    @Nullable
    JsonValue resolve(JsonValue object, String member, String array) throws GltfException {
        JsonValue reference = object.find(member);
        return reference == null ? null : resolve(reference, array);
    }
}
