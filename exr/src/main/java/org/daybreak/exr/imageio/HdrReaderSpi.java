package org.daybreak.exr.imageio;

/** Registers the reading of Radiance HDR with ImageIO. */
public final class HdrReaderSpi extends LinearReaderSpi {
    /** Creates the provider; ImageIO does. */
    public HdrReaderSpi() {
        super(LinearFormat.HDR, "org.daybreak.exr.imageio.HdrWriterSpi");
    }
}
