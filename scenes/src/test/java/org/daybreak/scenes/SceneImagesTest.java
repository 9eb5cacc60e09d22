package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import javax.imageio.ImageIO;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.scenes.description.SceneException;
import org.daybreak.scenes.image.ImageLoader;
import org.daybreak.scenes.image.LoadedImage;
import org.daybreak.scenes.image.StandardImageLoader;
import org.junit.jupiter.api.Test;

/** Images that scene files name. */
class SceneImagesTest extends SceneReading {
    @Test
    void readsImages() throws IOException, SceneException {
        writeImage("t.png", BufferedImage.TYPE_INT_RGB);
        ShapeNode node = shape("<shape type='rectangle'><bsdf type='diffuse'><texture type='bitmap' name='reflectance'>"
                + "<string name='filename' value='t.png'/><string name='filter_type' value='nearest'/>"
                + "<transform name='to_uv'><translate x='0.5'/></transform></texture></bsdf></shape>");
        SurfacePoint point = new SurfacePoint();
        point.u = 0.25;
        point.v = 0.25;
        Spectrum out = new Spectrum();
        node.material().albedo(point, out);
        // Half a picture to the right of the upper left pixel, at the top, as in Mitsuba, is green.
        assertArrayEquals(new double[] {0, 1, 0}, new double[] {out.r, out.g, out.b}, 1e-6);
        LightSource.ImageEnvironment env = assertInstanceOf(
                LightSource.ImageEnvironment.class,
                SceneTexts.lightNode(
                                load(
                                        "<emitter type='envmap'><string name='filename' value='t.png'/><float name='scale' value='3'/></emitter>"))
                        .source());
        assertEquals(3, env.scale());
        assertArrayEquals(
                new float[] {1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1}, env.image().rgb(), 1e-6f);
    }

    private void writeImage(String name, int type) throws IOException {
        BufferedImage image = new BufferedImage(2, 2, type);
        image.setRGB(0, 0, 0xffff0000);
        image.setRGB(1, 0, 0xff00ff00);
        image.setRGB(0, 1, 0xff0000ff);
        image.setRGB(1, 1, 0xffffffff);
        assertTrue(ImageIO.write(image, "png", folder.resolve(name).toFile()));
    }

    @Test
    void keepsStoredValuesOfGreyImages() throws IOException {
        for (int type : new int[] {BufferedImage.TYPE_BYTE_GRAY, BufferedImage.TYPE_USHORT_GRAY}) {
            BufferedImage image = new BufferedImage(3, 1, type);
            int[] values =
                    type == BufferedImage.TYPE_BYTE_GRAY ? new int[] {0, 100, 255} : new int[] {0, 30_000, 65_535};
            image.getRaster().setPixels(0, 0, 3, 1, values);
            Path file = folder.resolve("grey" + type + ".png");
            assertTrue(ImageIO.write(image, "png", file.toFile()));
            LoadedImage loaded = new StandardImageLoader().load(file);
            assertEquals(1, loaded.channels());
            if (loaded instanceof LoadedImage.Bytes b) {
                assertArrayEquals(new byte[] {0, 100, (byte) 255}, b.samples());
            } else {
                LoadedImage.Floats f = assertInstanceOf(LoadedImage.Floats.class, loaded);
                assertTrue(f.encoded());
                assertArrayEquals(new float[] {0, 30_000 / 65_535f, 1}, f.samples());
            }
        }
    }

    @Test
    void asksTheGivenImageLoaderFirst() throws IOException, SceneException {
        ImageLoader floats = new ImageLoader() {
            @Override
            public Set<String> endings() {
                return Set.of("exr");
            }

            @Override
            public LoadedImage load(Path file) {
                return new LoadedImage.Floats(1, 1, 3, new float[] {5, 6, 7}, false);
            }
        };
        Files.write(folder.resolve("sky.exr"), new byte[] {1});
        Path file = SceneTexts.write(
                folder,
                "scene.xml",
                SceneTexts.scene("<emitter type='envmap'><string name='filename' value='sky.exr'/></emitter>"));
        SceneFile scene = new SceneReader(floats.or(new StandardImageLoader())).load(file, Map.of());
        LightNode node = (LightNode) scene.graph().root().children().get(1);
        assertArrayEquals(
                new float[] {5, 6, 7},
                ((LightSource.ImageEnvironment) node.source()).image().rgb());
    }
}
