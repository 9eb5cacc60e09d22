package org.daybreak.tracing;

import java.util.Map;
import java.util.function.LongToIntFunction;
import org.daybreak.core.render.RenderState;

/**
 * The same number of samples in each pixel. The first passes take 1, 1, 2, 4, … samples per pixel, so that a complete image
 * is there soon; later ones {@value #LARGEST_PASS}.
 */
final class UniformSchedule implements SampleSchedule {
    private static final int LARGEST_PASS = 16;
    private static final String POSITION = "pass";

    private final TileGrid grid;
    private final long samplesPerPixel;
    private final long seed;
    private final LongToIntFunction affordable;
    private int pass;
    private long passStart;
    private int passSize = 1;
    private int nextTile;

    /**
     * Creates a schedule.
     *
     * @param affordable from the number of samples per pixel so far, the largest number that the next pass can take in time
     */
    UniformSchedule(TileGrid grid, long samplesPerPixel, long seed, LongToIntFunction affordable) {
        this.grid = grid;
        this.samplesPerPixel = samplesPerPixel;
        this.seed = seed;
        this.affordable = affordable;
    }

    @Override
    public boolean isDone() {
        return nextTile == grid.count() && passStart + passSize >= samplesPerPixel;
    }

    @Override
    public boolean needsCommits() {
        return false;
    }

    @Override
    public void next(TileUnit unit) {
        if (nextTile == grid.count()) {
            passStart += passSize;
            passSize = Math.max(1, Math.min(passSize(passStart, samplesPerPixel), affordable.applyAsInt(passStart)));
            nextTile = 0;
            pass++;
        }
        grid.describe(nextTile, unit);
        unit.seed = seed;
        unit.pass = pass;
        unit.firstSample = passStart;
        unit.samplesPerPixel = passSize;
        unit.samplesPerPixelThen = passStart + passSize;
        unit.expected = (long) unit.width * unit.height * passSize;
        nextTile++;
        unit.endsPass = nextTile == grid.count();
    }

    /** Samples per pixel of the pass that begins with a sample, when time does not matter. */
    static int passSize(long first, long samplesPerPixel) {
        return first == 0 ? 1 : (int) Math.min(Math.min(first, LARGEST_PASS), samplesPerPixel - first);
    }

    /** First sample of the pass that a sample belongs to, when time does not matter. */
    static long passStart(long sample, long samplesPerPixel) {
        long first = 0;
        while (sample >= first + passSize(first, samplesPerPixel)) {
            first += passSize(first, samplesPerPixel);
        }
        return first;
    }

    @Override
    public void restore(RenderState state) {
        long[] position = state.position(POSITION, 4);
        pass = (int) position[0];
        passStart = position[1];
        passSize = (int) position[2];
        nextTile = (int) position[3];
    }

    @Override
    public Map<String, long[]> position(TileUnit unit) {
        return Map.of(POSITION, new long[] {unit.pass, unit.firstSample, unit.samplesPerPixel, unit.index});
    }

    @Override
    public Map<String, long[]> position() {
        return Map.of(POSITION, new long[] {pass, passStart, passSize, nextTile});
    }
}
