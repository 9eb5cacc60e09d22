package org.daybreak.core.render;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.ServiceLoader;

/** The rendering algorithms and antialiasing methods on the class path. */
public final class Renderers {
    /** The antialiasing method to take where none is asked for. */
    public static final String DEFAULT_ANTIALIASING = "sobol";

    private Renderers() {}

    /** All rendering algorithms, sorted by identifier. */
    public static List<RendererFactory> all() {
        return ServiceLoader.load(RendererFactory.class, Renderers.class.getClassLoader()).stream()
                .map(ServiceLoader.Provider::get)
                .sorted(Comparator.comparing(RendererFactory::id))
                .toList();
    }

    /** All antialiasing methods, sorted by identifier. */
    public static List<AntialiasingFactory> antialiasings() {
        return ServiceLoader.load(AntialiasingFactory.class, Renderers.class.getClassLoader()).stream()
                .map(ServiceLoader.Provider::get)
                .sorted(Comparator.comparing(AntialiasingFactory::id))
                .toList();
    }

    /**
     * The rendering algorithm of an identifier.
     *
     * @throws ParameterException if there is none, naming the nearest
     */
    public static RendererFactory byId(String id) {
        List<RendererFactory> all = all();
        for (RendererFactory factory : all) {
            if (factory.id().equals(id)) {
                return factory;
            }
        }
        throw new ParameterException("there is no renderer '" + id + "'"
                + NearestName.hint(id, all.stream().map(RendererFactory::id).toList()));
    }

    /**
     * The antialiasing method of an identifier.
     *
     * @throws ParameterException if there is none, naming the nearest
     */
    public static AntialiasingFactory antialiasingById(String id) {
        List<AntialiasingFactory> all = antialiasings();
        for (AntialiasingFactory factory : all) {
            if (factory.id().equals(id)) {
                return factory;
            }
        }
        throw new ParameterException("there is no antialiasing method '" + id + "'"
                + NearestName.hint(id, all.stream().map(AntialiasingFactory::id).toList()));
    }

    /**
     * Creates a renderer.
     *
     * @param parameters parameter texts by name; defaults for those that are missing
     * @throws ParameterException if renderer or parameter do not exist or a value is not admissible
     */
    public static Renderer create(String id, Map<String, String> parameters) {
        RendererFactory factory = byId(id);
        return factory.create(ParameterValues.parse(factory.parameters(), parameters, id));
    }

    /**
     * Creates an antialiasing method.
     *
     * @param parameters parameter texts by name; defaults for those that are missing
     * @throws ParameterException if method or parameter do not exist or a value is not admissible
     */
    public static Antialiasing createAntialiasing(String id, Map<String, String> parameters) {
        AntialiasingFactory factory = antialiasingById(id);
        return factory.create(ParameterValues.parse(factory.parameters(), parameters, id));
    }
}
