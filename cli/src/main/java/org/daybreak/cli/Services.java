package org.daybreak.cli;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.ServiceLoader;
import java.util.function.Function;
import org.daybreak.core.accel.IntersectorProvider;
import org.daybreak.core.accel.Intersectors;
import org.daybreak.core.render.AntialiasingFactory;
import org.daybreak.core.render.NearestName;
import org.daybreak.core.render.RendererFactory;

/** Finds renderers, antialiasing methods and intersectors on the class path by their identifiers. */
final class Services {
    private Services() {}

    /** All renderers by identifier. */
    static List<RendererFactory> renderers() {
        return all(RendererFactory.class, RendererFactory::id);
    }

    /** All antialiasing methods by identifier. */
    static List<AntialiasingFactory> antialiasing() {
        return all(AntialiasingFactory.class, AntialiasingFactory::id);
    }

    /** The renderer of an identifier; {@link ExitCode#USAGE} if there is none. */
    static RendererFactory renderer(String id) {
        return find("renderer", id, renderers(), RendererFactory::id);
    }

    /** The antialiasing method of an identifier; {@link ExitCode#USAGE} if there is none. */
    static AntialiasingFactory antialiasing(String id) {
        return find("antialiasing method", id, antialiasing(), AntialiasingFactory::id);
    }

    /** Checks that an intersector exists and can be used here; {@link ExitCode#USAGE} if not. */
    static void checkIntersector(String id) {
        find("intersector", id, Intersectors.providers(), IntersectorProvider::id);
        try {
            Intersectors.select(id);
        } catch (IllegalArgumentException e) {
            throw new CommandException(ExitCode.USAGE, String.valueOf(e.getMessage()), e);
        }
    }

    private static <T> List<T> all(Class<T> type, Function<T, String> id) {
        List<T> found = new ArrayList<>();
        for (T service : ServiceLoader.load(type, Services.class.getClassLoader())) {
            found.add(service);
        }
        found.sort(Comparator.comparing(id));
        return found;
    }

    private static <T> T find(String kind, String id, List<T> services, Function<T, String> idOf) {
        List<String> known = new ArrayList<>();
        for (T service : services) {
            if (idOf.apply(service).equals(id)) {
                return service;
            }
            known.add(idOf.apply(service));
        }
        throw new CommandException(
                ExitCode.USAGE, "there is no " + kind + " '" + id + "'" + NearestName.hint(id, known));
    }
}
