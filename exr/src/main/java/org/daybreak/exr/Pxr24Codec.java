package org.daybreak.exr;

import java.io.IOException;
import java.util.List;

/**
 * The codec of {@link Compression#PXR24}, for reading only. In each row of a channel each sample is replaced by its
 * difference from the one before; the highest bytes of all differences come first, then the next ones, and so on. Of
 * floats only the upper 24 bits are kept. All that is deflated.
 */
final class Pxr24Codec implements ChunkCodec {
    private final PixelType[] types;
    private final Inflation inflation = new Inflation();
    private byte[] planes = new byte[0];

    Pxr24Codec(List<ExrChannel> channels) {
        types = channels.stream().map(ExrChannel::type).toArray(PixelType[]::new);
    }

    @Override
    public int pack(byte[] raw, int rawLength, byte[] packed, int offset) {
        throw new UnsupportedOperationException(Compression.PXR24.notWritable());
    }

    @Override
    public void unpack(byte[] packed, int packedLength, byte[] raw, int rawLength, int width, int height)
            throws IOException {
        int bytesPerPixel = 0;
        for (PixelType type : types) {
            bytesPerPixel += storedBytes(type);
        }
        int length = bytesPerPixel * width * height;
        if (planes.length < length) {
            planes = new byte[length];
        }
        inflation.inflate(packed, packedLength, planes, length);
        int in = 0;
        int out = 0;
        for (int line = 0; line < height; line++) {
            for (PixelType type : types) {
                int stored = storedBytes(type);
                int size = type.byteCount();
                int sample = 0;
                for (int x = 0; x < width; x++) {
                    int difference = 0;
                    for (int plane = 0; plane < stored; plane++) {
                        difference = difference << 8 | (planes[in + plane * width + x] & 0xff);
                    }
                    sample += difference;
                    // The byte that was cut off a float comes back as 0.
                    int bits = type == PixelType.FLOAT ? sample << 8 : sample;
                    for (int i = 0; i < size; i++) {
                        raw[out++] = (byte) (bits >>> (8 * i));
                    }
                }
                in += stored * width;
            }
        }
    }

    private static int storedBytes(PixelType type) {
        return switch (type) {
            case UINT -> 4;
            case HALF -> 2;
            case FLOAT -> 3;
        };
    }

    @Override
    public void close() {
        inflation.close();
    }
}
