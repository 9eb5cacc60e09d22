package org.daybreak.core.render;

/**
 * One of several parts into which the work of a render is cut, so that it can be spread over machines. Parts are cut where
 * the whole render adds up separately, so that the films of all parts together have the same bits as the film of the whole.
 *
 * @param index from 0
 * @param count number of parts
 */
public record RenderPart(int index, int count) {
    /** Everything. */
    public static final RenderPart WHOLE = new RenderPart(0, 1);

    /** Checks the range. */
    public RenderPart {
        if (count < 1 || index < 0 || index >= count) {
            throw new ParameterException("there is no part " + (index + 1L) + " of " + count);
        }
    }

    /** True if there is only this part. */
    public boolean isWhole() {
        return count == 1;
    }

    /** The first of this part's units when {@code units} are divided in order and as evenly as possible. */
    public long first(long units) {
        return Math.multiplyExact(units, index) / count;
    }

    /** The unit after this part's last one. */
    public long end(long units) {
        return Math.multiplyExact(units, index + 1L) / count;
    }

    /** {@code 2/5} for the second of five. */
    @Override
    public String toString() {
        return index + 1 + "/" + count;
    }
}
