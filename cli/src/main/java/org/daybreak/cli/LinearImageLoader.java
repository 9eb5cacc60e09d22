package org.daybreak.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Set;
import org.daybreak.exr.ExrChannel;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.daybreak.exr.ImageFileException;
import org.daybreak.exr.Pfm;
import org.daybreak.exr.PfmImage;
import org.daybreak.exr.PixelType;
import org.daybreak.scenes.image.ImageLoader;
import org.daybreak.scenes.image.LoadedImage;

/** Reads textures and environments of linear values: OpenEXR (R, G, B or Y) and PFM. */
final class LinearImageLoader implements ImageLoader {
    @Override
    public Set<String> endings() {
        return Set.of("exr", "pfm");
    }

    @Override
    public LoadedImage load(Path file) throws IOException {
        try {
            return ImageLoader.ending(file).equals("pfm") ? pfm(Pfm.read(file)) : exr(ExrReader.read(file));
        } catch (ImageFileException e) {
            throw new IOException(e.reason(), e);
        } catch (IllegalArgumentException e) {
            throw new IOException(e.getMessage(), e);
        }
    }

    private static LoadedImage pfm(PfmImage image) {
        return new LoadedImage.Floats(image.width(), image.height(), image.components(), image.samples(), false);
    }

    private static LoadedImage exr(ExrImage image) throws IOException {
        if (isFloat(image, "R") && isFloat(image, "G") && isFloat(image, "B")) {
            return new LoadedImage.Floats(
                    image.width(), image.height(), 3, image.interleaved("", "R", "G", "B"), false);
        }
        if (isFloat(image, "Y")) {
            return new LoadedImage.Floats(image.width(), image.height(), 1, image.samples("Y"), false);
        }
        throw new IOException("the image has neither the channels R, G and B nor Y, but "
                + String.join(", ", image.header().channelNames()));
    }

    private static boolean isFloat(ExrImage image, String channel) {
        ExrChannel found = image.header().channel(channel);
        return found != null && found.type() != PixelType.UINT;
    }
}
