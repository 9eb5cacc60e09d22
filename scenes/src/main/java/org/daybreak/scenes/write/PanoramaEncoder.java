package org.daybreak.scenes.write;

import java.io.IOException;
import org.daybreak.core.light.RadianceMap;

/** Makes an OpenEXR file of a panorama that no file holds; programs pass one, as the format is in another module. */
@FunctionalInterface
public interface PanoramaEncoder {
    /**
     * Encodes a panorama without loss.
     *
     * @return the content of a file with the channels R, G and B of 32-bit floats
     * @throws IOException with a message fit for users if that fails
     */
    byte[] encode(RadianceMap panorama) throws IOException;
}
