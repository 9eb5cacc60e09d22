package org.daybreak.exr.imageio;

/** Registers the writing of PFM with ImageIO. */
public final class PfmWriterSpi extends LinearWriterSpi {
    /** Creates the provider; ImageIO does. */
    public PfmWriterSpi() {
        super(LinearFormat.PFM, "org.daybreak.exr.imageio.PfmReaderSpi");
    }
}
