package org.daybreak.exr.imageio;

/** Registers the reading of PFM with ImageIO. */
public final class PfmReaderSpi extends LinearReaderSpi {
    /** Creates the provider; ImageIO does. */
    public PfmReaderSpi() {
        super(LinearFormat.PFM, "org.daybreak.exr.imageio.PfmWriterSpi");
    }
}
