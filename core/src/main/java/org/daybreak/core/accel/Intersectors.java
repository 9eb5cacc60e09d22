package org.daybreak.core.accel;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.stream.Collectors;

/** Chooses among the {@link IntersectorProvider}s on the class path. */
public final class Intersectors {
    private Intersectors() {}

    /**
     * The provider that was chosen, and why the better ones were not.
     *
     * @param provider builds intersectors
     * @param rejected by id of a provider of higher priority: the reason against it, in order of priority
     */
    public record Selection(IntersectorProvider provider, Map<String, String> rejected) {
        /** Keeps the order of the map. */
        public Selection {
            rejected = java.util.Collections.unmodifiableMap(new LinkedHashMap<>(rejected));
        }
    }

    /** All providers, best first, whether or not they are available here. */
    public static List<IntersectorProvider> providers() {
        List<IntersectorProvider> found = new ArrayList<>();
        for (IntersectorProvider provider :
                ServiceLoader.load(IntersectorProvider.class, Intersectors.class.getClassLoader())) {
            found.add(provider);
        }
        found.sort(Comparator.comparingInt(IntersectorProvider::priority)
                .reversed()
                .thenComparing(IntersectorProvider::id));
        return found;
    }

    /**
     * The available provider of highest priority. Found once for each process, so that whatever it has to warm up is
     * warmed up once.
     */
    public static Selection select() {
        return Chosen.BEST;
    }

    /** Chooses the best provider and warms it up in the background: call it before a scene is read. */
    public static void warmUp() {
        Thread thread = new Thread(() -> select().provider().warmUp(), "intersector-choice");
        thread.setDaemon(true);
        thread.start();
    }

    /**
     * The provider of the given id.
     *
     * @throws IllegalArgumentException if there is none or it is not available here
     */
    public static IntersectorProvider select(String id) {
        List<IntersectorProvider> providers = providers();
        for (IntersectorProvider provider : providers) {
            if (provider.id().equals(id)) {
                String reason = reasonAgainst(provider);
                if (!reason.isEmpty()) {
                    throw new IllegalArgumentException("intersector " + id + " cannot be used: " + reason);
                }
                return provider;
            }
        }
        throw new IllegalArgumentException("there is no intersector \"" + id + "\"; known are: "
                + providers.stream().map(IntersectorProvider::id).collect(Collectors.joining(", ")));
    }

    private static final class Chosen {
        static final Selection BEST = best();

        private static Selection best() {
            Map<String, String> rejected = new LinkedHashMap<>();
            for (IntersectorProvider provider : providers()) {
                String reason = reasonAgainst(provider);
                if (reason.isEmpty()) {
                    return new Selection(provider, rejected);
                }
                rejected.put(provider.id(), reason);
            }
            return new Selection(new ScalarProvider(), rejected);
        }
    }

    private static String reasonAgainst(IntersectorProvider provider) {
        try {
            return provider.unavailability().orElse("");
        } catch (LinkageError | ServiceConfigurationError | RuntimeException e) {
            return "it failed: " + e;
        }
    }
}
