package org.daybreak.scenes;

import java.util.List;
import java.util.Locale;
import org.daybreak.scenes.build.PluginDefinition;
import org.daybreak.scenes.build.Plugins;
import org.daybreak.scenes.build.PropertyDefinition;
import org.daybreak.scenes.build.ValueType;
import org.daybreak.scenes.description.ObjectKind;

/** What scene files may contain, for lists and documentation. Derived from the table the reader checks files against. */
public final class InputFormats {
    /**
     * A format of files.
     *
     * @param name its name
     * @param endings file name endings without the dot
     * @param doc what is read
     */
    public record Format(String name, List<String> endings, String doc) {}

    private InputFormats() {}

    /** The formats of scenes and meshes. */
    public static List<Format> formats() {
        return List.of(
                new Format(
                        "Mitsuba XML",
                        List.of("xml"),
                        "Scenes of Mitsuba 3, 2 and 0.6, with <default>, <include>, <ref> and transforms; the types of"
                                + " objects are listed below."),
                new Format(
                        "glTF 2.0",
                        List.of("gltf", "glb"),
                        "Scenes, text and binary; camera and light are added where there are none."),
                new Format(
                        "Wavefront OBJ",
                        List.of("obj"),
                        "Polygon meshes; with the materials of their MTL files when rendered by themselves."),
                new Format("PLY", List.of("ply"), "Polygon meshes; ASCII and binary of both byte orders."),
                new Format("STL", List.of("stl"), "Triangle meshes, flat; ASCII and binary."));
    }

    /** The types of objects that scenes may contain, by kind. */
    public static List<PluginDefinition> plugins() {
        return Plugins.list();
    }

    /** The tables of {@link #formats} and {@link #plugins} as Markdown. */
    public static String markdown() {
        StringBuilder out = new StringBuilder();
        out.append("| format | endings | |\n|---|---|---|\n");
        for (Format f : formats()) {
            row(out, f.name(), String.join(", ", f.endings()), f.doc());
        }
        ObjectKind kind = ObjectKind.SCENE;
        for (PluginDefinition plugin : plugins()) {
            if (plugin.kind() != kind) {
                kind = plugin.kind();
                out.append(String.format(Locale.ROOT, "%n## `<%s>`%n", kind.element()));
            }
            out.append(String.format(Locale.ROOT, "%n### `%s`%n%s%n", plugin.type(), plugin.doc()));
            if (!plugin.properties().isEmpty()) {
                out.append("\n| property | value | default | |\n|---|---|---|---|\n");
            }
            for (PropertyDefinition p : plugin.properties()) {
                String value = p.defaultValue();
                row(
                        out,
                        p.type() == ValueType.OBJECT ? "" : "`" + p.name() + "`",
                        p.values().replace("<", "`<").replace(">", ">`"),
                        value == null ? (p.required() ? "required" : "") : value,
                        p.doc());
            }
        }
        return out.toString().replace(System.lineSeparator(), "\n");
    }

    private static void row(StringBuilder out, String... cells) {
        out.append("| ").append(String.join(" | ", cells)).append(" |\n");
    }
}
