package org.daybreak.metropolis.chains;

import java.util.ArrayList;
import java.util.List;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.render.ThreadOwned;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;

/** One worker per thread, for all phases of a render. */
final class ChainWorkers {
    private final List<ThreadOwned<ChainWorker>> workers = new ArrayList<>();
    private final long[] raysBefore = new long[RayKind.values().length];
    private volatile ImageImportance importance = ImageImportance.UNIFORM;

    ChainWorkers(ChainAlgorithm algorithm, Scene scene, Camera camera, long seed, int shortest, int threads) {
        for (int i = 0; i < threads; i++) {
            workers.add(new ThreadOwned<>(
                    () -> {
                        ChainWorker worker = algorithm.newWorker(scene, camera, seed, shortest);
                        worker.setImportance(importance);
                        return worker;
                    },
                    this::retire));
        }
    }

    private void retire(ChainWorker old) {
        synchronized (raysBefore) {
            for (RayKind kind : RayKind.values()) {
                raysBefore[kind.ordinal()] += old.rays(kind);
            }
        }
    }

    int count() {
        return workers.size();
    }

    /** The worker of a thread, which calls this before each unit of work. */
    ChainWorker renewed(int thread) {
        return workers.get(thread).renewed();
    }

    /** The worker of a thread as it was last used; for work between phases. */
    ChainWorker get(int thread) {
        return workers.get(thread).current();
    }

    void setImportance(ImageImportance newImportance) {
        importance = newImportance;
        workers.forEach(worker -> worker.current().setImportance(newImportance));
    }

    long rays(RayKind kind) {
        synchronized (raysBefore) {
            return raysBefore[kind.ordinal()]
                    + workers.stream()
                            .mapToLong(worker -> worker.current().rays(kind))
                            .sum();
        }
    }
}
