package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.Test;

/** Meshes of scene files: normals, winding, triangles without area. */
class SceneMeshesTest extends SceneReading {
    @Test
    void meshesFollowMitsubaInNormalsAndMirroring() throws IOException, SceneException {
        SceneTexts.write(folder, "plain.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nvt 0.25 0.75\nf 1/1 2/1 3/1 4/1\n");
        SceneTexts.write(folder, "own.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
        String mirror = "<transform name='to_world'><scale x='-1'/></transform>";
        String flip = "<boolean name='flip_normals' value='true'/>";
        String flat = "<boolean name='face_normals' value='true'/>";
        assertNotNull(mesh("plain.obj", "").normals());
        assertNull(mesh("plain.obj", flat).normals());
        assertNotNull(mesh("own.obj", "").normals());
        assertNull(mesh("own.obj", flat).normals());
        float[] flipped = mesh("plain.obj", "").uvs();
        assertNotNull(flipped);
        assertEquals(0.25f, flipped[1]);
        float[] kept = mesh("plain.obj", "<boolean name='flip_tex_coords' value='false'/>")
                .uvs();
        assertNotNull(kept);
        assertEquals(0.75f, kept[1]);
        // Without normals in use Mitsuba's front follows the winding in world space, which mirroring turns round.
        assertFalse(node("plain.obj", "").flipNormals());
        assertTrue(node("plain.obj", mirror).flipNormals());
        assertFalse(node("plain.obj", mirror + flip).flipNormals());
        assertTrue(node("own.obj", mirror + flat).flipNormals());
        assertFalse(node("own.obj", mirror).flipNormals());
    }

    @Test
    void computedNormalsAreThoseOfTheTransformedMesh() throws IOException, SceneException {
        SceneTexts.write(folder, "plain.obj", "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 1\nf 1 2 3 4\n");
        // vertex_normals of the same shape in Mitsuba 3.9.1; front by winding.
        float[] expected = {
            -0.12014041f,
            -0.3604212f,
            -0.92502046f,
            0,
            0,
            -1,
            -0.03369471f,
            -0.10108414f,
            -0.99430716f,
            -0.14744195f,
            -0.4423259f,
            -0.8846518f
        };
        float[] local = mesh("plain.obj", "<transform name='to_world'><scale x='3' y='-1' z='0.5'/></transform>")
                .normals();
        assertNotNull(local);
        for (int i = 0; i < local.length; i += 3) {
            // To world by the inverse transpose; the mirrored front is turned round by the node's flip.
            double x = -local[i] / 3;
            double y = local[i + 1];
            double z = -local[i + 2] / 0.5;
            double length = Math.sqrt(x * x + y * y + z * z);
            assertEquals(expected[i], x / length, 1e-6);
            assertEquals(expected[i + 1], y / length, 1e-6);
            assertEquals(expected[i + 2], z / length, 1e-6);
        }
    }

    private ShapeNode node(String file, String properties) throws IOException, SceneException {
        return shape("<shape type='obj'><string name='filename' value='" + file + "'/>" + properties + "</shape>");
    }

    private TriangleMesh mesh(String file, String properties) throws IOException, SceneException {
        return (TriangleMesh) node(file, properties).shape();
    }

    @Test
    void leavesOutTrianglesWithoutAreaAndSaysSo() throws IOException, SceneException {
        SceneTexts.write(folder, "t.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 3\n");
        SceneFile file = load("<shape type='obj'><string name='filename' value='t.obj'/></shape>");
        assertEquals(1, ((TriangleMesh) SceneTexts.onlyShape(file).shape()).triangleCount());
        assertEquals(1, file.warnings().size());
        assertTrue(file.warnings().get(0).message().startsWith("2 triangles of zero area"));
    }
}
