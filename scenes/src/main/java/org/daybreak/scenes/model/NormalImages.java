package org.daybreak.scenes.model;

import java.io.IOException;
import java.nio.file.Path;
import org.daybreak.scenes.image.ImageLoader;
import org.daybreak.scenes.image.LoadedImage;

/**
 * Tells normal maps from heights by their pixels: Blender and others write normal maps under {@code map_Bump}, which the format
 * has for heights only.
 */
final class NormalImages {
    /** Pixels of normal maps are unit vectors but for rounding, compression and filtering. */
    private static final double TOLERANCE = 0.2;

    /** Some maps have a border without normals. */
    private static final double SHARE = 0.9;

    private NormalImages() {}

    /** Whether an image holds normals; false if it cannot be read, which is reported where it is used. */
    static boolean holdsNormals(Path file, ImageLoader images) {
        if (!images.endings().contains(ImageLoader.ending(file))) {
            return false;
        }
        try {
            return holdsNormals(images.load(file));
        } catch (IOException e) {
            return false;
        }
    }

    private static boolean holdsNormals(LoadedImage image) {
        int channels = image.channels();
        if (channels < 3) {
            return false;
        }
        int pixels = image.width() * image.height();
        int unit = 0;
        for (int i = 0; i < pixels; i++) {
            double x = component(image, channels * i);
            double y = component(image, channels * i + 1);
            double z = component(image, channels * i + 2);
            if (z > 0 && Math.abs(Math.sqrt(x * x + y * y + z * z) - 1) < TOLERANCE && !(x == y && y == z)) {
                unit++;
            }
        }
        return unit >= SHARE * pixels;
    }

    private static double component(LoadedImage image, int index) {
        double stored = image instanceof LoadedImage.Bytes b
                ? (b.samples()[index] & 0xff) / 255.0
                : ((LoadedImage.Floats) image).samples()[index];
        return 2 * stored - 1;
    }
}
