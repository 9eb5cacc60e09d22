package org.daybreak.convergence;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.HashSet;
import java.util.List;
import java.util.ServiceLoader;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.daybreak.core.render.AntialiasingFactory;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RendererFactory;
import org.junit.jupiter.api.Test;

/**
 * What users can choose from. A renderer or an antialiasing method that is added is entered here, in the list of its
 * module's {@code META-INF/services} and in the documentation; one that is missing from the services never shows up in the
 * program, which no other test would notice.
 */
class RendererListTest {
    private static final Set<String> RENDERERS =
            Set.of("path", "raytracer", "light", "bidirectional", "metropolis", "pssmlt", "mmlt");
    private static final Set<String> ANTIALIASING = Set.of("none", "grid", "stratified", "sobol", "adaptive");

    @Test
    void allRenderersAreFound() {
        List<RendererFactory> found = ServiceLoader.load(RendererFactory.class).stream()
                .map(ServiceLoader.Provider::get)
                .toList();
        assertEquals(
                new TreeSet<>(RENDERERS),
                ids(found.stream().map(RendererFactory::id).toList()));
        for (RendererFactory factory : found) {
            checkDescriptions(factory.id(), factory.description(), factory.parameters());
            assertNotNull(factory.create(ParameterValues.defaults(factory.parameters())));
        }
    }

    @Test
    void allAntialiasingMethodsAreFound() {
        List<AntialiasingFactory> found = ServiceLoader.load(AntialiasingFactory.class).stream()
                .map(ServiceLoader.Provider::get)
                .toList();
        assertEquals(
                new TreeSet<>(ANTIALIASING),
                ids(found.stream().map(AntialiasingFactory::id).toList()));
        for (AntialiasingFactory factory : found) {
            checkDescriptions(factory.id(), factory.description(), factory.parameters());
            assertEquals(
                    factory.id(),
                    factory.create(ParameterValues.defaults(factory.parameters()))
                            .id());
        }
    }

    /** The identifiers in order; none may be there twice. */
    private static Set<String> ids(List<String> found) {
        assertEquals(found.size(), new HashSet<>(found).size(), () -> "an identifier is there twice: " + found);
        return found.stream().collect(Collectors.toCollection(TreeSet::new));
    }

    private static void checkDescriptions(String id, String description, List<Parameter> parameters) {
        assertFalse(description.isBlank(), id);
        Set<String> names = new HashSet<>();
        for (Parameter parameter : parameters) {
            assertTrue(names.add(parameter.name()), () -> id + " has two parameters " + parameter.name());
            assertFalse(parameter.label().isBlank(), () -> id + "." + parameter.name());
            assertFalse(parameter.doc().isBlank(), () -> id + "." + parameter.name());
        }
    }
}
