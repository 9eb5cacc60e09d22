package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.IntBinaryOperator;
import javax.imageio.ImageIO;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Mask;
import org.daybreak.core.material.TransportMode;
import org.daybreak.core.material.TwoSided;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** OBJ files with materials, rendered by themselves. */
class ObjMaterialsTest {
    private static final String SQUARE = "mtllib lib/m.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 0.25 0.75\n";

    @TempDir
    Path folder;

    private SceneFile load(String faces, String mtl) throws IOException, SceneException {
        SceneTexts.write(folder, "lib/m.mtl", mtl);
        return new SceneReader().load(SceneTexts.write(folder, "m.obj", SQUARE + faces), Map.of());
    }

    private static double[] albedo(Bsdf bsdf, double u, double v) {
        SurfacePoint p = new SurfacePoint();
        p.u = u;
        p.v = v;
        Spectrum s = new Spectrum();
        bsdf.albedo(p, s);
        return new double[] {s.r, s.g, s.b};
    }

    @Test
    void everyMaterialBecomesAShape() throws IOException, SceneException {
        SceneFile file = load("""
                f 1 2 3
                usemtl red one
                f 1 3 4
                f 1 2 4
                usemtl green
                f 2 3 4
                g other
                usemtl red one
                f 4 3 2
                usemtl unused
                """, "# c\nnewmtl red one\nKd 0.8 0.1 0.1\nillum 1\nnewmtl green\nkd .1 .7 .1\n");
        List<ShapeNode> shapes = SceneTexts.shapes(file.graph().root());
        assertEquals(3, shapes.size());
        assertEquals(
                List.of(1, 3, 1),
                shapes.stream()
                        .map(s -> ((TriangleMesh) s.shape()).triangleCount())
                        .toList());
        assertNull(shapes.get(0).name());
        assertEquals("red one", shapes.get(1).name());
        assertEquals(0.8, albedo(shapes.get(1).material(), 0, 0)[0], 1e-9);
        assertEquals(0.7, albedo(shapes.get(2).material(), 0, 0)[1], 1e-9);
        assertEquals(0.6, albedo(shapes.get(0).material(), 0, 0)[1], 1e-9);
        assertTrue(file.warnings().isEmpty(), () -> file.warnings().toString());
    }

    @Test
    void kindsOfMaterials() throws IOException, SceneException {
        SceneFile file = load("""
                usemtl glass
                f 1 2 3
                usemtl leaf
                f 1 2 3
                usemtl lamp
                f 1 2 3
                usemtl metal
                f 1 2 3
                usemtl paint
                f 1 2 3
                """, """
                newmtl glass
                Ni 1.45
                d 0.1
                illum 4
                newmtl leaf
                Tr 0.25
                newmtl lamp
                Ke 5 4 3
                newmtl metal
                Kd .9 .6 .3
                Pm 1
                Pr 0.4
                newmtl paint
                Kd .2 .3 .4
                Ks .04 .04 .04
                Ns 100
                """);
        List<ShapeNode> shapes = SceneTexts.shapes(file.graph().root());
        assertInstanceOf(Dielectric.class, shapes.get(0).material());
        assertInstanceOf(Mask.class, shapes.get(1).material());
        assertNotNull(shapes.get(2).radiance());
        assertInstanceOf(TwoSided.class, shapes.get(3).material());
        double[] metal = albedo(shapes.get(3).material(), 0, 0);
        assertTrue(metal[0] > metal[1] && metal[1] > metal[2]);
        double[] paint = albedo(shapes.get(4).material(), 0, 0);
        assertTrue(paint[0] > 0.15 && paint[0] < 0.3 && paint[2] > paint[0]);
    }

    /** The map is scaled and shifted in the coordinates of the file, whose v runs upwards. */
    @Test
    void mapsWithOptions() throws IOException, SceneException {
        image("a map.png", (x, y) -> (60 * x) << 16 | (60 * y) << 8);
        SceneFile plain = load("usemtl m\nf 1/1 2/2 3/1\n", "newmtl m\nmap_Kd a map.png\n");
        SceneFile moved = load(
                "usemtl m\nf 1/1 2/2 3/1\n", "newmtl m\nKd 0 0 0\nmap_Kd -s 2 3 1 -o 0.1 0.2 -clamp off a map.png\n");
        Bsdf a = SceneTexts.onlyShape(plain).material();
        Bsdf b = SceneTexts.onlyShape(moved).material();
        for (int i = 0; i < 50; i++) {
            double u = 0.07 * i % 1;
            double v = 0.11 * i % 1;
            double[] expected = albedo(a, 2 * u + 0.1, 1 - (3 * v + 0.2));
            double[] actual = albedo(b, u, 1 - v);
            assertEquals(expected[0], actual[0], 1e-6);
            assertEquals(expected[1], actual[1], 1e-6);
        }
    }

    /** Writes an image of 4×4 pixels, of which each is a function of column and row. */
    private void image(String name, IntBinaryOperator rgb) throws IOException {
        BufferedImage image = new BufferedImage(4, 4, BufferedImage.TYPE_INT_RGB);
        for (int y = 0; y < 4; y++) {
            for (int x = 0; x < 4; x++) {
                image.setRGB(x, y, rgb.applyAsInt(x, y));
            }
        }
        SceneTexts.write(folder, "lib/x", "");
        ImageIO.write(image, "png", folder.resolve("lib").resolve(name).toFile());
    }

    /** The value towards a direction (x, y, z) seen from the normal, where u runs along x and v against y. */
    private static double leaning(Bsdf bsdf, double x, double y) {
        SurfacePoint p = new SurfacePoint();
        p.u = 0.5;
        p.v = 0.5;
        p.nz = 1;
        p.sx = 1;
        p.ty = 1;
        p.uAlongS = 1;
        p.vAlongT = -1;
        Spectrum s = new Spectrum();
        bsdf.evaluate(p, 0, 0, 1, x, y, Math.sqrt(1 - x * x - y * y), TransportMode.RADIANCE, s);
        return s.r;
    }

    /** Heights that rise to the right, by 51/255 in each of four columns, face left. */
    @Test
    void bumpMapsAreHeights() throws IOException, SceneException {
        image("ramp.png", (x, y) -> 0x010101 * (51 * x));
        String shading = "newmtl m\nKd 1 1 1\n";
        for (String statement : List.of("bump -bm 0.5 ramp.png", "map_Bump ramp.png")) {
            Bsdf bumpy = SceneTexts.onlyShape(load("usemtl m\nf 1/1 2/2 3/1\n", shading + statement + "\n"))
                    .material();
            double slope = 51 / 255.0 * 4 * (statement.contains("-bm") ? 0.5 : 1);
            double cosine = (0.3 * -slope + Math.sqrt(1 - 0.09)) / Math.sqrt(1 + slope * slope);
            double other = (0.3 * slope + Math.sqrt(1 - 0.09)) / Math.sqrt(1 + slope * slope);
            assertEquals(cosine / other, leaning(bumpy, 0.3, 0) / leaning(bumpy, -0.3, 0), 1e-4);
            assertEquals(1, leaning(bumpy, 0, 0.3) / leaning(bumpy, 0, -0.3), 1e-9);
        }
    }

    /** Normals under {@code norm}, and under {@code map_bump} as Blender writes them: known by their unit length. */
    @Test
    void normalMapsAreNormals() throws IOException, SceneException {
        // (0.6, 0, 0.8) and (0, 0.6, 0.8).
        image("n.png", (x, y) -> 0xcc80e6);
        image("up.png", (x, y) -> 0x80cce6);
        for (String statement : List.of("norm n.png", "map_bump -bm 1 n.png", "bump n.png\nnorm n.png")) {
            Bsdf bumpy = SceneTexts.onlyShape(load("usemtl m\nf 1/1 2/2 3/1\n", "newmtl m\n" + statement + "\n"))
                    .material();
            double cosine = 0.3 * 0.6 + Math.sqrt(1 - 0.09) * 0.8;
            double other = -0.3 * 0.6 + Math.sqrt(1 - 0.09) * 0.8;
            assertEquals(cosine / other, leaning(bumpy, 0.3, 0) / leaning(bumpy, -0.3, 0), 0.02);
        }
        Bsdf up = SceneTexts.onlyShape(load("usemtl m\nf 1/1 2/2 3/1\n", "newmtl m\nnorm up.png\n"))
                .material();
        // t points up where v runs down.
        assertTrue(leaning(up, 0, 0.3) > 1.4 * leaning(up, 0, -0.3));
    }

    /** Whether a render goes on from a state depends on all files that the scene came from. */
    @Test
    void filesOfMaterialsBelongToTheScene() throws IOException, SceneException {
        image("n.png", (x, y) -> 0xcc80e6);
        SceneFile file = load("usemtl m\nf 1/1 2/2 3/1\n", "newmtl m\nnorm n.png\n");
        assertEquals(
                List.of("m.obj", "lib/m.mtl", "lib/n.png"),
                file.files().stream()
                        .map(f -> folder.relativize(f).toString().replace('\\', '/'))
                        .toList());
    }

    @Test
    void whatIsMissingIsAWarning() throws IOException, SceneException {
        SceneFile file = load("usemtl a\nf 1 2 3\nusemtl bb\nf 1 2 3\n", "newmtl a\nmap_Kd no.png\nNs many\n");
        assertEquals(3, file.warnings().size(), () -> file.warnings().toString());
        assertTrue(file.warnings().get(0).toString().contains("m.mtl:2: the texture 'no.png' does not exist"));
        assertTrue(file.warnings().get(2).message().contains("no material file defines 'bb'"));
        SceneFile alone = new SceneReader()
                .load(
                        SceneTexts.write(folder, "n.obj", SQUARE.replace("lib/m", "x") + "usemtl a\nf 1 2 3\n"),
                        Map.of());
        assertTrue(alone.warnings().get(0).message().contains("'x.mtl' does not exist"));
    }
}
