package org.daybreak.metropolis.chains;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import javax.vecmath.Color3f;
import org.daybreak.antialiasing.SobolSampling;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmLayer;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.math.Transform;
import org.daybreak.core.render.CancellationToken;
import org.daybreak.core.render.CheckpointSink;
import org.daybreak.core.render.RenderBudget;
import org.daybreak.core.render.RenderContext;
import org.daybreak.core.render.RenderListener;
import org.daybreak.core.render.RenderState;
import org.daybreak.core.scene.CameraSettings;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.core.scene.Scene;
import org.daybreak.core.scene.SceneCompiler;
import org.daybreak.core.scene.SceneGraph;

/** What tests of renders by chains have in common. */
public final class Rendering {
    public static final int WIDTH = 24;
    public static final int HEIGHT = 16;

    private Rendering() {}

    /** Takes each state that it can get. */
    public static final class Collector implements CheckpointSink {
        final List<RenderState> states = new ArrayList<>();

        @Override
        public double intervalSeconds() {
            return 1e-9;
        }

        @Override
        public void save(RenderState state) {
            states.add(state);
        }

        RenderState last() {
            return states.get(states.size() - 1);
        }
    }

    /** A sky of radiance (1, 2, 3) and nothing else: all its paths have one edge. */
    public static Scene sky(int width, int height) {
        SceneGraph graph = new SceneGraph();
        graph.root().add(new LightNode(new LightSource.ConstantEnvironment(new Color3f(1, 2, 3))));
        graph.setCamera(
                new CameraSettings(Transform.lookAt(0, 0, 4, 0, 0, 0, 0, 1, 0).toMatrix4d(), 40));
        graph.setFilm(new FilmSettings(width, height, ReconstructionFilter.BOX));
        return SceneCompiler.compile(graph, new SceneCompiler.Options(1, null));
    }

    public static Film film(int width, int height) {
        return new Film(new FilmSettings(width, height, ReconstructionFilter.BOX), Set.of(FilmLayer.VARIANCE));
    }

    public static RenderContext context(long seed, int threads, RenderBudget budget) {
        return new RenderContext(
                seed, threads, budget, new SobolSampling(), new CancellationToken(), RenderListener.NONE);
    }

    /** A render to its end. */
    public static RenderContext context(long seed, int threads) {
        return context(seed, threads, RenderBudget.samples(1));
    }

    public static ChainSettings settings(int chains, int mutations, boolean twoStage) {
        return new ChainSettings(chains, mutations, false, 2, twoStage, 3, 1000);
    }

    public static ChainRenderer toy(ChainSettings settings) {
        return new ChainRenderer(new ToyAlgorithm(), settings, -1, -1);
    }
}
