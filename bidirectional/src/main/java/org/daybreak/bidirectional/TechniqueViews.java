package org.daybreak.bidirectional;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.film.SplatBuffer;
import org.daybreak.core.render.ImageSheet;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.sampling.Sampler;
import org.daybreak.core.scene.RayKind;
import org.daybreak.tracing.FurtherImages;
import org.daybreak.tracing.FurtherValues;
import org.daybreak.tracing.RayProcessor;
import org.daybreak.tracing.RaySample;

/**
 * The image of each technique (s, t), weighted and unweighted, for paths up to some length (Veach 1997, figure 10.2). The weighted
 * images, with one of all longer paths, add up to the rendered image. The unweighted image of a technique is what it would
 * render alone: all images of a row that find the same paths have the same mean, and differ in their noise.
 *
 * <p>Its images are numbered: weighted and unweighted ones of each technique by turns, and last that of longer paths if there are any.
 * Immutable.
 */
final class TechniqueViews implements FurtherImages {
    private static final String FOLDER = "techniques";
    private static final String LONGEST = "techniquesDepth";
    private static final int MOST_EDGES = 16;

    /** The parameters from which views are made. */
    static final List<Parameter> PARAMETERS = List.of(
            Parameter.folder(
                    FOLDER,
                    "Images of techniques",
                    "Folder for the weighted and the unweighted image of each technique (s light, t eye vertices): layers of"
                            + " techniques.exr, and one page, techniques.png. Needs about 5 KB of memory per pixel."),
            Parameter.integer(
                    LONGEST,
                    "Images of techniques up to depth",
                    6,
                    1,
                    MOST_EDGES,
                    "Largest number of edges of the paths that techniques have images of. All longer paths have one."));

    /** A technique: vertices from the light and from the lens. */
    private record Technique(int s, int t) {}

    private final List<Technique> techniques = new ArrayList<>();
    private final int edges;
    private final boolean longer;
    /** Number of a technique at [s][t], or -1. */
    private final int[][] numbers;

    /**
     * Finds the techniques of a configuration.
     *
     * @param longest largest number of edges
     */
    TechniqueViews(BidirectionalSettings settings, int longest) {
        // Which way a camera sees has no part in what is admissible.
        TechniqueLimits limits = settings.limits(false, true);
        long mostEdges =
                Math.min(settings.maxVertices() - 1, (long) limits.maxEyeVertices() + limits.maxLightVertices() - 1);
        edges = (int) Math.min(longest, mostEdges);
        longer = mostEdges > edges;
        numbers = new int[edges + 2][edges + 2];
        for (int[] row : numbers) {
            Arrays.fill(row, -1);
        }
        for (int k = 1; k <= edges; k++) {
            for (int s = 0; s <= k + 1; s++) {
                int t = k + 1 - s;
                boolean joined =
                        t > 1 || (t == 0 ? limits.lensHits() : s == 1 ? limits.emitterAtLens() : limits.lens());
                if (s <= limits.maxLightVertices() && t <= limits.maxEyeVertices() && joined) {
                    numbers[s][t] = techniques.size();
                    techniques.add(new Technique(s, t));
                }
            }
        }
    }

    /** The images that parameters ask for. */
    static FurtherImages of(BidirectionalSettings settings, ParameterValues values) {
        return values.folder(FOLDER).isEmpty() ? NONE : new TechniqueViews(settings, values.integer(LONGEST));
    }

    @Override
    public int count() {
        return 2 * techniques.size() + (longer ? 1 : 0);
    }

    @Override
    public Map<String, ImageSheet> sheets(List<FilmImage> images) {
        List<String> rows = new ArrayList<>();
        for (int k = 1; k <= edges; k++) {
            rows.add("k=" + k + (k == 1 ? " edge" : " edges"));
        }
        if (longer) {
            rows.add("longer paths");
        }
        List<ImageSheet.Cell> cells = new ArrayList<>();
        addCells("weighted", 0, images, cells);
        if (longer) {
            cells.add(new ImageSheet.Cell("weighted", "longer", "all", edges, 0, images.get(count() - 1)));
        }
        addCells("unweighted", 1, images, cells);
        return cells.isEmpty() ? Map.of() : Map.of(FOLDER, new ImageSheet(rows, cells));
    }

    private void addCells(String block, int offset, List<FilmImage> images, List<ImageSheet.Cell> cells) {
        for (int i = 0; i < techniques.size(); i++) {
            int s = techniques.get(i).s;
            int t = techniques.get(i).t;
            cells.add(new ImageSheet.Cell(
                    block, "s" + s + "t" + t, "s=" + s + " t=" + t, s + t - 2, s, images.get(2 * i + offset)));
        }
    }

    /** A processor that fills the images. */
    RayProcessor record(ProcessorMaker maker) {
        return new Recorder(maker);
    }

    /** Makes a processor that tells of its contributions. */
    @FunctionalInterface
    interface ProcessorMaker {
        /** Makes it. */
        RayProcessor make(Contribution.Listener listener);
    }

    /** Passes all on to a processor and its contributions to the images. Owned by one worker. */
    private final class Recorder implements RayProcessor, Contribution.Listener {
        private final RayProcessor processor;
        private FurtherValues values = new RaySample().further;

        Recorder(ProcessorMaker maker) {
            processor = maker.make(this);
        }

        @Override
        public void beginUnit() {
            processor.beginUnit();
        }

        @Override
        public boolean trace(double filmX, double filmY, Sampler sampler, RaySample out, SplatBuffer splats) {
            values = out.further;
            return processor.trace(filmX, filmY, sampler, out, splats);
        }

        @Override
        public long rays(RayKind kind) {
            return processor.rays(kind);
        }

        @Override
        public void found(Contribution c) {
            if (c.s + c.t - 1 > edges) {
                add(count() - 1, c, c.weight);
                return;
            }
            int number = numbers[c.s][c.t];
            add(2 * number, c, c.weight);
            add(2 * number + 1, c, 1);
        }

        private void add(int image, Contribution c, double weight) {
            double r = weight * c.r;
            double g = weight * c.g;
            double b = weight * c.b;
            if (c.t <= 1) {
                values.splat(image, c.filmX, c.filmY, r, g, b);
            } else {
                values.add(image, r, g, b);
            }
        }
    }
}
