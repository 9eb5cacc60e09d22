package org.daybreak.cli;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.Collectors;
import org.daybreak.core.render.SampleAddress;
import org.daybreak.core.render.SampleRecord;
import org.daybreak.core.render.SampleRequest;
import org.jspecify.annotations.Nullable;

/** What {@code daybreak replay} prints about a sample, for people or as JSON. */
final class ReplayText {
    private static final String CONTRIBUTION = "%3s %3s  %-3s  %-5s  %-36s  %-11s  %-24s  %s%n";

    private final String scene;
    private final String renderer;
    private final SampleRequest request;
    private final SampleRecord record;

    /**
     * Creates the text.
     *
     * @param scene name of the scene
     * @param renderer identifier of the renderer
     */
    ReplayText(String scene, String renderer, SampleRequest request, SampleRecord record) {
        this.scene = scene;
        this.renderer = renderer;
        this.request = request;
        this.record = record;
    }

    /** Lines for people. */
    String text() {
        StringBuilder out = new StringBuilder();
        SampleAddress address = request.address();
        line(
                out,
                "scene " + scene + ", renderer " + renderer + ", antialiasing "
                        + request.antialiasing().id() + ", " + address + " of " + request.samplesPerPixel());
        line(out, "film position " + pair(record.filmX(), record.filmY()));
        record.notes().forEach(note -> line(out, "note: " + note));
        for (SampleRecord.Subpath path : record.subpaths()) {
            line(out, "");
            line(out, path.name() + ", vertices: " + path.vertices().size());
            path.vertices().forEach(vertex -> vertex(out, vertex));
        }
        line(out, "");
        line(out, "ways to join them (s vertices from the light, t from the lens):");
        out.append(String.format(
                Locale.ROOT,
                CONTRIBUTION,
                "s",
                "t",
                "eye",
                "light",
                "unweighted",
                "weight",
                "film position",
                "outcome"));
        record.contributions().forEach(c -> contribution(out, c));
        line(out, "");
        line(out, "radiance of the sample: " + color(record.radiance()));
        line(out, "splatted, to be divided by the number of samples of the render: " + color(splatted()));
        line(
                out,
                "rays: "
                        + record.raysByKind().entrySet().stream()
                                .map(e -> e.getKey() + " " + e.getValue())
                                .collect(Collectors.joining(", ")));
        return out.toString();
    }

    private static void vertex(StringBuilder out, SampleRecord.Vertex v) {
        String kind = v.delta() ? ", goes on by a delta lobe" : "";
        String joined = v.connectable() ? "" : ", cannot be joined";
        line(out, "  " + v.name() + "  " + v.what() + kind + joined);
        line(out, "      position " + vector(v.position()) + "  normal " + vector(v.normal()));
        line(
                out,
                "      throughput " + color(v.throughput()) + "  density forward " + number(v.forward()) + " reverse "
                        + (Double.isNaN(v.reverse()) ? "-" : number(v.reverse())));
    }

    private static void contribution(StringBuilder out, SampleRecord.Contribution c) {
        boolean any = hasValue(c);
        out.append(String.format(
                Locale.ROOT,
                CONTRIBUTION,
                c.s(),
                c.t(),
                index(c.eyePath()),
                index(c.light()),
                any ? color(c.unweighted()) : "-",
                any ? number(c.weight()) : "-",
                any ? pair(c.filmX(), c.filmY()) : "-",
                c.outcome().text()));
    }

    private static String index(int number) {
        return number < 0 ? "-" : Integer.toString(number);
    }

    private static boolean hasValue(SampleRecord.Contribution c) {
        return switch (c.outcome()) {
            case ADDED, SPLATTED, OCCLUDED, ROULETTE -> true;
            default -> false;
        };
    }

    private SampleRecord.Color splatted() {
        SampleRecord.Color sum = SampleRecord.Color.BLACK;
        for (SampleRecord.Contribution c : record.contributions()) {
            if (c.outcome() == SampleRecord.Outcome.SPLATTED) {
                sum = sum.plus(c.unweighted().times(c.weight()));
            }
        }
        return sum;
    }

    private static void line(StringBuilder out, String text) {
        out.append(text).append(System.lineSeparator());
    }

    private static String pair(double x, double y) {
        return "(" + number(x) + ", " + number(y) + ")";
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.6g", value);
    }

    private static String vector(SampleRecord.Vector v) {
        return "(" + number(v.x()) + ", " + number(v.y()) + ", " + number(v.z()) + ")";
    }

    private static String color(SampleRecord.Color c) {
        return "(" + number(c.r()) + ", " + number(c.g()) + ", " + number(c.b()) + ")";
    }

    /** The same as one JSON object; numbers that are unknown or not finite are null. */
    String json() {
        SampleAddress address = request.address();
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("scene", scene);
        values.put("renderer", renderer);
        values.put("antialiasing", request.antialiasing().id());
        values.put("seed", address.seed());
        values.put("pixel", List.of(address.x(), address.y()));
        values.put("sample", address.sample());
        values.put("samplesPerPixel", request.samplesPerPixel());
        values.put("filmPosition", List.of(record.filmX(), record.filmY()));
        values.put("radiance", list(record.radiance()));
        List<Object> paths = new ArrayList<>();
        for (SampleRecord.Subpath path : record.subpaths()) {
            Map<String, Object> fields = new LinkedHashMap<>();
            fields.put("name", path.name());
            fields.put("vertices", path.vertices().stream().map(ReplayText::map).toList());
            paths.add(fields);
        }
        values.put("subpaths", paths);
        values.put(
                "contributions",
                record.contributions().stream().map(ReplayText::map).toList());
        values.put("rays", record.raysByKind());
        values.put("notes", record.notes());
        return JsonText.document(values);
    }

    private static Map<String, Object> map(SampleRecord.Vertex v) {
        Map<String, Object> fields = new LinkedHashMap<>();
        fields.put("name", v.name());
        fields.put("what", v.what());
        fields.put("position", list(v.position()));
        fields.put("normal", list(v.normal()));
        fields.put("delta", v.delta());
        fields.put("connectable", v.connectable());
        fields.put("throughput", list(v.throughput()));
        fields.put("densityForward", v.forward());
        fields.put("densityReverse", v.reverse());
        return fields;
    }

    private static Map<String, @Nullable Object> map(SampleRecord.Contribution c) {
        boolean any = hasValue(c);
        Map<String, @Nullable Object> fields = new LinkedHashMap<>();
        fields.put("s", c.s());
        fields.put("t", c.t());
        fields.put("eyePath", c.eyePath() < 0 ? null : c.eyePath());
        fields.put("light", c.light() < 0 ? null : c.light());
        fields.put("outcome", c.outcome().text());
        fields.put("unweighted", any ? list(c.unweighted()) : null);
        fields.put("weight", any ? c.weight() : null);
        fields.put("filmPosition", any ? List.of(c.filmX(), c.filmY()) : null);
        return fields;
    }

    private static List<Double> list(SampleRecord.Color c) {
        return List.of(c.r(), c.g(), c.b());
    }

    private static List<Double> list(SampleRecord.Vector v) {
        return List.of(v.x(), v.y(), v.z());
    }
}
