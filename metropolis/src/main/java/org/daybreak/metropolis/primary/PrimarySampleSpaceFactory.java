package org.daybreak.metropolis.primary;

/** Primary-sample-space Metropolis light transport (Kelemen et al. 2002) as users see it. */
public final class PrimarySampleSpaceFactory extends PrimaryRendererFactory {
    /** Creates the factory. */
    public PrimarySampleSpaceFactory() {
        super("pssmlt", false);
    }

    @Override
    public String description() {
        return "Metropolis light transport over the random numbers of bidirectional path tracing (Kelemen et al. 2002)";
    }
}
