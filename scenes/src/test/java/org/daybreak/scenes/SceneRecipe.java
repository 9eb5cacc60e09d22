package org.daybreak.scenes;

import static java.util.stream.Collectors.groupingBy;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.daybreak.scenes.build.PluginDefinition;
import org.daybreak.scenes.build.PropertyDefinition;
import org.daybreak.scenes.build.ValueType;
import org.daybreak.scenes.description.ObjectKind;

/**
 * Turns arbitrary bytes into a well-formed scene of known objects with known properties, from the table that the reader
 * checks files against, so that they reach what makes objects of descriptions. Each byte takes one decision; values are
 * mostly those at the ends of what is admissible.
 */
final class SceneRecipe {
    private static final Map<ObjectKind, List<PluginDefinition>> TYPES =
            InputFormats.plugins().stream().collect(groupingBy(PluginDefinition::kind));
    /** What makes large tables when it is built; chosen less often, and at most once in a scene. */
    private static final Set<String> SLOW = Set.of("plastic", "roughplastic", "sunsky", "sky");

    private static final int MOST_LEVELS = 6;
    private static final int MOST_OBJECTS = 12;
    private static final int MOST_PROPERTIES = 4;

    private static final List<String> NUMBERS = List.of(
            "1",
            "0",
            "0.5",
            "-1",
            "2",
            "16",
            "90",
            "-0.0",
            "1e-9",
            "1e9",
            "1e-300",
            "1e300",
            "4.9e-324",
            "1.7976931348623157e308",
            "2147483647",
            "-2147483648",
            "9223372036854775807");
    private static final List<String> WORDS = List.of(
            "Au", "Cu", "none", "bk7", "diamond", "vertex_color", "all", "r", "opacity", "repeat", "x", "", "1", "$n");
    private static final List<String> FILES =
            List.of("m.obj", "i.png", "c.txt", "l.ies", "none.ply", "", "../m.obj", "scene.xml");
    private static final List<String> SPECTRA = List.of(
            "1",
            "0.5",
            "400:0.1, 700:0.9",
            "400:1e300, 500:1e300",
            "300:0, 900:1",
            "500:1",
            "-1",
            "0",
            "1e-300",
            "1e308");
    /** What numbers may be, by the identity of the property. */
    private static final Map<PropertyDefinition, List<String>> RANGES = ranges();

    private final byte[] recipe;
    private final StringBuilder out = new StringBuilder();
    private int at;
    private int objects;
    private final Set<String> slow = new HashSet<>();

    private SceneRecipe(byte[] recipe) {
        this.recipe = recipe;
    }

    /** The scene for a recipe; bytes that are missing are zero. */
    static String text(byte[] recipe) {
        return new SceneRecipe(recipe).scene();
    }

    private int next() {
        return at < recipe.length ? recipe[at++] & 0xff : 0;
    }

    private <T> T one(List<T> list) {
        return list.get(next() % list.size());
    }

    private String number() {
        return one(NUMBERS);
    }

    private String scene() {
        out.append("<scene version='")
                .append(next() % 8 == 7 ? "0.6.0" : "3.0.0")
                .append("'>\n");
        PluginDefinition root = TYPES.get(ObjectKind.SCENE).get(0);
        while (at < recipe.length && objects < MOST_OBJECTS) {
            property(one(root.properties()), 0);
        }
        return out.append("</scene>\n").toString();
    }

    private void object(ObjectKind kind, String name, int level) {
        if (level == MOST_LEVELS || objects == MOST_OBJECTS) {
            return;
        }
        int choice = next();
        if (choice >= 0xf0) {
            out.append("<ref name='")
                    .append(name)
                    .append("' id='o")
                    .append(choice & 0xf)
                    .append("'/>");
            return;
        }
        PluginDefinition plugin = TYPES.get(kind).get(choice % TYPES.get(kind).size());
        if (SLOW.contains(plugin.type()) && (next() % 32 != 31 || !slow.add(plugin.type()))) {
            plugin = TYPES.get(kind).get(0);
        }
        out.append('<')
                .append(kind.element())
                .append(" type='")
                .append(plugin.type())
                .append("' name='")
                .append(name);
        if (next() % 4 == 0) {
            out.append("' id='o").append(objects);
        }
        out.append("'>\n");
        objects++;
        for (PropertyDefinition property : plugin.properties()) {
            int least = property.type() == ValueType.OBJECT ? (int) property.minimum() : property.required() ? 1 : 0;
            for (int i = 0; i < least && next() != 0xff; i++) {
                property(property, level + 1);
            }
        }
        int count = next() % MOST_PROPERTIES;
        for (int i = 0; i < count && !plugin.properties().isEmpty(); i++) {
            property(one(plugin.properties()), level + 1);
        }
        out.append("</").append(kind.element()).append(">\n");
    }

    private void property(PropertyDefinition p, int level) {
        String name = p.name();
        ObjectKind kind = p.kind();
        switch (p.type()) {
            case OBJECT -> {
                if (kind != null) {
                    object(kind, "", level);
                }
            }
            case REFLECTANCE, TEXTURED_NUMBER, TEXTURED_EMISSION -> {
                if (next() % 3 == 0) {
                    object(ObjectKind.TEXTURE, name, level);
                } else {
                    color(name);
                }
            }
            case COLOR, EMISSION -> color(name);
            case INTEGER -> leaf("integer", name, inRange(p));
            case FLOAT -> leaf("float", name, inRange(p));
            case BOOLEAN -> leaf("boolean", name, next() % 2 == 0 ? "true" : "false");
            case CHOICE -> leaf("string", name, next() == 0xff ? one(WORDS) : one(p.choices()));
            case STRING -> leaf("string", name, one(WORDS));
            case FILE -> leaf("string", name, one(FILES));
            case REFRACTIVE_INDEX -> {
                if (next() % 2 == 0) {
                    leaf("float", name, number());
                } else {
                    leaf("string", name, one(WORDS));
                }
            }
            case POINT -> leaf("point", name, number() + ", " + number() + ", " + number());
            case TRANSFORM -> transform(name);
            case MESH -> {
                // Has no form in files.
            }
        }
    }

    private void leaf(String element, String name, String value) {
        out.append('<')
                .append(element)
                .append(" name='")
                .append(name)
                .append("' value='")
                .append(value)
                .append("'/>\n");
    }

    /** The default, an end of the range, or any number. */
    private String inRange(PropertyDefinition p) {
        return one(RANGES.getOrDefault(p, NUMBERS));
    }

    private static Map<PropertyDefinition, List<String>> ranges() {
        Map<PropertyDefinition, List<String>> ranges = new IdentityHashMap<>();
        for (PluginDefinition plugin : InputFormats.plugins()) {
            for (PropertyDefinition p : plugin.properties()) {
                List<String> values = new ArrayList<>(NUMBERS);
                String otherwise = p.defaultValue();
                if (otherwise != null) {
                    values.add(otherwise);
                }
                for (double end : new double[] {p.minimum(), p.maximum()}) {
                    if (Double.isFinite(end)) {
                        values.add(p.type() == ValueType.INTEGER ? Long.toString((long) end) : Double.toString(end));
                    }
                }
                ranges.put(p, values);
            }
        }
        return ranges;
    }

    private void color(String name) {
        // Spectra are integrated, which takes as long as all the rest of a scene.
        switch (next() % 16) {
            case 0, 1, 2, 3, 4, 5 -> leaf("rgb", name, number() + ", " + number() + ", " + number());
            case 6, 7, 8, 9, 10 -> leaf("float", name, number());
            case 11, 12, 13 -> leaf("srgb", name, "#80ff00");
            case 14 -> leaf("spectrum", name, one(SPECTRA));
            default ->
                out.append("<blackbody name='")
                        .append(name)
                        .append("' temperature='")
                        .append(number())
                        .append("' scale='")
                        .append(number())
                        .append("'/>\n");
        }
    }

    private void transform(String name) {
        out.append("<transform name='").append(name).append("'>");
        int parts = 1 + next() % 3;
        for (int i = 0; i < parts; i++) {
            switch (next() % 5) {
                case 0 -> out.append("<translate value='").append(number()).append("'/>");
                case 1 ->
                    out.append("<scale x='")
                            .append(number())
                            .append("' y='")
                            .append(number())
                            .append("'/>");
                case 2 ->
                    out.append("<rotate z='")
                            .append(number())
                            .append("' angle='")
                            .append(number())
                            .append("'/>");
                case 3 ->
                    out.append("<lookat origin='0, 1, ")
                            .append(number())
                            .append("' target='0, ")
                            .append(number())
                            .append(", 0' up='0, 1, 0'/>");
                default -> {
                    out.append("<matrix value='");
                    for (int k = 0; k < 9; k++) {
                        out.append(number()).append(' ');
                    }
                    out.append("'/>");
                }
            }
        }
        out.append("</transform>\n");
    }
}
