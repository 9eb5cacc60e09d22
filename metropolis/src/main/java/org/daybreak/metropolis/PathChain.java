package org.daybreak.metropolis;

import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.Chain;
import org.daybreak.metropolis.chains.StateReader;
import org.daybreak.metropolis.chains.StateWriter;
import org.daybreak.metropolis.strategy.LightPath;

/** A chain whose state is a path. */
final class PathChain extends Chain {
    private final Scene scene;

    /** Where the chain is. */
    LightPath current = new LightPath();

    /** Room for a proposal; accepted, it is swapped with {@link #current}. */
    LightPath proposal = new LightPath();

    /** How many proposals of this chain have been spread over the film. */
    long strata;

    /** Creates a chain that is nowhere yet. */
    PathChain(Scene scene, long seed, int number) {
        super(seed, number);
        this.scene = scene;
    }

    /** Makes the proposal the state. */
    void swap() {
        LightPath swapped = current;
        current = proposal;
        proposal = swapped;
    }

    @Override
    protected void saveState(StateWriter out) {
        out.put(strata);
        current.save(out);
    }

    @Override
    protected void loadState(StateReader in) {
        strata = in.next();
        current.load(in, scene);
    }
}
