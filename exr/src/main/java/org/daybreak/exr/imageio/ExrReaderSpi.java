package org.daybreak.exr.imageio;

/** Registers the reading of OpenEXR with ImageIO. */
public final class ExrReaderSpi extends LinearReaderSpi {
    /** Creates the provider; ImageIO does. */
    public ExrReaderSpi() {
        super(LinearFormat.EXR, "org.daybreak.exr.imageio.ExrWriterSpi");
    }
}
