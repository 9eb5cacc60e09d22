package org.daybreak.accel.vector;

import org.daybreak.core.accel.WideBvh;
import org.daybreak.core.testing.IntersectorChecks;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Assumptions;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class Vector512IntersectorTest {
    /** Shared: it warms up once. */
    private static final Vector512Provider PROVIDER = new Vector512Provider();

    private final IntersectorChecks checks = new IntersectorChecks(PROVIDER);

    @BeforeEach
    void runsHere() throws InterruptedException {
        String reason = PROVIDER.unavailability().orElse("");
        Assumptions.assumeTrue(reason.isEmpty(), reason);
        Assertions.assertTrue(PROVIDER.awaitFullSpeed(120_000), "the kernel is slow or wrong");
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1e-18, 1e-4, 1e4, 1e12})
    void trianglesAgreeWithBruteForce(double scale) {
        checks.trianglesAgreeWithBruteForce(scale);
    }

    @Test
    void mixedPrimitivesAgreeWithBruteForce() {
        checks.mixedPrimitivesAgreeWithBruteForce();
    }

    @Test
    void axisParallelRaysHitEdgesAndVertices() {
        checks.axisParallelRaysHitEdgesAndVertices();
    }

    @Test
    void closedMeshesAreWatertight() {
        checks.closedMeshesAreWatertight(10_000);
    }

    @Test
    void farOriginsLoseNoDigits() {
        checks.farOriginsLoseNoDigits();
    }

    @Test
    void pathsNeitherLeakNorHitThemselves() {
        checks.pathsNeitherLeakNorHitThemselves(30_000);
    }

    @Test
    void nothingIsHitWhereNothingIs() {
        checks.nothingIsHitWhereNothingIs();
    }

    @Test
    void improperRaysHitNothing() {
        checks.improperRaysHitNothing();
    }

    @Test
    void coincidentTriangles() {
        checks.coincidentTriangles();
    }

    @Test
    void answersDoNotDependOnThreads() {
        checks.answersDoNotDependOnThreads();
    }

    @Test
    void kernelAndColdTraversalGiveTheSameBits() {
        ColdTraversalChecks.sameBits(
                set -> new ColdTraversal(WideBvh.build(set, 512 / 32, 1), 512 / 32), set -> PROVIDER.build(set, 1));
    }

    @Test
    void queriesAllocateNothing() {
        checks.queriesAllocateNothing();
    }
}
