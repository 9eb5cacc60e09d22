package org.daybreak.core.accel;

import org.daybreak.core.testing.IntersectorChecks;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class ScalarIntersectorTest {
    private final IntersectorChecks checks = new IntersectorChecks(new ScalarProvider());

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
    void queriesAllocateNothing() {
        checks.queriesAllocateNothing();
    }
}
