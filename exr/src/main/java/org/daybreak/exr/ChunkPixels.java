package org.daybreak.exr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;

/**
 * Moves samples between the arrays of an image and the bytes of a chunk: row after row, in each row channel after
 * channel, in each channel the samples from left to right, little endian. One instance serves all threads.
 */
final class ChunkPixels {
    private final ChunkLayout layout;
    private final PixelType[] types;
    /** A {@code float[]} or {@code int[]} for each level and channel. */
    private final Object[][] planes;

    ChunkPixels(ChunkLayout layout, ExrImage image) {
        this.layout = layout;
        List<ExrChannel> channels = image.header().channels();
        types = new PixelType[channels.size()];
        planes = new Object[layout.grids().size()][channels.size()];
        for (int c = 0; c < types.length; c++) {
            types[c] = channels.get(c).type();
            for (int level = 0; level < planes.length; level++) {
                Object plane = image.levels().get(level).plane(channels.get(c).name());
                if (plane == null) {
                    throw new IllegalStateException(channels.get(c).name());
                }
                planes[level][c] = plane;
            }
        }
    }

    /** Copies the samples of a chunk from the image into {@code raw}. */
    void gather(int chunk, byte[] raw) {
        ByteBuffer bytes = ByteBuffer.wrap(raw).order(ByteOrder.LITTLE_ENDIAN);
        int level = layout.gridIndex(chunk);
        int stride = layout.grids().get(level).width();
        int width = layout.width(chunk);
        int height = layout.height(chunk);
        int start = layout.top(chunk) * stride + layout.left(chunk);
        int place = 0;
        for (int line = 0; line < height; line++, start += stride) {
            for (int c = 0; c < types.length; c++) {
                bytes.position(place);
                Object plane = planes[level][c];
                switch (types[c]) {
                    case UINT -> bytes.asIntBuffer().put((int[]) plane, start, width);
                    case FLOAT -> bytes.asFloatBuffer().put((float[]) plane, start, width);
                    case HALF -> putHalves((float[]) plane, start, width, raw, place);
                }
                place += width * types[c].byteCount();
            }
        }
    }

    /** Copies the samples of a chunk from {@code raw} into the image. */
    void scatter(byte[] raw, int chunk) {
        ByteBuffer bytes = ByteBuffer.wrap(raw).order(ByteOrder.LITTLE_ENDIAN);
        int level = layout.gridIndex(chunk);
        int stride = layout.grids().get(level).width();
        int width = layout.width(chunk);
        int height = layout.height(chunk);
        int start = layout.top(chunk) * stride + layout.left(chunk);
        int place = 0;
        for (int line = 0; line < height; line++, start += stride) {
            for (int c = 0; c < types.length; c++) {
                bytes.position(place);
                Object plane = planes[level][c];
                switch (types[c]) {
                    case UINT -> bytes.asIntBuffer().get((int[]) plane, start, width);
                    case FLOAT -> bytes.asFloatBuffer().get((float[]) plane, start, width);
                    case HALF -> getHalves(raw, place, (float[]) plane, start, width);
                }
                place += width * types[c].byteCount();
            }
        }
    }

    private static void putHalves(float[] samples, int start, int count, byte[] raw, int place) {
        for (int i = 0; i < count; i++) {
            int half = Half.fromFloat(samples[start + i]);
            raw[place + 2 * i] = (byte) half;
            raw[place + 2 * i + 1] = (byte) (half >> 8);
        }
    }

    private static void getHalves(byte[] raw, int place, float[] samples, int start, int count) {
        for (int i = 0; i < count; i++) {
            int low = raw[place + 2 * i] & 0xff;
            samples[start + i] = Half.toFloat((short) (low | (raw[place + 2 * i + 1] << 8)));
        }
    }
}
