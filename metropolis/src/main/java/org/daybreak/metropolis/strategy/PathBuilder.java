package org.daybreak.metropolis.strategy;

import java.util.stream.IntStream;
import org.daybreak.bidirectional.Contribution;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.scene.RayCaster;
import org.daybreak.core.scene.RayKind;
import org.daybreak.core.scene.Scene;
import org.daybreak.metropolis.chains.Outcome;
import org.daybreak.tracing.EmissionGuide;

/**
 * All that a worker needs to build {@link LightPath}s piece by piece. All moves go through it, so their paths cannot
 * differ in their conventions. One object per worker.
 *
 * <p>The order is always: place all new vertices (each knows its surface and, if it was sampled so, its delta lobe) by
 * {@link LightEnd}, {@link LensEnd}, {@link RandomWalk}, {@link PieceBuilder} and {@link ChainPieces};
 * {@link MeasurementContribution#measure} what is between; {@link EdgeTracer#reveal} the edges that no ray was traced
 * along. What returns false has noted why.
 */
public final class PathBuilder {
    /** So many vertices a walk may have whose length is not known beforehand. */
    private static final int LONGEST_WALK = 64;

    private final Camera camera;
    private final Failure failure = new Failure();
    private final EdgeTracer edges;
    private final LightEnd light;
    private final LensEnd lens;
    private final RandomWalk walk;
    private final ChainPieces chains;
    private final MeasurementContribution contribution;
    private final PathAssembler assembler;
    private final PieceBuilder pieces;
    private final Joints jointsBefore = new Joints();
    private final Joints jointsAfter = new Joints();
    private final boolean hasDeltas;
    private final LightPath scratchPath = new LightPath();

    /** Creates what a worker needs. */
    public PathBuilder(Scene scene, Camera camera) {
        this.camera = camera;
        RayCaster caster = new RayCaster(scene);
        EmissionGuide guide = new EmissionGuide(scene);
        edges = new EdgeTracer(caster, failure);
        light = new LightEnd(scene, guide, edges, failure);
        lens = new LensEnd(camera, edges, failure);
        walk = new RandomWalk(scene, edges, failure);
        chains = new ChainPieces(caster, failure);
        contribution = new MeasurementContribution(scene, camera, guide, failure);
        assembler = new PathAssembler(scene, light, edges, contribution);
        pieces = new PieceBuilder(scene, camera, light, lens, walk, failure);
        hasDeltas = IntStream.range(0, scene.shapeCount()).mapToObj(scene::bsdf).anyMatch(Bsdf::scattersByDeltasOnly);
        scratchPath.reserve(LONGEST_WALK);
        scratchPath.length = LONGEST_WALK;
    }

    /**
     * Builds a path that bidirectional path tracing has found.
     *
     * @return false if it carries nothing after all, as rounding may have it
     */
    public boolean assemble(Contribution found, LightPath y) {
        return assembler.assemble(found, y);
    }

    /** Number of rays of a kind traced so far. */
    public long rays(RayKind kind) {
        return edges.rays(kind);
    }

    /** Why the last operation that returned false has failed. */
    public Outcome failure() {
        return failure.outcome();
    }

    /** Notes why a proposal fails. Returns false. */
    boolean fail(Outcome why) {
        return failure.because(why);
    }

    /** True if the last ray was traced and has left the scene. */
    boolean escaped() {
        return failure.escaped();
    }

    /** The camera. */
    Camera camera() {
        return camera;
    }

    /** Vertices on lights. */
    LightEnd light() {
        return light;
    }

    /** Vertices on the lens. */
    LensEnd lens() {
        return lens;
    }

    /** Vertices between, one after another. */
    RandomWalk walk() {
        return walk;
    }

    /** Pieces from both of their ends. */
    PieceBuilder pieces() {
        return pieces;
    }

    /** Room for the joints of the path that a proposal leaves. */
    Joints jointsBefore() {
        return jointsBefore;
    }

    /** Room for the joints of the path that is proposed. */
    Joints jointsAfter() {
        return jointsAfter;
    }

    /** Whether paths can have vertices that are no {@link Joints}. */
    boolean hasDeltas() {
        return hasDeltas;
    }

    /** Chains of delta lobes between two vertices. */
    ChainPieces chains() {
        return chains;
    }

    /** What a path carries, and the densities of its vertices. */
    MeasurementContribution contribution() {
        return contribution;
    }

    /** What stands between vertices. */
    EdgeTracer edges() {
        return edges;
    }

    /** Room for a walk from the lens whose length is not known beforehand: the lens is its last vertex. */
    LightPath scratchPath() {
        return scratchPath;
    }
}
