package org.daybreak.scenes.mesh;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.Channels;
import java.nio.channels.SeekableByteChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.Inflater;
import java.util.zip.InflaterInputStream;
import java.util.zip.ZipException;
import org.daybreak.core.geometry.TriangleMesh;
import org.jspecify.annotations.Nullable;

/**
 * Reads the {@code serialized} meshes of Mitsuba 0.6, versions 3 and 4: several meshes in one file, each compressed by zlib,
 * in single or double precision, with a table of their places at the end.
 */
public final class SerializedReader {
    private static final int MAGIC = 0x041C;
    private static final int NORMALS = 0x0001;
    private static final int TEXTURE_COORDINATES = 0x0002;
    private static final int COLORS = 0x0008;
    private static final int FLAT = 0x0010;
    private static final int SINGLE = 0x1000;
    private static final int DOUBLE = 0x2000;
    private static final int KNOWN = NORMALS | TEXTURE_COORDINATES | COLORS | FLAT | SINGLE | DOUBLE;

    /** Deflate expands no byte to more than this many. */
    private static final long HIGHEST_EXPANSION = 1032;

    private static final int LONGEST_NAME = 1 << 12;

    /**
     * A mesh of a file.
     *
     * @param mesh the mesh, with normals if the file has some
     * @param flat true if the file asks for flat triangles
     * @param name its name; empty in version 3
     */
    public record Mesh(TriangleMesh mesh, boolean flat, String name) {}

    private final ByteSource source;
    private final long longest;

    private SerializedReader(ByteSource source, long longest) {
        this.source = source;
        this.longest = longest;
    }

    /**
     * Reads one mesh of a file.
     *
     * @param index number of the mesh, from 0
     * @throws MeshFormatException if the file breaks the format's rules or has no such mesh
     * @throws IOException if the file cannot be read
     */
    public static Mesh read(Path file, int index) throws IOException {
        try (SeekableByteChannel channel = Files.newByteChannel(file)) {
            long size = channel.size();
            ByteBuffer header = bytes(channel, 0, 4, size);
            int magic = header.getShort() & 0xffff;
            int version = header.getShort() & 0xffff;
            if (magic != MAGIC) {
                throw new MeshFormatException(0, "the file is no serialized mesh: it does not begin with 1C 04");
            }
            if (version != 3 && version != 4) {
                throw new MeshFormatException(
                        0, "the file is of version " + version + "; only versions 3 and 4 can be read");
            }
            long start = start(channel, size, version, index);
            channel.position(start);
            InputStream compressed = Channels.newInputStream(channel);
            Inflater inflater = new Inflater();
            try (ByteSource source = new ByteSource(new InflaterInputStream(compressed, inflater, 1 << 14))) {
                return new SerializedReader(source, HIGHEST_EXPANSION * (size - start)).read(version);
            } catch (ZipException e) {
                throw new MeshFormatException(0, "the compressed data of mesh " + index + " are damaged");
            } catch (java.io.EOFException e) {
                throw new MeshFormatException(0, "the file ends in the middle of mesh " + index);
            } finally {
                inflater.end();
            }
        }
    }

    /** Where the compressed data of a mesh begin. */
    private static long start(SeekableByteChannel channel, long size, int version, int index) throws IOException {
        long count = bytes(channel, size - 4, 4, size).getInt() & 0xffffffffL;
        int entry = version == 4 ? 8 : 4;
        if (count == 0 || count > (size - 8) / entry) {
            throw new MeshFormatException(0, "the table at the end of the file is damaged");
        }
        if (index < 0 || index >= count) {
            throw new MeshFormatException(0, "there is no mesh " + index + ": the file has " + count);
        }
        ByteBuffer place = bytes(channel, size - 4 - entry * (count - index), entry, size);
        long offset = version == 4 ? place.getLong() : place.getInt() & 0xffffffffL;
        if (offset < 0 || offset > size - 8 || (bytes(channel, offset, 2, size).getShort() & 0xffff) != MAGIC) {
            throw new MeshFormatException(
                    0, "the table at the end of the file is damaged: mesh " + index + " would begin at byte " + offset);
        }
        return offset + 4;
    }

    private static ByteBuffer bytes(SeekableByteChannel channel, long at, int count, long size) throws IOException {
        if (at < 0 || at > size - count) {
            throw new MeshFormatException(0, "the file is too short: it has " + size + " bytes");
        }
        ByteBuffer buffer = ByteBuffer.allocate(count).order(ByteOrder.LITTLE_ENDIAN);
        channel.position(at);
        while (buffer.hasRemaining()) {
            if (channel.read(buffer) < 0) {
                throw new MeshFormatException(0, "the file is too short: it has " + size + " bytes");
            }
        }
        return buffer.flip();
    }

    private Mesh read(int version) throws IOException {
        int flags = source.int32(false);
        if ((flags & ~KNOWN) != 0 || (flags & (SINGLE | DOUBLE)) == (SINGLE | DOUBLE)) {
            throw new MeshFormatException(0, String.format("the flags %x of the mesh are unknown", flags));
        }
        boolean wide = (flags & DOUBLE) != 0;
        String name = version == 4 ? name() : "";
        long vertices = source.int64(false);
        long faces = source.int64(false);
        // Positions and indices of all of them must fit into what the compressed data can expand to.
        long vertexBytes = wide ? 24 : 12;
        if (vertices < 0
                || faces < 0
                || vertices > Math.min(longest / vertexBytes, Integer.MAX_VALUE / 3 - 8)
                || faces > Math.min(longest / 12, Integer.MAX_VALUE / 3 - 8)) {
            throw new MeshFormatException(
                    0,
                    "the mesh promises " + vertices + " vertices and " + faces
                            + " triangles; the file has too few bytes");
        }
        if (faces == 0) {
            throw new MeshFormatException(0, "the mesh has no triangles");
        }
        int count = (int) vertices;
        float[] positions = reals(3 * count, wide, "position");
        float @Nullable [] normals = (flags & NORMALS) == 0 ? null : reals(3 * count, wide, "normal");
        float @Nullable [] uvs =
                (flags & TEXTURE_COORDINATES) == 0 ? null : reals(2 * count, wide, "texture coordinate");
        float @Nullable [] colors = (flags & COLORS) == 0 ? null : reals(3 * count, wide, "colour");
        for (int i = 0; colors != null && i < colors.length; i++) {
            colors[i] = Math.max(0, Math.min(1, colors[i]));
        }
        int[] triangles = new int[3 * (int) faces];
        for (int i = 0; i < triangles.length; i++) {
            int vertex = source.int32(false);
            if (vertex < 0 || vertex >= count) {
                throw new MeshFormatException(
                        0,
                        "triangle " + i / 3 + " refers to vertex " + (vertex & 0xffffffffL) + " but there are "
                                + count);
            }
            triangles[i] = vertex;
        }
        boolean flat = (flags & FLAT) != 0;
        return new Mesh(new TriangleMesh(positions, triangles, flat ? null : normals, uvs, null, colors), flat, name);
    }

    private String name() throws IOException {
        StringBuilder name = new StringBuilder();
        for (int c = source.uint8(); c != 0; c = source.uint8()) {
            if (name.length() == LONGEST_NAME) {
                throw new MeshFormatException(0, "the name of the mesh is longer than " + LONGEST_NAME + " bytes");
            }
            name.append((char) c);
        }
        return new String(
                name.toString().getBytes(java.nio.charset.StandardCharsets.ISO_8859_1),
                java.nio.charset.StandardCharsets.UTF_8);
    }

    private float[] reals(int count, boolean wide, String what) throws IOException {
        float[] values = new float[count];
        for (int i = 0; i < count; i++) {
            float value = wide
                    ? (float) Double.longBitsToDouble(source.int64(false))
                    : Float.intBitsToFloat(source.int32(false));
            if (!Float.isFinite(value)) {
                throw new MeshFormatException(0, "a " + what + " of the mesh is not finite");
            }
            values[i] = value;
        }
        return values;
    }
}
