package org.daybreak.metropolis.strategy;

/** Cells of path space. */
public final class Paths {
    private Paths() {}

    /** What a path consists of: number of edges, surface and delta lobe of each vertex, the light. */
    public static String signature(LightPath path) {
        StringBuilder text = new StringBuilder();
        text.append(path.light).append(path.infinite ? '*' : ' ');
        for (int i = 0; i < path.length - 1; i++) {
            text.append(i == 0 && path.infinite ? -1 : path.points[i].shape);
            text.append(path.lobe[i] < 0 ? 'D' : (char) ('R' + path.lobe[i]));
        }
        return text.toString();
    }

    /** What is seen, and what it is lit by: few cells, so that what is wrong with one surface or light shows. */
    public static String ends(LightPath path) {
        int seen = path.length - 2;
        return path.light + " " + (seen == 0 ? "" : path.points[seen].shape + " " + path.lobe[seen]);
    }

    /** Number of edges and of delta lobes. */
    public static String counts(LightPath path) {
        int deltas = 0;
        for (int i = 1; i < path.length - 1; i++) {
            deltas += path.lobe[i] < 0 ? 0 : 1;
        }
        return path.length + " " + deltas;
    }

    /** Where the vertices are, by octants about a point, and the image point by quadrants of the film. */
    public static String places(LightPath path, double x, double y, double z, int filmSize) {
        StringBuilder text = new StringBuilder();
        text.append(2 * path.filmX < filmSize ? 0 : 1).append(2 * path.filmY < filmSize ? 0 : 1);
        for (int i = path.infinite ? 1 : 0; i < path.length - 1; i++) {
            int octant =
                    (path.points[i].x < x ? 0 : 1) + (path.points[i].y < y ? 0 : 2) + (path.points[i].z < z ? 0 : 4);
            text.append((char) ('a' + octant));
        }
        return text.toString();
    }

    /** Lengths of the edges at the lens and at the light, by factors of √2. */
    public static String lengths(LightPath path) {
        int k = path.length - 1;
        return k + " " + Math.round(Math.log(path.squared[k - 1])) + " "
                + (path.infinite ? "*" : Math.round(Math.log(path.squared[0])));
    }

    /** Edges, from the lens on, that are shorter than a part of the way from their end to the lens. */
    public static String shortEdges(LightPath path, double part) {
        StringBuilder text = new StringBuilder();
        double way = 0;
        for (int i = path.length - 2; i >= 0; i--) {
            double edge = Math.sqrt(path.squared[i]);
            text.append(edge < part * way ? 's' : 'l');
            way += edge;
        }
        return text.toString();
    }

    /** Order of magnitude of the contribution, by factors of √2. */
    public static String magnitude(LightPath path) {
        return path.length + " " + Math.round(2 * Math.log(path.contribution) / Math.log(2));
    }
}
