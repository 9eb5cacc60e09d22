package org.daybreak.exr.imageio;

import java.io.IOException;
import java.util.List;
import java.util.stream.Stream;
import org.daybreak.exr.ExrChannel;
import org.daybreak.exr.ExrHeader;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.daybreak.exr.PixelType;

/**
 * A part of an OpenEXR file as a picture: the channels R, G and B, or else Y, each with A if there is one, of the first
 * layer that has them; a single channel of any name is grey.
 */
final class ExrPictureSource implements PictureSource {
    private final byte[] bytes;
    private final ExrHeader header;
    private final int part;
    private final List<String> channels;

    ExrPictureSource(byte[] bytes, ExrHeader header, int part) throws IOException {
        this.bytes = bytes;
        this.header = header;
        this.part = part;
        this.channels = channels(header);
        if (header.width() > Integer.MAX_VALUE || header.height() > Integer.MAX_VALUE) {
            throw new IOException("an image of " + header.width() + " x " + header.height() + " pixels is too large");
        }
    }

    private static List<String> channels(ExrHeader header) throws IOException {
        for (String layer : header.layers()) {
            for (List<String> components : List.of(List.of("R", "G", "B"), List.of("Y"))) {
                List<String> names = components.stream()
                        .map(component -> ExrChannel.name(layer, component))
                        .toList();
                if (header.channelNames().containsAll(names)) {
                    String alpha = ExrChannel.name(layer, "A");
                    if (header.channelNames().contains(alpha)) {
                        return Stream.concat(names.stream(), Stream.of(alpha)).toList();
                    }
                    return names;
                }
            }
        }
        if (header.channels().size() == 1) {
            return header.channelNames();
        }
        throw new IOException(
                "the image has neither the channels R, G and B nor Y, but " + String.join(", ", header.channelNames()));
    }

    @Override
    public int width() {
        return (int) header.width();
    }

    @Override
    public int height() {
        return (int) header.height();
    }

    @Override
    public int components() {
        return channels.size();
    }

    @Override
    public LinearPicture read() throws IOException {
        int threads = Runtime.getRuntime().availableProcessors();
        ExrImage image = ExrReader.readParts("the image stream", bytes, threads).get(part);
        int stride = channels.size();
        long count = (long) width() * height() * stride;
        if (count > Integer.MAX_VALUE - 8) {
            throw new IOException(count + " samples do not fit one array");
        }
        float[] samples = new float[(int) count];
        for (int c = 0; c < stride; c++) {
            ExrChannel channel = header.channel(channels.get(c));
            if (channel != null && channel.type() == PixelType.UINT) {
                int[] plane = image.uintSamples(channel.name());
                for (int i = 0; i < plane.length; i++) {
                    samples[i * stride + c] = Integer.toUnsignedLong(plane[i]);
                }
            } else {
                float[] plane = image.samples(channels.get(c));
                for (int i = 0; i < plane.length; i++) {
                    samples[i * stride + c] = plane[i];
                }
            }
        }
        return new LinearPicture(width(), height(), stride, samples);
    }
}
