package org.daybreak.metropolis.chains;

import java.util.ArrayList;
import java.util.List;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;

/** One worker per thread, for all phases of a render. */
final class ChainWorkers {
    private final List<ChainWorker> workers = new ArrayList<>();

    ChainWorkers(ChainAlgorithm algorithm, Scene scene, Camera camera, long seed, int shortest, int threads) {
        for (int i = 0; i < threads; i++) {
            workers.add(algorithm.newWorker(scene, camera, seed, shortest));
        }
    }

    int count() {
        return workers.size();
    }

    ChainWorker get(int thread) {
        return workers.get(thread);
    }

    void setImportance(ImageImportance importance) {
        workers.forEach(worker -> worker.setImportance(importance));
    }

    long rays(RayKind kind) {
        return workers.stream().mapToLong(worker -> worker.rays(kind)).sum();
    }
}
