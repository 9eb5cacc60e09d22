package org.daybreak.scenes.mesh;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import org.daybreak.core.geometry.TriangleMesh;
import org.jspecify.annotations.Nullable;

/**
 * Writes meshes as PLY files, binary and little-endian, with all attributes as 32-bit floats: {@link PlyReader} reads the same
 * mesh, bit for bit. The colours of vertices are linear; their names are those that Mitsuba 3 takes for
 * {@code vertex_color}.
 */
public final class PlyWriter {
    /** Bytes gathered before they are written: a whole number of vertices and faces. */
    private static final int BUFFER = 1 << 16;

    private static final int LARGEST_RECORD = 64;

    private PlyWriter() {}

    /**
     * Writes a mesh.
     *
     * @param out receives the file's bytes; not closed
     * @throws IOException if that fails
     */
    public static void write(OutputStream out, TriangleMesh mesh) throws IOException {
        StringBuilder header = new StringBuilder("ply\nformat binary_little_endian 1.0\n");
        header.append("element vertex ").append(mesh.vertexCount()).append('\n');
        names(header, mesh.positions(), "x", "y", "z");
        names(header, mesh.normals(), "nx", "ny", "nz");
        names(header, mesh.uvs(), "u", "v");
        names(header, mesh.secondUvs(), "u1", "v1");
        names(header, mesh.colors(), "r", "g", "b");
        header.append("element face ").append(mesh.triangleCount()).append('\n');
        header.append("property list uchar int vertex_indices\nend_header\n");
        out.write(header.toString().getBytes(StandardCharsets.US_ASCII));

        byte[] bytes = new byte[BUFFER];
        ByteBuffer buffer = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        for (int vertex = 0; vertex < mesh.vertexCount(); vertex++) {
            put(buffer, mesh.positions(), vertex, 3);
            put(buffer, mesh.normals(), vertex, 3);
            put(buffer, mesh.uvs(), vertex, 2);
            put(buffer, mesh.secondUvs(), vertex, 2);
            put(buffer, mesh.colors(), vertex, 3);
            drain(buffer, bytes, out, LARGEST_RECORD);
        }
        int[] corners = mesh.triangles();
        for (int i = 0; i < corners.length; i += 3) {
            buffer.put((byte) 3).putInt(corners[i]).putInt(corners[i + 1]).putInt(corners[i + 2]);
            drain(buffer, bytes, out, LARGEST_RECORD);
        }
        drain(buffer, bytes, out, BUFFER);
    }

    private static void names(StringBuilder header, float @Nullable [] values, String... names) {
        if (values != null) {
            for (String name : names) {
                header.append("property float ").append(name).append('\n');
            }
        }
    }

    private static void put(ByteBuffer buffer, float @Nullable [] values, int vertex, int components) {
        if (values != null) {
            for (int i = components * vertex; i < components * (vertex + 1); i++) {
                buffer.putFloat(values[i]);
            }
        }
    }

    /** Writes what is gathered in the bytes of the buffer unless so much more fits into the buffer. */
    private static void drain(ByteBuffer buffer, byte[] bytes, OutputStream out, int more) throws IOException {
        if (buffer.remaining() < more) {
            out.write(bytes, 0, buffer.position());
            buffer.clear();
        }
    }
}
