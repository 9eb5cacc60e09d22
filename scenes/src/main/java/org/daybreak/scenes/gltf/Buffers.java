package org.daybreak.scenes.gltf;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collections;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import org.jspecify.annotations.Nullable;

/** The buffers of a document and the views into them. Each buffer is read once, when it is first asked for. */
final class Buffers {
    /** More than meshes have that many nodes show, each in another pose. */
    private static final long MOST_ELEMENTS_PER_BYTE = 1024;

    /** Four numbers for each of so many still fit an array. */
    private static final long MOST_ELEMENTS = 1L << 28;

    private final Container container;
    private final IdentityHashMap<JsonValue, Slice> buffers = new IdentityHashMap<>();
    private final IdentityHashMap<JsonValue, GltfException> failures = new IdentityHashMap<>();
    private final Map<Path, byte[]> files = new LinkedHashMap<>();

    Buffers(Container container) {
        this.container = container;
    }

    /**
     * A range of bytes, which exists.
     *
     * @param stride distance between elements in bytes; 0 if they are packed
     */
    record Slice(byte[] bytes, int offset, int length, int stride) {}

    /** The files that buffers have been read from so far. */
    Set<Path> files() {
        return Collections.unmodifiableSet(files.keySet());
    }

    /**
     * The number of corners, vertices or instances that may be decoded in all. Accessors need not take any bytes, and meshes
     * may share them; yet a small file shall not ask for much memory or time.
     */
    long mostElements() {
        long bytes = container.bytes().length;
        for (byte[] file : files.values()) {
            bytes += file.length;
        }
        return Math.min(MOST_ELEMENTS, MOST_ELEMENTS_PER_BYTE * bytes);
    }

    /** The bytes of the buffer view that a value refers to. */
    Slice view(JsonValue reference) throws GltfException {
        JsonValue view = container.resolve(reference, "bufferViews");
        JsonValue bufferReference = view.get("buffer");
        Slice buffer = buffer(container.resolve(bufferReference, "buffers"));
        int offset = view.integer("byteOffset", 0, 0, Integer.MAX_VALUE);
        int length = view.get("byteLength").integer(1, Integer.MAX_VALUE);
        if ((long) offset + length > buffer.length) {
            throw view.error("takes the bytes " + offset + " to " + ((long) offset + length) + " of a buffer of "
                    + buffer.length + " bytes");
        }
        JsonValue strideValue = view.find("byteStride");
        int stride = strideValue == null ? 0 : strideValue.integer(4, 252);
        if (strideValue != null && stride % 4 != 0) {
            throw strideValue.error("must be a multiple of 4 but is " + stride);
        }
        return new Slice(buffer.bytes, buffer.offset + offset, length, stride);
    }

    private Slice buffer(JsonValue buffer) throws GltfException {
        Slice known = buffers.get(buffer);
        if (known != null) {
            return known;
        }
        GltfException failure = failures.get(buffer);
        if (failure != null) {
            throw failure;
        }
        try {
            Slice read = read(buffer);
            buffers.put(buffer, read);
            return read;
        } catch (GltfException e) {
            failures.put(buffer, e);
            throw e;
        }
    }

    private Slice read(JsonValue buffer) throws GltfException {
        int length = buffer.get("byteLength").integer(1, Integer.MAX_VALUE - 8);
        JsonValue uri = buffer.find("uri");
        byte[] bytes;
        int offset = 0;
        int available;
        if (uri == null) {
            if (buffer.index() != 0 || container.bufferLength() < 0) {
                throw buffer.error(
                        "has no uri; only the first buffer of a binary file with a binary chunk may lack it");
            }
            bytes = container.bytes();
            offset = container.bufferOffset();
            available = container.bufferLength();
        } else {
            bytes = Uris.isData(uri.text()) ? Uris.data(uri).bytes() : file(uri, length);
            available = bytes.length;
        }
        if (length > available) {
            throw buffer.get("byteLength").error("is " + length + " but there are only " + available + " bytes");
        }
        return new Slice(bytes, offset, length, 0);
    }

    private byte[] file(JsonValue uri, int length) throws GltfException {
        Path file = Uris.file(uri, container.file());
        byte[] known = files.get(file);
        if (known != null && known.length >= length) {
            return known;
        }
        try (InputStream in = Files.newInputStream(file)) {
            // Asking for the size first keeps a wrong length from asking for memory that the file does not fill.
            byte[] bytes = in.readNBytes((int) Math.min(length, Files.size(file)));
            files.put(file, bytes);
            return bytes;
        } catch (IOException e) {
            throw uri.error("names a file that cannot be read: " + reason(e));
        }
    }

    private static String reason(IOException e) {
        @Nullable String message = e.getMessage();
        return message == null ? e.getClass().getSimpleName() : message;
    }
}
