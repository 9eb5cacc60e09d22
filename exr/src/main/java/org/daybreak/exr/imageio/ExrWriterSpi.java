package org.daybreak.exr.imageio;

/** Registers the writing of OpenEXR with ImageIO. */
public final class ExrWriterSpi extends LinearWriterSpi {
    /** Creates the provider; ImageIO does. */
    public ExrWriterSpi() {
        super(LinearFormat.EXR, "org.daybreak.exr.imageio.ExrReaderSpi");
    }
}
