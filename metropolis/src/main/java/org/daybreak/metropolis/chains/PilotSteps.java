package org.daybreak.metropolis.chains;

import java.util.Map;
import java.util.TreeMap;

/** What steps of chains cost that a pilot has tried, by the kind of path that they were tried from. */
final class PilotSteps {
    /** Sums over the steps from one kind of paths. */
    private static final class Sums {
        private double weight;
        private double work;
    }

    private static final Sums NOTHING = new Sums();

    /** In an order, so that sums over all kinds are the same each time. */
    private final Map<Long, Sums> kinds = new TreeMap<>();

    void clear() {
        kinds.clear();
    }

    void add(long pattern, double weight, double work) {
        Sums sums = kinds.computeIfAbsent(pattern, kind -> new Sums());
        sums.weight += weight;
        sums.work += weight * work;
    }

    void addAll(PilotSteps others) {
        others.kinds.forEach((pattern, theirs) -> {
            Sums sums = kinds.computeIfAbsent(pattern, kind -> new Sums());
            sums.weight += theirs.weight;
            sums.work += theirs.work;
        });
    }

    /** Sum of the weights of steps from a kind of paths. */
    double weight(long pattern) {
        return kinds.getOrDefault(pattern, NOTHING).weight;
    }

    /** Sum of weight times work. */
    double work(long pattern) {
        return kinds.getOrDefault(pattern, NOTHING).work;
    }

    /** Sum of the weights of all steps. */
    double weight() {
        return kinds.values().stream().mapToDouble(sums -> sums.weight).sum();
    }

    /** Sum of weight times work of all steps. */
    double work() {
        return kinds.values().stream().mapToDouble(sums -> sums.work).sum();
    }
}
