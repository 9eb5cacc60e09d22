package org.daybreak.exr.imageio;

/** Registers the writing of Radiance HDR with ImageIO. */
public final class HdrWriterSpi extends LinearWriterSpi {
    /** Creates the provider; ImageIO does. */
    public HdrWriterSpi() {
        super(LinearFormat.HDR, "org.daybreak.exr.imageio.HdrReaderSpi");
    }
}
