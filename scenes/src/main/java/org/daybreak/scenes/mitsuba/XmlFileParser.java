package org.daybreak.scenes.mitsuba;

import java.io.StringReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import javax.vecmath.Matrix4d;
import javax.xml.stream.Location;
import javax.xml.stream.XMLInputFactory;
import javax.xml.stream.XMLStreamConstants;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamReader;
import org.daybreak.core.render.NearestName;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.daybreak.scenes.mitsuba.Numbers.FormatException;
import org.jspecify.annotations.Nullable;

/** Parses one XML file. */
final class XmlFileParser {
    private static final int ELEMENT_DEPTH = 64;
    private static final Pattern VERSION = Pattern.compile("\\d{1,5}\\.\\d{1,5}\\.\\d{1,5}");
    private static final Pattern NAME = Pattern.compile("[\\p{L}\\p{N}_]+");

    private final MitsubaReader reader;
    private final ProblemList problems;
    private final Path file;
    private final String text;
    private final StartTagLocator locator;
    private final XMLStreamReader xml;
    private int depth;

    /** Whether the file is in the dialect of Mitsuba 0.6. Included files that give no version are in that of the including. */
    private boolean old;

    /** Whether the last tag had an attribute that could not be substituted, which has been reported. */
    private boolean tainted;

    private XmlFileParser(MitsubaReader reader, Path file, String text, boolean old) throws XMLStreamException {
        this.old = old;
        this.reader = reader;
        this.problems = reader.problems();
        this.file = file;
        this.text = text;
        this.locator = new StartTagLocator(text);
        this.xml = open(text);
    }

    private static XMLStreamReader open(String text) throws XMLStreamException {
        XMLInputFactory factory = XMLInputFactory.newDefaultFactory();
        factory.setProperty(XMLInputFactory.SUPPORT_DTD, false);
        factory.setProperty(XMLInputFactory.IS_SUPPORTING_EXTERNAL_ENTITIES, false);
        factory.setProperty(XMLInputFactory.IS_NAMESPACE_AWARE, false);
        // A byte order mark has gone with the decoding, and the declared encoding no longer matters.
        return factory.createXMLStreamReader(new StringReader(text));
    }

    /**
     * Parses a file: its root as a single nested object, or an included scene's content.
     *
     * @param main true for the scene's main file, whose root must be a scene
     * @param old whether the file is in the dialect of Mitsuba 0.6 if it does not say
     */
    static List<PropertyDescription> parse(MitsubaReader reader, Path file, String text, boolean main, boolean old) {
        try {
            return new XmlFileParser(reader, file, text, old).parse(main);
        } catch (XMLStreamException e) {
            reader.setBroken();
            Location at = e.getLocation();
            SourceLocation location = at == null
                    ? SourceLocation.of(file)
                    : new SourceLocation(file, at.getLineNumber(), at.getColumnNumber());
            reader.problems().error(location, "the XML is not well-formed: " + reason(e));
            return List.of();
        } catch (StopException e) {
            reader.setBroken();
            reader.problems().error(e.location, String.valueOf(e.getMessage()));
            return List.of();
        }
    }

    private List<PropertyDescription> parse(boolean main) throws XMLStreamException {
        List<PropertyDescription> result = parseRoot(main);
        while (xml.hasNext()) {
            checkEvent(xml.next());
        }
        return result;
    }

    /** The file cannot be parsed further. */
    private static final class StopException extends RuntimeException {
        private static final long serialVersionUID = 1L;

        private final transient SourceLocation location;

        StopException(SourceLocation location, String message) {
            super(message);
            this.location = location;
        }
    }

    private static String reason(XMLStreamException e) {
        String message = String.valueOf(e.getMessage());
        int start = message.indexOf("Message: ");
        return (start < 0 ? message : message.substring(start + 9))
                .replaceAll("\\s+", " ")
                .strip();
    }

    private List<PropertyDescription> parseRoot(boolean main) throws XMLStreamException {
        int event = xml.getEventType();
        while (event != XMLStreamConstants.START_ELEMENT) {
            event = checkEvent(xml.next());
        }
        SourceLocation location = enter();
        String element = xml.getLocalName();
        ObjectKind kind = kind(element);
        if (kind == null || (main && kind != ObjectKind.SCENE)) {
            throw new StopException(location, "the root of a scene file must be <scene> but is <" + element + ">");
        }
        Map<String, String> attributes = attributes(location);
        checkVersion(attributes.remove("version"), location, !main);
        ObjectDescription root = readObject(kind, attributes, location);
        if (root == null) {
            return List.of();
        }
        if (kind == ObjectKind.SCENE && !main) {
            return root.properties();
        }
        return List.of(new PropertyDescription("", new Value.Nested(root), location));
    }

    private void checkVersion(@Nullable String version, SourceLocation location, boolean included) {
        if (version == null) {
            if (!included) {
                old = OldDialect.isLikely(text);
                problems.warning(
                        location,
                        "the root element has no attribute 'version'; " + (old ? "0.6.0" : "3.0.0") + " is assumed");
            }
        } else if (!VERSION.matcher(version).matches()) {
            problems.error(location, "the version '" + Numbers.shortened(version) + "' is not of the form 3.0.0");
        } else {
            old = version.startsWith("0.") || version.startsWith("1.");
        }
    }

    /** Notes a start tag and returns where it is. */
    private SourceLocation enter() {
        locator.advance();
        SourceLocation location = new SourceLocation(file, locator.line(), locator.column());
        if (++depth > ELEMENT_DEPTH) {
            throw new StopException(location, "elements are nested more than " + ELEMENT_DEPTH + " levels deep");
        }
        return location;
    }

    /** Refuses events that a scene file must not have; returns the event. */
    private int checkEvent(int event) {
        switch (event) {
            case XMLStreamConstants.DTD -> {
                int at = Math.max(0, text.indexOf("<!DOCTYPE"));
                int line = 1
                        + (int) text.substring(0, at)
                                .chars()
                                .filter(c -> c == '\n')
                                .count();
                int column = at - text.lastIndexOf('\n', Math.max(0, at - 1));
                throw new StopException(
                        new SourceLocation(file, line, at == 0 ? 1 : column),
                        "a document type (DOCTYPE) is not allowed");
            }
            case XMLStreamConstants.ENTITY_REFERENCE -> throw new StopException(here(), "an entity is not allowed");
            case XMLStreamConstants.CHARACTERS, XMLStreamConstants.CDATA -> {
                String content = xml.getText().strip();
                if (!content.isEmpty()) {
                    problems.error(here(), "unexpected text '" + Numbers.shortened(content) + "'");
                }
            }
            case XMLStreamConstants.END_ELEMENT -> depth--;
            default -> {
                return event;
            }
        }
        return event;
    }

    private SourceLocation here() {
        Location at = xml.getLocation();
        return new SourceLocation(file, Math.max(1, at.getLineNumber()), 0);
    }

    private Map<String, String> attributes(SourceLocation location) {
        Map<String, String> attributes = new LinkedHashMap<>();
        tainted = false;
        for (int i = 0; i < xml.getAttributeCount(); i++) {
            String value = reader.definitions().substitute(xml.getAttributeValue(i), location, problems);
            tainted |= value == null;
            attributes.put(xml.getAttributeLocalName(i), value == null ? "" : value);
        }
        return attributes;
    }

    /** Reports attributes that the element does not have and required ones that are missing; true if all required are there. */
    private boolean check(
            String element,
            Map<String, String> attributes,
            SourceLocation location,
            List<String> required,
            List<String> optional) {
        for (String name : attributes.keySet()) {
            if (!required.contains(name) && !optional.contains(name)) {
                Set<String> known = new TreeSet<>(required);
                known.addAll(optional);
                problems.unknownName(location, "<" + element + "> has no attribute '" + name + "'", name, known);
            }
        }
        boolean complete = true;
        for (String name : required) {
            if (!attributes.containsKey(name)) {
                problems.error(location, "<" + element + "> needs the attribute '" + name + "'");
                complete = false;
            }
        }
        return complete;
    }

    /** Reads an object up to its end tag; null if it has no type, which is reported. */
    private @Nullable ObjectDescription readObject(
            ObjectKind kind, Map<String, String> attributes, SourceLocation location) throws XMLStreamException {
        boolean scene = kind == ObjectKind.SCENE;
        if (tainted) {
            // Neither type nor name of the object can be relied on.
            reader.setBroken();
        }
        check(kind.element(), attributes, location, scene ? List.of() : List.of("type"), List.of("type", "id", "name"));
        List<PropertyDescription> properties = new ArrayList<>();
        while (true) {
            int event = checkEvent(xml.next());
            if (event == XMLStreamConstants.END_ELEMENT) {
                break;
            }
            if (event == XMLStreamConstants.START_ELEMENT) {
                readMember(kind, properties);
            }
        }
        String type = scene ? "scene" : attributes.get("type");
        if (type == null) {
            reader.setBroken();
            return null;
        }
        String id = attributes.get("id");
        ObjectDescription object = new ObjectDescription(kind, type, id, location, properties);
        if (old) {
            object = OldDialect.translate(object, problems);
        }
        if (id != null) {
            reader.addId(id, object, location);
        }
        return object;
    }

    private void readMember(ObjectKind owner, List<PropertyDescription> properties) throws XMLStreamException {
        SourceLocation location = enter();
        String element = xml.getLocalName();
        Map<String, String> attributes = attributes(location);
        ObjectKind kind = kind(element);
        if (kind == ObjectKind.SCENE) {
            problems.error(location, "<scene> can only be the root of a file");
            skip(false);
        } else if (kind != null) {
            String name = attributes.getOrDefault("name", "");
            ObjectDescription object = readObject(kind, attributes, location);
            if (object != null) {
                properties.add(new PropertyDescription(name, new Value.Nested(object), location));
            }
        } else if (element.equals("transform")) {
            readTransform(attributes, location, properties);
        } else if (element.equals("spectrum") && attributes.containsKey("type")) {
            readSpectrumObject(attributes, location, properties);
        } else {
            readLeaf(element, owner, attributes, location, properties);
        }
    }

    /** The kind of object that an element stands for, or null. */
    private @Nullable ObjectKind kind(String element) {
        ObjectKind kind = MitsubaReader.kind(element);
        return kind == null && old ? OldDialect.kind(element) : kind;
    }

    /** Reads a spectrum that is written as an object: {@code <spectrum type="blackbody">}. */
    private void readSpectrumObject(
            Map<String, String> attributes, SourceLocation location, List<PropertyDescription> properties)
            throws XMLStreamException {
        boolean sound = !tainted;
        check("spectrum", attributes, location, List.of("name", "type"), List.of("id"));
        List<PropertyDescription> own = new ArrayList<>();
        while (true) {
            int event = checkEvent(xml.next());
            if (event == XMLStreamConstants.END_ELEMENT) {
                break;
            }
            if (event == XMLStreamConstants.START_ELEMENT) {
                readMember(ObjectKind.TEXTURE, own);
            }
        }
        if (sound) {
            add(
                    properties,
                    attributes,
                    location,
                    () -> Spectra.ofObject(attributes.getOrDefault("type", ""), own, reader));
        } else {
            addInvalid(properties, attributes, location);
        }
    }

    private void readLeaf(
            String element,
            ObjectKind owner,
            Map<String, String> attributes,
            SourceLocation location,
            List<PropertyDescription> properties)
            throws XMLStreamException {
        if (tainted) {
            boolean value =
                    !List.of("ref", "include", "default", "alias", "path").contains(element);
            if (value && !attributes.getOrDefault("name", "").isEmpty()) {
                addInvalid(properties, attributes, location);
            } else {
                reader.setBroken();
            }
            skip(false);
            return;
        }
        switch (element) {
            case "rgb", "srgb" -> {
                if (check(element, attributes, location, List.of("name", "value"), List.of("intent"))) {
                    add(
                            properties,
                            attributes,
                            location,
                            () -> simpleValue(element, attributes.getOrDefault("value", "")));
                } else {
                    addInvalid(properties, attributes, location);
                }
            }
            case "spectrum" -> {
                check(element, attributes, location, List.of("name"), List.of("value", "filename", "intent"));
                add(properties, attributes, location, () -> Spectra.ofAttributes(attributes, location, reader, old));
            }
            case "blackbody" -> {
                if (check(element, attributes, location, List.of("name", "temperature"), List.of("scale"))) {
                    add(properties, attributes, location, () -> Spectra.blackbody(attributes));
                } else {
                    addInvalid(properties, attributes, location);
                }
            }
            case "boolean", "integer", "float", "string" -> {
                if (check(element, attributes, location, List.of("name", "value"), List.of())) {
                    add(
                            properties,
                            attributes,
                            location,
                            () -> simpleValue(element, attributes.getOrDefault("value", "")));
                } else {
                    addInvalid(properties, attributes, location);
                }
            }
            case "point", "vector" -> {
                if (check(element, attributes, location, List.of("name"), List.of("value", "x", "y", "z"))) {
                    add(properties, attributes, location, () -> Coordinates.triple(element, attributes));
                }
            }
            case "ref" -> {
                if (check(element, attributes, location, List.of("id"), List.of("name"))) {
                    properties.add(new PropertyDescription(
                            attributes.getOrDefault("name", ""),
                            new Value.Reference(attributes.getOrDefault("id", "")),
                            location));
                }
            }
            case "include" -> {
                if (check(element, attributes, location, List.of("filename"), List.of("name"))) {
                    properties.addAll(reader.include(attributes.getOrDefault("filename", ""), location, old));
                }
            }
            case "default" -> {
                if (check(element, attributes, location, List.of("name", "value"), List.of())) {
                    readDefault(attributes.getOrDefault("name", ""), attributes.getOrDefault("value", ""), location);
                }
            }
            case "alias" -> {
                if (check(element, attributes, location, List.of("id", "as"), List.of())) {
                    reader.addAlias(attributes.getOrDefault("id", ""), attributes.getOrDefault("as", ""), location);
                }
            }
            case "path" -> {
                if (owner != ObjectKind.SCENE) {
                    problems.error(location, "<path> can only stand directly in <scene>");
                } else if (check(element, attributes, location, List.of("value"), List.of())) {
                    reader.addFolder(attributes.getOrDefault("value", ""), location);
                }
            }
            case "translate", "rotate", "scale", "lookat", "lookAt", "matrix" ->
                problems.error(location, "<" + element + "> can only stand in <transform>");
            default -> {
                if (Elements.UNSUPPORTED.containsKey(element)) {
                    problems.error(
                            location, "<" + element + ">: " + Elements.UNSUPPORTED.get(element) + " are not supported");
                } else {
                    problems.unknownName(location, "unknown element <" + element + ">", element, Elements.KNOWN);
                }
                skip(false);
                return;
            }
        }
        skip(true);
    }

    private void readDefault(String name, String value, SourceLocation location) {
        if (NAME.matcher(name).matches()) {
            reader.definitions().addDefault(name, value);
        } else {
            problems.error(
                    location, "'" + Numbers.shortened(name) + "' cannot be used as $name: letters, digits and _ only");
        }
    }

    /** Skips to the end of an element. Elements in it are an error, reported once if asked to. */
    private void skip(boolean report) throws XMLStreamException {
        int outer = depth - 1;
        boolean reported = !report;
        while (depth > outer) {
            if (checkEvent(xml.next()) == XMLStreamConstants.START_ELEMENT) {
                SourceLocation location = enter();
                if (!reported && depth == outer + 2) {
                    problems.error(location, "unexpected element <" + xml.getLocalName() + ">");
                    reported = true;
                }
            }
        }
    }

    /** A value that may not be as it should. */
    private interface Parsed {
        Value get() throws FormatException;
    }

    private void add(
            List<PropertyDescription> properties,
            Map<String, String> attributes,
            SourceLocation location,
            Parsed parsed) {
        try {
            properties.add(new PropertyDescription(attributes.getOrDefault("name", ""), parsed.get(), location));
        } catch (FormatException e) {
            problems.error(location, named(attributes) + e.getMessage());
            addInvalid(properties, attributes, location);
        }
    }

    private static String named(Map<String, String> attributes) {
        String name = attributes.get("name");
        return name == null ? "" : "'" + name + "': ";
    }

    private static void addInvalid(
            List<PropertyDescription> properties, Map<String, String> attributes, SourceLocation location) {
        String name = attributes.get("name");
        if (name != null) {
            properties.add(new PropertyDescription(name, new Value.Invalid(), location));
        }
    }

    private static Value simpleValue(String element, String value) throws FormatException {
        return switch (element) {
            case "boolean" -> new Value.Switch(Numbers.truth(value));
            case "integer" -> new Value.WholeNumber(Numbers.whole(value));
            case "float" -> new Value.RealNumber(Numbers.real(value));
            case "string" -> new Value.Text(value);
            case "rgb" -> Numbers.linearColor(value);
            default -> Numbers.encodedColor(value);
        };
    }

    /** Reads a transform; its parts apply in their order, so each new one multiplies from the left. */
    private void readTransform(
            Map<String, String> attributes, SourceLocation location, List<PropertyDescription> properties)
            throws XMLStreamException {
        boolean valid = check("transform", attributes, location, List.of("name"), List.of());
        Matrix4d product = Transforms.identity();
        while (true) {
            int event = checkEvent(xml.next());
            if (event == XMLStreamConstants.END_ELEMENT) {
                break;
            }
            if (event == XMLStreamConstants.START_ELEMENT) {
                SourceLocation partLocation = enter();
                try {
                    Matrix4d part = readPart(partLocation);
                    valid &= !tainted;
                    product.mul(part, new Matrix4d(product));
                } catch (FormatException e) {
                    problems.error(partLocation, String.valueOf(e.getMessage()));
                    valid = false;
                }
                skip(true);
            }
        }
        if (valid) {
            properties.add(new PropertyDescription(
                    attributes.getOrDefault("name", ""), new Value.Transform(product), location));
        } else {
            addInvalid(properties, attributes, location);
        }
    }

    private Matrix4d readPart(SourceLocation location) throws FormatException {
        String element = xml.getLocalName();
        Map<String, String> a = attributes(location);
        if (tainted) {
            return Transforms.identity();
        }
        List<String> coordinates = List.of("value", "x", "y", "z");
        switch (element) {
            case "translate" -> {
                check(element, a, location, List.of(), coordinates);
                double[] t = Coordinates.of(a, 0);
                return Transforms.translation(t[0], t[1], t[2]);
            }
            case "scale" -> {
                check(element, a, location, List.of(), coordinates);
                double[] s = Coordinates.of(a, 1);
                return Transforms.scaling(s[0], s[1], s[2]);
            }
            case "rotate" -> {
                requirePart(element, a, location, List.of("angle"), coordinates);
                double[] axis = Coordinates.of(a, 0);
                return Transforms.rotation(axis[0], axis[1], axis[2], Numbers.real(a.getOrDefault("angle", "")));
            }
            case "lookat", "lookAt" -> {
                requirePart(element, a, location, List.of("origin", "target"), List.of("up"));
                return Transforms.lookAt(
                        Numbers.three(a.getOrDefault("origin", "")),
                        Numbers.three(a.getOrDefault("target", "")),
                        Numbers.three(a.getOrDefault("up", "0, 0, 0")));
            }
            case "matrix" -> {
                requirePart(element, a, location, List.of("value"), List.of());
                return Transforms.matrix(Numbers.list(a.getOrDefault("value", "")));
            }
            default ->
                throw new FormatException("<" + element + "> cannot stand in <transform>"
                        + NearestName.hint(element, List.of("translate", "rotate", "scale", "lookat", "matrix")));
        }
    }

    private void requirePart(
            String element,
            Map<String, String> attributes,
            SourceLocation location,
            List<String> required,
            List<String> optional)
            throws FormatException {
        for (String name : required) {
            if (!attributes.containsKey(name)) {
                throw new FormatException("<" + element + "> needs the attribute '" + name + "'");
            }
        }
        check(element, attributes, location, required, optional);
    }
}
