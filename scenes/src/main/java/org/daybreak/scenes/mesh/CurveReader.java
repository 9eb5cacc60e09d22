package org.daybreak.scenes.mesh;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * Reads curves in the text format of Mitsuba 3: a control point with its radius per line, {@code x y z r}, and an empty line
 * between curves.
 */
public final class CurveReader {
    private CurveReader() {}

    /**
     * Reads a file.
     *
     * @return x, y, z, radius per control point, one array per curve
     * @throws MeshFormatException with the line, if the file breaks the format's rules or has no curves
     * @throws IOException if the file cannot be read
     */
    public static double[][] read(Path file) throws IOException {
        List<double[]> curves = new ArrayList<>();
        FloatList points = new FloatList();
        try (ByteSource source = new ByteSource(Files.newInputStream(file))) {
            while (source.peek() != -1) {
                int next = source.skipBlanks();
                if (next == '\n' || next == -1) {
                    points = end(points, curves);
                } else {
                    for (String what : new String[] {"x", "y", "z", "the radius"}) {
                        source.skipBlanks();
                        points.add(source.single(what + " of a control point", -1));
                    }
                    if (points.get(points.size() - 1) < 0) {
                        throw new MeshFormatException(source.line(), "the radius of a control point is negative");
                    }
                    next = source.skipBlanks();
                    if (next != '\n' && next != -1) {
                        throw new MeshFormatException(source.line(), "a control point has more than 4 numbers");
                    }
                }
                source.skipLine();
            }
        }
        end(points, curves);
        if (curves.isEmpty()) {
            throw new MeshFormatException(0, "the file has no curves");
        }
        return curves.toArray(new double[0][]);
    }

    private static FloatList end(FloatList points, List<double[]> curves) {
        if (points.size() == 0) {
            return points;
        }
        double[] curve = new double[points.size()];
        for (int i = 0; i < curve.length; i++) {
            curve[i] = points.get(i);
        }
        curves.add(curve);
        return new FloatList();
    }
}
