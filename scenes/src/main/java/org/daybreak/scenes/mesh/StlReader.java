package org.daybreak.scenes.mesh;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.render.NearestName;

/**
 * Reads STL files, binary (little-endian) and ASCII. Equal vertices are shared. The normals in the files are passed over, as
 * many programs write zeros: the order of the vertices says which side is out. All solids of a file become one mesh.
 *
 * <p>Which kind a file is of does not depend on its first word alone, since binary files begin with "solid" too: it is
 * binary if its size is what the count at byte 80 asks for; else ASCII if it begins with "solid"; else binary if it is
 * at least as large as the count asks for.
 */
public final class StlReader {
    private static final int HEADER = 80;
    private static final int FACET = 50;
    private static final List<String> KEYWORDS =
            List.of("solid", "facet", "normal", "outer", "loop", "vertex", "endloop", "endfacet", "endsolid");

    private final ByteSource source;
    private final TripleTable vertices = new TripleTable();
    private final IntList triangles = new IntList();

    private StlReader(ByteSource source) {
        this.source = source;
    }

    /**
     * Reads a file.
     *
     * @return the mesh, without normals
     * @throws MeshFormatException with the line where there is one, if the file breaks the format's rules or has no facets
     * @throws IOException if the file cannot be read
     */
    public static TriangleMesh read(Path file) throws IOException {
        long size = Files.size(file);
        byte[] start;
        try (InputStream stream = Files.newInputStream(file)) {
            start = stream.readNBytes(HEADER + 4);
        }
        long count = start.length < HEADER + 4 ? -1 : countOf(start);
        long expected = HEADER + 4 + FACET * count;
        boolean text = size != expected || count < 0;
        if (text && !beginsWithSolid(start)) {
            text = false;
            if (count < 0 || size < expected) {
                throw new MeshFormatException(
                        0,
                        count < 0
                                ? "the file is no STL: it neither begins with 'solid' nor has 84 bytes"
                                : "the file promises " + count + " facets but has only " + size
                                        + " bytes, or is no STL");
            }
        }
        try (ByteSource source = new ByteSource(Files.newInputStream(file))) {
            StlReader reader = new StlReader(source);
            if (text) {
                reader.readText();
            } else {
                reader.readBinary(count);
            }
            return reader.mesh();
        }
    }

    private static long countOf(byte[] start) {
        return (start[HEADER] & 0xff)
                | (start[HEADER + 1] & 0xff) << 8
                | (start[HEADER + 2] & 0xff) << 16
                | (start[HEADER + 3] & 0xffL) << 24;
    }

    private static boolean beginsWithSolid(byte[] start) {
        int at = 0;
        while (at < start.length && start[at] <= ' ' && start[at] > 0) {
            at++;
        }
        return start.length >= at + 5
                && new String(start, at, 5, java.nio.charset.StandardCharsets.ISO_8859_1)
                        .toLowerCase(Locale.ROOT)
                        .equals("solid");
    }

    private void readBinary(long count) throws IOException {
        source.skip(HEADER + 4);
        for (long facet = 0; facet < count; facet++) {
            source.skip(12);
            for (int corner = 0; corner < 3; corner++) {
                float x = Float.intBitsToFloat(source.int32(false));
                float y = Float.intBitsToFloat(source.int32(false));
                float z = Float.intBitsToFloat(source.int32(false));
                if (!Float.isFinite(x) || !Float.isFinite(y) || !Float.isFinite(z)) {
                    throw new MeshFormatException(0, "facet " + facet + " has a vertex that is not finite");
                }
                triangles.add(vertex(x, y, z));
            }
            source.skip(2);
        }
    }

    private void readText() throws IOException {
        while (source.skipSpace() != -1) {
            String word = keyword();
            switch (word) {
                case "solid", "endsolid" -> source.skipLine();
                case "facet" -> readFacet();
                default -> throw unexpected(word, "solid, facet or endsolid");
            }
        }
    }

    private void readFacet() throws IOException {
        expect("normal");
        for (int i = 0; i < 3; i++) {
            // Writers of degenerate facets give "nan" here; the value is not used.
            source.skipSpace();
            source.word();
        }
        expect("outer");
        expect("loop");
        int corners = 0;
        while (true) {
            source.skipSpace();
            String word = keyword();
            if (word.equals("endloop")) {
                break;
            }
            if (!word.equals("vertex")) {
                throw unexpected(word, "vertex or endloop");
            }
            if (++corners > 3) {
                throw new MeshFormatException(source.line(), "a facet has more than 3 vertices");
            }
            triangles.add(vertex(coordinate("x"), coordinate("y"), coordinate("z")));
        }
        if (corners < 3) {
            throw new MeshFormatException(source.line(), "a facet has " + corners + " vertices but needs 3");
        }
        expect("endfacet");
    }

    private float coordinate(String axis) throws IOException {
        source.skipSpace();
        return source.single(axis + " of a vertex", -1);
    }

    private int vertex(float x, float y, float z) {
        // The sum with zero turns -0 into +0, which is the same place.
        return vertices.number(
                Float.floatToRawIntBits(x + 0f), Float.floatToRawIntBits(y + 0f), Float.floatToRawIntBits(z + 0f));
    }

    private String keyword() throws IOException {
        return source.word().toLowerCase(Locale.ROOT);
    }

    private void expect(String wanted) throws IOException {
        source.skipSpace();
        String word = keyword();
        if (!word.equals(wanted)) {
            throw unexpected(word, wanted);
        }
    }

    private MeshFormatException unexpected(String word, String wanted) {
        return new MeshFormatException(
                source.line(),
                word.isEmpty()
                        ? "the file ends where " + wanted + " must follow"
                        : "'" + word + "' where " + wanted + " must follow" + NearestName.hint(word, KEYWORDS));
    }

    private TriangleMesh mesh() throws MeshFormatException {
        if (triangles.size() == 0) {
            throw new MeshFormatException(0, "the file has no facets");
        }
        float[] positions = new float[3 * vertices.size()];
        for (int i = 0; i < positions.length; i++) {
            positions[i] = Float.intBitsToFloat(vertices.get(i / 3, i % 3));
        }
        return new TriangleMesh(positions, triangles.toArray(), null, null);
    }
}
