package org.daybreak.cli.partial;

import com.fasterxml.jackson.core.JsonFactory;
import com.fasterxml.jackson.core.JsonGenerator;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.EnumSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.daybreak.core.film.FilmLayer;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.FilmState;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.render.RenderPart;
import org.daybreak.core.render.RenderState;
import org.jspecify.annotations.Nullable;

/**
 * The header of a partial film: all but the large arrays, as JSON.
 *
 * @param json what it says
 * @param blocks the arrays that follow
 */
record PartialFilmHeader(JsonNode json, List<Block> blocks) {
    static final String SUMS = "sums";
    private static final String POSITION = "position.";
    private static final String SPLATS_TOTAL = "splats.total";
    private static final String SPLATS_LANE = "splats.lane.";
    private static final String SPLATS_OPEN = "splats.open";

    /**
     * An array.
     *
     * @param name what it is
     * @param count number of 64-bit numbers
     */
    record Block(String name, long count) {
        boolean isPosition() {
            return name.startsWith(POSITION);
        }

        /** The name within the position. */
        String key() {
            return name.substring(POSITION.length());
        }
    }

    /** The sums of splats by the names of their blocks, in order. */
    static Map<String, double[]> splatBlocks(FilmState film) {
        Map<String, double[]> blocks = new LinkedHashMap<>();
        double[] total = film.splats().total();
        if (total != null) {
            blocks.put(SPLATS_TOTAL, total);
        }
        for (FilmState.Lane lane : film.splats().lanes()) {
            blocks.put(SPLATS_LANE + lane.number(), lane.sums());
        }
        double[] open = film.splats().open();
        if (open != null) {
            blocks.put(SPLATS_OPEN, open);
        }
        return blocks;
    }

    static byte[] encode(PartialFilm partial) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        try (JsonGenerator json = new JsonFactory().createGenerator(bytes)) {
            RenderState state = partial.state();
            json.writeStartObject();
            json.writeObjectFieldStart("identity");
            for (Map.Entry<String, String> entry : partial.identity().entrySet()) {
                json.writeStringField(entry.getKey(), entry.getValue());
            }
            json.writeEndObject();
            json.writeNumberField("part", partial.part().index() + 1);
            json.writeNumberField("parts", partial.part().count());
            json.writeBooleanField("complete", state.complete());
            json.writeNumberField("samples", state.samples());
            json.writeNumberField("samplesPerPixel", state.samplesPerPixel());
            json.writeNumberField("seconds", state.seconds());
            json.writeNumberField("nonFiniteSamples", state.nonFiniteSamples());
            json.writeArrayFieldStart("nonFiniteAddresses");
            for (String address : state.nonFiniteAddresses()) {
                json.writeString(address);
            }
            json.writeEndArray();
            writeFilm(json, state.film());
            json.writeArrayFieldStart("blocks");
            for (Map.Entry<String, long[]> entry : state.position().entrySet()) {
                writeBlock(json, POSITION + entry.getKey(), entry.getValue().length);
            }
            writeBlock(json, SUMS, state.film().sums().length);
            for (Map.Entry<String, double[]> entry : splatBlocks(state.film()).entrySet()) {
                writeBlock(json, entry.getKey(), entry.getValue().length);
            }
            json.writeEndArray();
            json.writeEndObject();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return bytes.toByteArray();
    }

    private static void writeBlock(JsonGenerator json, String name, long count) throws IOException {
        json.writeStartObject();
        json.writeStringField("name", name);
        json.writeNumberField("count", count);
        json.writeEndObject();
    }

    private static void writeFilm(JsonGenerator json, FilmState film) throws IOException {
        FilmSettings settings = film.settings();
        json.writeObjectFieldStart("film");
        json.writeNumberField("width", settings.width());
        json.writeNumberField("height", settings.height());
        json.writeFieldName("crop");
        writeRectangle(json, settings.crop());
        json.writeObjectFieldStart("filter");
        json.writeStringField("kind", settings.filter().kind().id());
        json.writeNumberField("radius", settings.filter().radius());
        json.writeNumberField("parameter", settings.filter().parameter());
        json.writeEndObject();
        json.writeBooleanField("filterSampling", settings.filterSampling());
        json.writeArrayFieldStart("layers");
        for (FilmLayer layer : film.layers()) {
            json.writeString(layer.id());
        }
        json.writeEndArray();
        json.writeBooleanField("weighted", film.weighted());
        json.writeNumberField("samples", film.samples());
        json.writeNumberField("splatPaths", film.splatPaths());
        json.writeNumberField("splatScale", film.splatScale());
        FilmState.DependentSplats dependence = film.dependence();
        if (dependence != null) {
            json.writeObjectFieldStart("dependentSplats");
            if (Double.isFinite(dependence.scaleError())) {
                json.writeNumberField("scaleError", dependence.scaleError());
            }
            json.writeFieldName("lanePaths");
            json.writeArray(dependence.lanePaths(), 0, dependence.lanePaths().length);
            json.writeEndObject();
        }
        json.writeArrayFieldStart("regions");
        for (FilmSettings.Crop region : film.regions()) {
            writeRectangle(json, region);
        }
        json.writeEndArray();
        json.writeEndObject();
    }

    private static void writeRectangle(JsonGenerator json, FilmSettings.Crop crop) throws IOException {
        json.writeArray(new int[] {crop.x(), crop.y(), crop.width(), crop.height()}, 0, 4);
    }

    static PartialFilmHeader decode(byte[] bytes) throws IOException {
        JsonNode json = new ObjectMapper().readTree(bytes);
        List<Block> blocks = new ArrayList<>();
        for (JsonNode block : field(json, "blocks")) {
            long count = field(block, "count").asLong();
            if (count < 0 || count > Integer.MAX_VALUE) {
                throw new IllegalArgumentException("a block has " + count + " numbers");
            }
            blocks.add(new Block(field(block, "name").asText(), count));
        }
        return new PartialFilmHeader(json, List.copyOf(blocks));
    }

    /** Puts header and arrays together. */
    PartialFilm toFilm(Map<String, long[]> position, Map<String, double[]> arrays) {
        Map<String, String> identity = new LinkedHashMap<>();
        field(json, "identity")
                .properties()
                .forEach(e -> identity.put(e.getKey(), e.getValue().asText()));
        List<String> addresses = new ArrayList<>();
        field(json, "nonFiniteAddresses").forEach(address -> addresses.add(address.asText()));
        RenderState state = new RenderState(
                film(arrays),
                position,
                field(json, "samples").asLong(),
                field(json, "samplesPerPixel").asLong(),
                field(json, "complete").asBoolean(),
                field(json, "nonFiniteSamples").asLong(),
                addresses,
                field(json, "seconds").asDouble());
        RenderPart part = new RenderPart(
                field(json, "part").asInt() - 1, field(json, "parts").asInt());
        return new PartialFilm(identity, part, state);
    }

    private FilmState film(Map<String, double[]> arrays) {
        JsonNode film = field(json, "film");
        JsonNode filter = field(film, "filter");
        FilmSettings settings = new FilmSettings(
                field(film, "width").asInt(),
                field(film, "height").asInt(),
                rectangle(field(film, "crop")),
                new ReconstructionFilter(
                        kind(field(filter, "kind").asText()),
                        field(filter, "radius").asDouble(),
                        field(filter, "parameter").asDouble()),
                field(film, "filterSampling").asBoolean());
        Set<FilmLayer> layers = EnumSet.noneOf(FilmLayer.class);
        field(film, "layers").forEach(layer -> layers.add(layer(layer.asText())));
        List<FilmSettings.Crop> regions = new ArrayList<>();
        field(film, "regions").forEach(region -> regions.add(rectangle(region)));
        List<FilmState.Lane> lanes = new ArrayList<>();
        arrays.forEach((name, sums) -> {
            if (name.startsWith(SPLATS_LANE)) {
                lanes.add(new FilmState.Lane(Integer.parseInt(name.substring(SPLATS_LANE.length())), sums));
            }
        });
        double[] sums = arrays.get(SUMS);
        if (sums == null) {
            throw new IllegalArgumentException("there is no block '" + SUMS + "'");
        }
        return new FilmState(
                settings,
                layers,
                field(film, "weighted").asBoolean(),
                regions,
                sums,
                field(film, "samples").asLong(),
                FilmState.Splats.of(arrays.get(SPLATS_TOTAL), lanes, arrays.get(SPLATS_OPEN)),
                field(film, "splatPaths").asLong(),
                field(film, "splatScale").asDouble(),
                dependence(film));
    }

    private static FilmState.@Nullable DependentSplats dependence(JsonNode film) {
        JsonNode node = film.get("dependentSplats");
        if (node == null) {
            return null;
        }
        JsonNode paths = field(node, "lanePaths");
        long[] lanePaths = new long[paths.size()];
        for (int i = 0; i < lanePaths.length; i++) {
            lanePaths[i] = paths.get(i).asLong();
        }
        return new FilmState.DependentSplats(node.path("scaleError").asDouble(Double.NaN), lanePaths);
    }

    private static JsonNode field(JsonNode object, String name) {
        JsonNode value = object.get(name);
        if (value == null) {
            throw new IllegalArgumentException("the header has no '" + name + "'");
        }
        return value;
    }

    private static FilmSettings.Crop rectangle(JsonNode node) {
        if (node.size() != 4) {
            throw new IllegalArgumentException("a rectangle has " + node.size() + " numbers");
        }
        return new FilmSettings.Crop(
                node.get(0).asInt(),
                node.get(1).asInt(),
                node.get(2).asInt(),
                node.get(3).asInt());
    }

    private static ReconstructionFilter.Kind kind(String id) {
        for (ReconstructionFilter.Kind kind : ReconstructionFilter.Kind.values()) {
            if (kind.id().equals(id)) {
                return kind;
            }
        }
        throw new IllegalArgumentException("there is no filter '" + id + "'");
    }

    private static FilmLayer layer(String id) {
        for (FilmLayer layer : FilmLayer.values()) {
            if (layer.id().equals(id)) {
                return layer;
            }
        }
        throw new IllegalArgumentException("there is no layer '" + id + "'");
    }
}
