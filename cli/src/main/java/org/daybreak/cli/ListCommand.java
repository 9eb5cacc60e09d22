package org.daybreak.cli;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.concurrent.Callable;
import org.daybreak.core.accel.IntersectorProvider;
import org.daybreak.core.accel.Intersectors;
import org.daybreak.core.render.AntialiasingFactory;
import org.daybreak.core.render.NearestName;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.RendererFactory;
import org.daybreak.scenes.InputFormats;
import org.daybreak.scenes.build.PluginDefinition;
import org.daybreak.scenes.build.PropertyDefinition;
import org.daybreak.scenes.description.ObjectKind;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code daybreak list}: what can be chosen. Everything comes from the definitions that values are checked against. */
@Command(
        name = "list",
        description = {
            "Lists what there is to choose from, with parameters and defaults:",
            "renderers, antialiasing, intersectors, materials, lights, shapes, textures or formats."
        },
        footer = {"", "Examples:", "  daybreak list renderers", "  daybreak list materials --json"})
final class ListCommand implements Callable<Integer> {
    private final Session session;

    @Parameters(paramLabel = "WHAT", description = "One of the words above.")
    private String what = "";

    @Option(names = "--json", description = "Prints JSON.")
    private boolean json;

    ListCommand(Session session) {
        this.session = session;
    }

    /**
     * Something that can be chosen.
     *
     * @param id its name
     * @param doc one line on it
     * @param parameters its parameters
     */
    private record Item(String id, String doc, List<ItemParameter> parameters) {}

    /**
     * A parameter of something that can be chosen.
     *
     * @param name its name
     * @param label the label for people; empty if it has none
     * @param values admissible values in words
     * @param defaultValue the default; empty if it has none
     * @param doc what it does
     */
    private record ItemParameter(String name, String label, String values, String defaultValue, String doc) {}

    @Override
    public Integer call() {
        List<Item> items = switch (what) {
            case "renderers" -> renderers();
            case "antialiasing" -> antialiasing();
            case "intersectors" -> intersectors();
            case "materials" -> plugins(ObjectKind.BSDF);
            case "lights" -> plugins(ObjectKind.EMITTER);
            case "shapes" -> plugins(ObjectKind.SHAPE);
            case "textures" -> plugins(ObjectKind.TEXTURE);
            case "formats" -> formats();
            default ->
                throw new CommandException(
                        ExitCode.USAGE,
                        "there is no list of '" + what + "'"
                                + NearestName.hint(
                                        what,
                                        List.of(
                                                "renderers",
                                                "antialiasing",
                                                "intersectors",
                                                "materials",
                                                "lights",
                                                "shapes",
                                                "textures",
                                                "formats")));
        };
        if (json) {
            session.out()
                    .print(JsonText.document(
                            items.stream().map(ListCommand::map).toList()));
        } else {
            items.forEach(this::print);
        }
        return ExitCode.OK.number();
    }

    private static List<Item> renderers() {
        List<Item> items = new ArrayList<>();
        for (RendererFactory factory : Services.renderers()) {
            items.add(new Item(factory.id(), factory.description(), parameters(factory.parameters())));
        }
        return items;
    }

    private static List<Item> antialiasing() {
        List<Item> items = new ArrayList<>();
        for (AntialiasingFactory factory : Services.antialiasing()) {
            items.add(new Item(factory.id(), factory.description(), parameters(factory.parameters())));
        }
        return items;
    }

    private static List<Item> intersectors() {
        Intersectors.Selection selection = Intersectors.select();
        List<Item> items = new ArrayList<>();
        for (IntersectorProvider provider : Intersectors.providers()) {
            String rejected = selection.rejected().get(provider.id());
            String state = provider.id().equals(selection.provider().id())
                    ? " [in use]"
                    : rejected == null ? "" : " [not here: " + rejected + "]";
            items.add(new Item(provider.id(), provider.description() + state, List.of()));
        }
        return items;
    }

    private static List<Item> plugins(ObjectKind kind) {
        List<Item> items = new ArrayList<>();
        for (PluginDefinition plugin : InputFormats.plugins()) {
            if (plugin.kind() == kind) {
                List<ItemParameter> parameters = new ArrayList<>();
                for (PropertyDefinition property : plugin.properties()) {
                    String given = property.defaultValue();
                    parameters.add(new ItemParameter(
                            property.name(),
                            "",
                            property.values(),
                            given != null ? given : property.required() ? "required" : "",
                            property.doc()));
                }
                items.add(new Item(plugin.type(), plugin.doc(), parameters));
            }
        }
        return items;
    }

    private static List<Item> formats() {
        List<Item> items = new ArrayList<>();
        for (InputFormats.Format format : InputFormats.formats()) {
            items.add(new Item(
                    String.join(", ", format.endings()), "read: " + format.name() + ". " + format.doc(), List.of()));
        }
        items.add(new Item("exr, pfm", "read: textures and environments of linear values.", List.of()));
        items.add(new Item("png, jpg, jpeg, bmp, gif", "read: textures, sRGB unless the scene says raw.", List.of()));
        for (OutputFile.Format format : OutputFile.Format.values()) {
            items.add(new Item(format.ending(), "written: " + format.doc() + ".", List.of()));
        }
        return items;
    }

    private static List<ItemParameter> parameters(List<Parameter> parameters) {
        List<ItemParameter> result = new ArrayList<>();
        for (Parameter parameter : parameters) {
            result.add(new ItemParameter(
                    parameter.name(),
                    parameter.label(),
                    parameter.range(),
                    String.valueOf(parameter.defaultValue()),
                    parameter.doc()));
        }
        return result;
    }

    private void print(Item item) {
        session.out().printf(Locale.ROOT, "%-14s %s%n", item.id, item.doc);
        for (ItemParameter parameter : item.parameters) {
            String label = parameter.label.isEmpty() ? "" : " \"" + parameter.label + "\"";
            String given = parameter.defaultValue.isEmpty() ? "" : "; default " + parameter.defaultValue;
            session.out().printf(Locale.ROOT, "    %s%s: %s%s%n", parameter.name, label, parameter.values, given);
            session.out().printf(Locale.ROOT, "        %s%n", parameter.doc);
        }
    }

    private static Map<String, Object> map(Item item) {
        Map<String, Object> values = new LinkedHashMap<>();
        values.put("id", item.id);
        values.put("doc", item.doc);
        List<Object> parameters = new ArrayList<>();
        for (ItemParameter parameter : item.parameters) {
            Map<String, Object> fields = new LinkedHashMap<>();
            fields.put("name", parameter.name);
            fields.put("label", parameter.label);
            fields.put("values", parameter.values);
            fields.put("default", parameter.defaultValue);
            fields.put("doc", parameter.doc);
            parameters.add(fields);
        }
        values.put("parameters", parameters);
        return values;
    }
}
