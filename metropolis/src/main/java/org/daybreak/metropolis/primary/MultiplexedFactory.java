package org.daybreak.metropolis.primary;

/** Multiplexed Metropolis light transport (Hachisuka et al. 2014) as users see it. */
public final class MultiplexedFactory extends PrimaryRendererFactory {
    /** Creates the factory. */
    public MultiplexedFactory() {
        super("mmlt", true);
    }

    @Override
    public String description() {
        return "Metropolis light transport over the random numbers of single paths and the ways to make them (Hachisuka et"
                + " al. 2014)";
    }
}
