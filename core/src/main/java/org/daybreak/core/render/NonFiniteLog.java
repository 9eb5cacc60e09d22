package org.daybreak.core.render;

import java.util.ArrayList;
import java.util.List;

/**
 * Counts samples that were NaN or infinite and keeps the addresses of the first few. Not thread-safe: work units have one
 * each, which are merged in the order of the units.
 */
public final class NonFiniteLog {
    private static final int KEPT = 16;

    private final List<String> addresses = new ArrayList<>();
    private long count;

    /** Creates an empty log. */
    public NonFiniteLog() {}

    /** Counts a sample of a pixel. */
    public void addSample(long seed, int x, int y, long sample) {
        count++;
        if (addresses.size() < KEPT) {
            addresses.add(new SampleAddress(seed, x, y, sample).toString());
        }
    }

    /** Counts a splat of a light subpath. */
    public void addLightPath(long seed, long path) {
        count++;
        if (addresses.size() < KEPT) {
            addresses.add("seed " + seed + ", light subpath " + path);
        }
    }

    /** Counts a sample that has an address of the renderer's own. */
    public void add(String address) {
        count++;
        if (addresses.size() < KEPT) {
            addresses.add(address);
        }
    }

    /** Adds another log's entries after this one's. */
    public void addAll(NonFiniteLog other) {
        addAll(other.count, other.addresses);
    }

    /** Adds entries of an earlier log. */
    public void addAll(long earlierCount, List<String> earlierAddresses) {
        count += earlierCount;
        for (int i = 0; i < earlierAddresses.size() && addresses.size() < KEPT; i++) {
            addresses.add(earlierAddresses.get(i));
        }
    }

    /** Empties the log. */
    public void clear() {
        count = 0;
        addresses.clear();
    }

    /** Number of samples. */
    public long count() {
        return count;
    }

    /** Addresses of the first few, to replay them. */
    public List<String> addresses() {
        return List.copyOf(addresses);
    }
}
