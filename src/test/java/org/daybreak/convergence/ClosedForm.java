package org.daybreak.convergence;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;

/**
 * The expected values of a diagnostic scene, one grey value per pixel.
 *
 * <p>The CSV files are averages over 16×16 points of each pixel. Where a pixel is crossed by an edge that is off by up to
 * 1/16 of the contrast, which is more than the noise of the tests. For the three scenes with edges the pixels are
 * therefore integrated here exactly, from the formula beside the CSV file; {@link #quantisation} is the difference that
 * this may make.
 */
final class ClosedForm {
    private static final int POINTS_PER_PIXEL_SIDE = 16;

    private final int width;
    private final double[] file;
    private final double[] exact;
    private final double[] blurred;

    private ClosedForm(int width, double[] file, double[] exact, double[] blurred) {
        this.width = width;
        this.file = file;
        this.exact = exact;
        this.blurred = blurred;
    }

    /**
     * Reads the values that belong to a scene file.
     *
     * @param scene name below {@code scenes/diagnostic}: {@code furnace_box/scene_depth1.xml}
     */
    static ClosedForm of(String scene) throws IOException {
        String csv = scene.replace("scene", "expected").replace(".xml", ".csv");
        Path path = ShippedScenes.repository().resolve("scenes/diagnostic").resolve(csv);
        List<String> lines = Files.readAllLines(path, StandardCharsets.US_ASCII);
        double[] values = lines.stream()
                .flatMap(line -> Arrays.stream(line.split(",")))
                .mapToDouble(Double::parseDouble)
                .toArray();
        int width = values.length / lines.size();
        double[] exact = switch (scene) {
            case "furnace_sphere/scene_diffuse05.xml" -> disk(values, width, 4, 1, 40);
            case "concentric_spheres/scene.xml" -> disk(values, width, 1.3, 0.5, 70);
            case "mirror_corridor/scene.xml" -> corridor(width, 10, 0);
            default -> values;
        };
        double[] blurred = scene.startsWith("mirror_corridor/") ? corridor(width, 10, 1e-3) : exact;
        return new ClosedForm(width, values, exact, blurred);
    }

    int width() {
        return width;
    }

    /** Values as in the file. */
    double[] file() {
        return file;
    }

    /** Pixel averages, integrated exactly across edges. */
    double[] exact() {
        return exact;
    }

    /**
     * True where no edge crosses the pixel or lies so near that rounding may move it there: in the mirror corridor each of up
     * to ten reflections starts up to 1e-4 before the mirror, so that rays do not meet it again.
     */
    boolean smooth(int pixel) {
        return Math.abs(exact[pixel] - file[pixel]) <= 1e-8 * file[pixel]
                && Math.abs(exact[pixel] - blurred[pixel]) <= 1e-8 * file[pixel];
    }

    /** Largest difference that the points of the file may make at an edge, as a part of its contrast. */
    static double quantisation() {
        return 1.0 / POINTS_PER_PIXEL_SIDE;
    }

    /**
     * A sphere that is seen along its axis: a disk of one value before a background of another.
     *
     * @param distance distance of its centre
     * @param fov opening angle of the image in degrees
     */
    private static double[] disk(double[] values, int width, double distance, double radius, double fov) {
        double inside = values[width / 2 * width + width / 2];
        double outside = values[0];
        double centre = 0.5 * width;
        double edge = centre * Math.tan(Math.asin(radius / distance)) / Math.tan(Math.toRadians(0.5 * fov));
        double[] exact = new double[values.length];
        int strips = 4096;
        for (int y = 0; y < width; y++) {
            for (int x = 0; x < width; x++) {
                double covered = 0;
                for (int i = 0; i < strips; i++) {
                    double dx = x + (i + 0.5) / strips - centre;
                    double half = Math.sqrt(Math.max(0, edge * edge - dx * dx));
                    covered += overlap(y - centre, y + 1 - centre, -half, half) / strips;
                }
                exact[y * width + x] = outside + covered * (inside - outside);
            }
        }
        return exact;
    }

    /** What of the mirror corridor is seen directly: the light at its end. */
    static double[] corridorWithoutMirrors(int width) {
        return corridor(width, 0, 0);
    }

    /**
     * Horizontal bands of 0.8^k, k = ⌊|10 tan(elevation)| + 1/2⌋ reflections, up to a number of them.
     *
     * @param margin by how much pixels are taken wider than they are, in units of 10 tan(elevation)
     */
    private static double[] corridor(int width, int reflections, double margin) {
        double[] exact = new double[width * width];
        for (int y = 0; y < width; y++) {
            double top = 10 * (1 - 2.0 * y / width);
            double bottom = 10 * (1 - 2.0 * (y + 1) / width);
            double low = Math.min(Math.abs(top), Math.abs(bottom)) - margin;
            double high = Math.max(Math.abs(top), Math.abs(bottom)) + margin;
            double value = 0;
            for (int k = 0; k <= reflections; k++) {
                value += Math.pow(0.8, k) * overlap(low, high, k - 0.5, k + 0.5) / (high - low);
            }
            Arrays.fill(exact, y * width, (y + 1) * width, value);
        }
        return exact;
    }

    private static double overlap(double from1, double to1, double from2, double to2) {
        return Math.max(0, Math.min(to1, to2) - Math.max(from1, from2));
    }
}
