package org.daybreak.architecture;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.TreeSet;
import javax.xml.parsers.DocumentBuilderFactory;
import javax.xml.parsers.ParserConfigurationException;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.w3c.dom.Element;
import org.w3c.dom.Node;
import org.xml.sax.SAXException;

/** The BOM names every module that is published, and nothing else. */
class PublishedModulesTest {
    private static final Path ROOT = Path.of(System.getProperty("daybreak.root"));

    private static Element root;
    private static Element bom;

    @BeforeAll
    static void read() throws IOException, SAXException, ParserConfigurationException {
        root = pom(ROOT.resolve("pom.xml"));
        bom = pom(ROOT.resolve("bom").resolve("pom.xml"));
    }

    private static Element pom(Path file) throws IOException, SAXException, ParserConfigurationException {
        return DocumentBuilderFactory.newDefaultInstance()
                .newDocumentBuilder()
                .parse(file.toFile())
                .getDocumentElement();
    }

    /** The elements at the end of a path of names. */
    private static List<Element> elements(Element from, String... path) {
        List<Element> found = List.of(from);
        for (String name : path) {
            List<Element> next = new ArrayList<>();
            for (Element element : found) {
                for (Node child = element.getFirstChild(); child != null; child = child.getNextSibling()) {
                    if (child instanceof Element inner && inner.getTagName().equals(name)) {
                        next.add(inner);
                    }
                }
            }
            found = next;
        }
        return found;
    }

    /** The text of the element at the end of a path, or null. */
    private static String text(Element from, String... path) {
        List<Element> found = elements(from, path);
        return found.isEmpty() ? null : found.get(0).getTextContent().strip();
    }

    /** Artifacts of all modules that are libraries or programs for others, with their folders. */
    private static Map<String, String> published() throws IOException, SAXException, ParserConfigurationException {
        Map<String, String> published = new TreeMap<>();
        for (Element module : elements(root, "modules", "module")) {
            String folder = module.getTextContent().strip();
            Element pom = pom(ROOT.resolve(folder).resolve("pom.xml"));
            boolean internal = "true".equals(text(pom, "properties", "module.internal"));
            if (!internal && !"pom".equals(text(pom, "packaging"))) {
                published.put(text(pom, "artifactId"), folder);
            }
        }
        return published;
    }

    @Test
    void bomNamesWhatIsPublished() throws IOException, SAXException, ParserConfigurationException {
        TreeSet<String> named = new TreeSet<>();
        for (Element dependency : elements(bom, "dependencyManagement", "dependencies", "dependency")) {
            assertEquals("org.daybreak", text(dependency, "groupId"));
            assertEquals("${project.version}", text(dependency, "version"));
            assertTrue(named.add(text(dependency, "artifactId")), "named twice");
        }
        assertEquals(published().keySet(), named);
        assertEquals(text(root, "version"), text(bom, "version"));
    }

    /** Who imports the BOM inherits nothing. */
    @Test
    void bomStandsAlone() {
        assertEquals(List.of(), elements(bom, "parent"));
        assertEquals(List.of(), elements(bom, "dependencies"));
        assertNull(text(bom, "modules"));
        Map<String, String> versions = new TreeMap<>();
        for (Element plugin : elements(root, "build", "pluginManagement", "plugins", "plugin")) {
            versions.put(text(plugin, "artifactId"), text(plugin, "version"));
        }
        for (Element plugin : elements(bom, "build", "pluginManagement", "plugins", "plugin")) {
            String name = text(plugin, "artifactId");
            assertEquals(versions.get(name), text(plugin, "version"), name);
        }
        assertEquals(
                text(root, "properties", "project.build.outputTimestamp"),
                text(bom, "properties", "project.build.outputTimestamp"));
    }

    /** Whatever has code of its own and is not marked as internal is published, so that a new module cannot be forgotten. */
    @Test
    void everyFolderWithSourcesIsAModule() throws IOException, SAXException, ParserConfigurationException {
        List<String> modules = elements(root, "modules", "module").stream()
                .map(module -> module.getTextContent().strip())
                .toList();
        try (var folders = Files.list(ROOT)) {
            for (Path folder : folders.filter(f -> Files.isDirectory(f.resolve("src/main/java")))
                    .toList()) {
                assertTrue(modules.contains(folder.getFileName().toString()), () -> folder + " is in no build");
            }
        }
        assertFalse(published().isEmpty());
    }
}
