package org.daybreak.scenes.build;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.render.NearestName;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.jspecify.annotations.Nullable;

/**
 * The properties of one object, checked against its type's table. Whatever is wrong has been reported when the constructor
 * returns; wrong values count as not given, so that building goes on and finds what else is wrong.
 */
final class Properties {
    /** An object another one contains, and where it is put there. */
    record Child(ObjectDescription object, SourceLocation location) {}

    private final ObjectDescription object;
    private final PluginDefinition plugin;
    private final BuildContext context;
    private final Map<String, PropertyDescription> values = new HashMap<>();
    private final Map<String, Child> textures = new HashMap<>();
    private final Map<ObjectKind, List<Child>> children = new HashMap<>();

    /** Names that the file gives, rightly or wrongly: nothing is missing under them. */
    private final Set<String> mentioned = new HashSet<>();

    Properties(ObjectDescription object, PluginDefinition plugin, BuildContext context) {
        this.object = object;
        this.plugin = plugin;
        this.context = context;
        for (PropertyDescription property : object.properties()) {
            if (property.value() instanceof Value.Nested || property.value() instanceof Value.Reference) {
                addObject(property);
            } else {
                addValue(property);
            }
        }
        for (PropertyDefinition definition : plugin.properties()) {
            checkPresence(definition);
        }
    }

    ObjectDescription object() {
        return object;
    }

    SourceLocation location() {
        return object.location();
    }

    private void addValue(PropertyDescription property) {
        PropertyDefinition definition = definition(property.name());
        if (definition == null) {
            context.problems()
                    .unknownName(
                            property.location(),
                            object.label() + " has no property '" + property.name() + "'",
                            property.name(),
                            propertyNames());
            return;
        }
        if (!mentioned.add(property.name())) {
            context.error(property.location(), "'" + property.name() + "' is given twice");
            return;
        }
        if (property.value() instanceof Value.Invalid) {
            return;
        }
        String problem = problem(definition, property.value());
        if (problem == null) {
            values.put(property.name(), property);
        } else {
            context.error(
                    property.location(),
                    "'" + property.name() + "' of " + object.label() + " must be " + definition.values() + problem);
        }
    }

    private void addObject(PropertyDescription property) {
        ObjectDescription nested = context.object(property);
        if (nested == null) {
            // Reported; which property or kind was meant cannot be known.
            mentioned.add(property.name());
            for (PropertyDefinition definition : plugin.properties()) {
                if (property.name().isEmpty() && definition.type() == ValueType.OBJECT) {
                    mentioned.add(definition.name());
                }
            }
            return;
        }
        Child child = new Child(nested, property.location());
        PropertyDefinition byKind = null;
        for (PropertyDefinition definition : plugin.properties()) {
            if (definition.type() == ValueType.OBJECT && definition.kind() == nested.kind()) {
                byKind = definition;
            }
        }
        if (byKind != null) {
            children.computeIfAbsent(nested.kind(), k -> new ArrayList<>()).add(child);
        } else if (nested.kind() == ObjectKind.TEXTURE) {
            addTexture(property, child);
        } else {
            context.error(
                    property.location(), object.label() + " cannot contain " + BuildContext.article(nested.kind()));
        }
    }

    private void addTexture(PropertyDescription property, Child child) {
        String name = property.name();
        PropertyDefinition definition = definition(name);
        Set<String> textured = new TreeSet<>();
        for (PropertyDefinition d : plugin.properties()) {
            if (d.type().isTextured()) {
                textured.add(d.name());
            }
        }
        if (textured.isEmpty()) {
            context.error(property.location(), object.label() + " cannot contain a <texture>");
        } else if (name.isEmpty()) {
            context.error(
                    property.location(),
                    "a texture in " + object.label() + " needs a name: " + String.join(", ", textured));
        } else if (definition == null) {
            context.problems()
                    .unknownName(
                            property.location(), object.label() + " has no property '" + name + "'", name, textured);
        } else if (!mentioned.add(name)) {
            context.error(property.location(), "'" + name + "' is given twice");
        } else if (!textured.contains(name)) {
            context.error(
                    property.location(),
                    "'" + name + "' of " + object.label() + " must be " + definition.values() + " but is a texture");
        } else {
            textures.put(name, child);
        }
    }

    private void checkPresence(PropertyDefinition definition) {
        if (definition.type() == ValueType.OBJECT) {
            ObjectKind kind = definition.kind();
            int count = kind == null ? 0 : children(kind).size();
            if (count > definition.maximum()) {
                context.error(
                        children(kind).get((int) definition.maximum()).location(),
                        object.label() + " must contain " + definition.values());
            } else if (count < definition.minimum() && !mentioned.contains(definition.name())) {
                context.error(object.location(), object.label() + " must contain " + definition.values());
            }
        } else if (definition.required() && !mentioned.contains(definition.name())) {
            context.error(
                    object.location(),
                    object.label() + " needs the property '" + definition.name() + "', " + definition.values());
        }
    }

    private @Nullable PropertyDefinition definition(String name) {
        for (PropertyDefinition definition : plugin.properties()) {
            if (definition.type() != ValueType.OBJECT && definition.name().equals(name)) {
                return definition;
            }
        }
        return null;
    }

    private List<String> propertyNames() {
        return plugin.properties().stream()
                .filter(d -> d.type() != ValueType.OBJECT)
                .map(PropertyDefinition::name)
                .toList();
    }

    /** What is wrong with a value, as the end of a sentence; null if nothing is. */
    private static @Nullable String problem(PropertyDefinition definition, Value value) {
        return switch (definition.type()) {
            case INTEGER ->
                value instanceof Value.WholeNumber n
                        ? outside(definition, (double) n.value(), Long.toString(n.value()))
                        : wrongType(value);
            case FLOAT -> {
                Double n = LinearColors.number(value);
                yield n == null ? wrongType(value) : outside(definition, n, n.toString());
            }
            case BOOLEAN -> value instanceof Value.Switch ? null : wrongType(value);
            case STRING -> value instanceof Value.Text ? null : wrongType(value);
            case FILE ->
                value instanceof Value.Text t
                        ? (t.value().isBlank() ? " but is empty" : null)
                        : value instanceof Value.Content ? null : wrongType(value);
            case MESH -> value instanceof Value.Mesh ? null : wrongType(value);
            case CHOICE -> {
                if (!(value instanceof Value.Text text)) {
                    yield wrongType(value);
                }
                String word = text.value().toLowerCase(Locale.ROOT);
                yield definition.choices().contains(word)
                        ? null
                        : " but is '" + text.value() + "'; did you mean '"
                                + NearestName.of(word, definition.choices(), 1).get(0) + "'?";
            }
            case POINT -> value instanceof Value.Triple ? null : wrongType(value);
            case REFRACTIVE_INDEX -> refractiveIndexProblem(value);
            case COLOR -> colorProblem(value, definition.type(), definition.minimum(), definition.maximum());
            case REFLECTANCE -> colorProblem(value, definition.type(), 0, 1);
            case TEXTURED_NUMBER -> colorProblem(value, definition.type(), definition.minimum(), definition.maximum());
            case EMISSION, TEXTURED_EMISSION -> colorProblem(value, definition.type(), 0, Double.POSITIVE_INFINITY);
            case TRANSFORM -> value instanceof Value.Transform t ? Affine.problem(t.matrix()) : wrongType(value);
            case OBJECT -> wrongType(value);
        };
    }

    private static String wrongType(Value value) {
        return " but is " + value.description();
    }

    private static @Nullable String outside(PropertyDefinition definition, double value, String text) {
        return value >= definition.minimum() && value <= definition.maximum() ? null : " but is " + text;
    }

    private static @Nullable String refractiveIndexProblem(Value value) {
        if (value instanceof Value.Text text) {
            return RefractiveIndices.of(text.value()).isPresent()
                    ? null
                    : " but '" + text.value() + "' is not known; did you mean '"
                            + NearestName.of(text.value(), RefractiveIndices.names(), 1)
                                    .get(0) + "'?";
        }
        Double n = LinearColors.number(value);
        return n == null ? wrongType(value) : n > 0 ? null : " but is " + n;
    }

    private static @Nullable String colorProblem(Value value, ValueType type, double minimum, double maximum) {
        double[] rgb = LinearColors.of(value, type);
        if (rgb == null) {
            return wrongType(value);
        }
        for (double component : rgb) {
            if (!(component >= minimum && component <= maximum)) {
                return " but contains " + component;
            }
        }
        return null;
    }

    /** True if the file gives a property and its value is right. */
    boolean has(String name) {
        return values.containsKey(name) || textures.containsKey(name);
    }

    /** True if the file gives a property, right or wrong. */
    boolean mentions(String name) {
        return mentioned.contains(name);
    }

    /** Where a property is, or the object if it is not given. */
    SourceLocation location(String name) {
        Child texture = textures.get(name);
        PropertyDescription value = values.get(name);
        return texture != null ? texture.location() : value != null ? value.location() : object.location();
    }

    /** A number, or its default. */
    double number(String name) {
        PropertyDescription property = values.get(name);
        Double given = property == null ? null : LinearColors.number(property.value());
        return given == null ? Double.parseDouble(defaultText(name)) : given;
    }

    /** A number, or something else if it is not given. */
    double number(String name, double otherwise) {
        return has(name) ? number(name) : otherwise;
    }

    /** A whole number, or its default. */
    int integer(String name) {
        return (int) number(name);
    }

    /** A switch, or its default. */
    boolean truth(String name) {
        PropertyDescription property = values.get(name);
        if (property != null && property.value() instanceof Value.Switch s) {
            return s.value();
        }
        return Boolean.parseBoolean(defaultText(name));
    }

    /** A text, or its default; words out of several are in lower case. */
    String text(String name) {
        PropertyDescription property = values.get(name);
        if (property == null || !(property.value() instanceof Value.Text text)) {
            return defaultText(name);
        }
        PropertyDefinition definition = definition(name);
        boolean choice = definition != null && definition.type() == ValueType.CHOICE;
        return choice ? text.value().toLowerCase(Locale.ROOT) : text.value();
    }

    /** A file that the scene's file contains, or null if the property is not given or names a file. */
    Value.@Nullable Content content(String name) {
        PropertyDescription property = values.get(name);
        return property != null && property.value() instanceof Value.Content content ? content : null;
    }

    /** A mesh in memory, or null if it is not given. */
    @Nullable
    TriangleMesh mesh(String name) {
        PropertyDescription property = values.get(name);
        return property != null && property.value() instanceof Value.Mesh mesh ? mesh.mesh() : null;
    }

    /** A point, or its default. */
    Point3d point(String name) {
        PropertyDescription property = values.get(name);
        if (property != null && property.value() instanceof Value.Triple t) {
            return new Point3d(t.x(), t.y(), t.z());
        }
        String[] words = defaultText(name).split(", ", -1);
        return new Point3d(Double.parseDouble(words[0]), Double.parseDouble(words[1]), Double.parseDouble(words[2]));
    }

    /** A refractive index, or its default. */
    double refractiveIndex(String name) {
        PropertyDescription property = values.get(name);
        Double given = property == null ? null : LinearColors.number(property.value());
        return given == null ? RefractiveIndices.of(text(name)).orElseThrow() : given;
    }

    /** A transform, or the identity. */
    Matrix4d transform(String name) {
        PropertyDescription property = values.get(name);
        if (property != null && property.value() instanceof Value.Transform t) {
            return t.matrix();
        }
        Matrix4d identity = new Matrix4d();
        identity.setIdentity();
        return identity;
    }

    /** A colour as linear RGB, or its default. */
    double[] color(String name) {
        PropertyDefinition definition = definition(name);
        PropertyDescription property = values.get(name);
        double[] given =
                property == null || definition == null ? null : LinearColors.of(property.value(), definition.type());
        if (given != null) {
            return given;
        }
        double grey = Double.parseDouble(defaultText(name));
        return new double[] {grey, grey, grey};
    }

    /** The texture given for a property, or null if it is a colour or not given. */
    @Nullable
    Child texture(String name) {
        return textures.get(name);
    }

    /** What the values of a textured property must not exceed. */
    double textureLimit(String name) {
        PropertyDefinition definition = definition(name);
        if (definition == null || definition.type() == ValueType.TEXTURED_EMISSION) {
            return Double.POSITIVE_INFINITY;
        }
        return definition.type() == ValueType.TEXTURED_NUMBER ? definition.maximum() : 1;
    }

    /** The contained objects of a kind. */
    List<Child> children(@Nullable ObjectKind kind) {
        return children.getOrDefault(kind, List.of());
    }

    /** The only object of a kind, or null. */
    @Nullable
    Child child(ObjectKind kind) {
        List<Child> all = children(kind);
        return all.isEmpty() ? null : all.get(0);
    }

    private String defaultText(String name) {
        PropertyDefinition definition = definition(name);
        String text = definition == null ? null : definition.defaultValue();
        if (text == null) {
            throw new IllegalArgumentException(object.label() + ": '" + name + "' has no default");
        }
        return text;
    }
}
