package org.daybreak.core.math;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.stream.Stream;
import javax.vecmath.Matrix4d;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class TransformTest {
    static Stream<Transform> transforms() {
        return Stream.of(
                Transform.identity(),
                Transform.translate(1, -2, 3),
                Transform.scale(2, 3, -4),
                Transform.rotate(1, 2, 3, 40),
                Transform.lookAt(1, 2, 3, -4, 0, 2, 0, 1, 0),
                Transform.ofRows(1, 0.5, 0.25, 7, 0, 2, -1, 8, 0.125, 0, -3, 9),
                Transform.translate(1, -2, 3)
                        .multiply(Transform.rotate(0, 1, 0, 30))
                        .multiply(Transform.scale(1e-3, 2, 5)),
                Transform.scale(1e-150, 1e-150, 1e-150),
                Transform.scale(1e50, 1e-20, 1));
    }

    @ParameterizedTest
    @MethodSource("transforms")
    void inverseUndoesPointsAndVectors(Transform transform) {
        double[] v = new double[3];
        transform.applyPoint(0.5, -1.5, 2.5, v);
        transform.inverse().applyPoint(v[0], v[1], v[2], v);
        assertArrayEquals(new double[] {0.5, -1.5, 2.5}, v, 1e-10);
        transform.applyVector(0.5, -1.5, 2.5, v);
        transform.applyInverseVector(v[0], v[1], v[2], v);
        assertArrayEquals(new double[] {0.5, -1.5, 2.5}, v, 1e-10);
        transform.inverse().applyPoint(0.5, -1.5, 2.5, v);
        double[] w = new double[3];
        transform.applyInversePoint(0.5, -1.5, 2.5, w);
        assertArrayEquals(w, v);
        assertEquals(transform, transform.inverse().inverse());
        assertEquals(transform.isMirroring(), transform.inverse().isMirroring());
    }

    @ParameterizedTest
    @MethodSource("transforms")
    void normalsStayOrthogonalToTangents(Transform transform) {
        double[] tangent = new double[3];
        double[] normal = new double[3];
        // (1, 2, 2) · (2, 1, −2) = 0
        transform.applyVector(1, 2, 2, tangent);
        transform.applyNormal(2, 1, -2, normal);
        double dot = 0;
        double size = 0;
        for (int i = 0; i < 3; i++) {
            dot += tangent[i] * normal[i];
            size += Math.abs(tangent[i] * normal[i]);
        }
        assertEquals(0, dot, 1e-14 * size);
    }

    @Test
    void productAppliesTheRightFactorFirst() {
        Transform product = Transform.translate(1, 0, 0).multiply(Transform.scale(2, 2, 2));
        double[] v = new double[3];
        product.applyPoint(1, 1, 1, v);
        assertArrayEquals(new double[] {3, 2, 2}, v);
        product.applyVector(1, 1, 1, v);
        assertArrayEquals(new double[] {2, 2, 2}, v);
        assertArrayEquals(new double[] {2, 0, 0, 1, 0, 2, 0, 0, 0, 0, 2, 0}, product.rows());
    }

    @Test
    void quarterTurnsAreExactAndCounterClockwise() {
        double[] v = new double[3];
        Transform.rotate(0, 0, 2, 90).applyPoint(1, 0, 0, v);
        assertArrayEquals(new double[] {0, 1, 0}, v);
        Transform.rotate(0, 1, 0, -270).applyPoint(0, 0, 1, v);
        assertArrayEquals(new double[] {1, 0, 0}, v);
        Transform.rotate(1, 0, 0, 540).applyPoint(0, 1, 2, v);
        assertArrayEquals(new double[] {0, -1, -2}, v);
        Transform.rotate(0, 0, 1, 30).applyPoint(1, 0, 0, v);
        assertArrayEquals(new double[] {Math.sqrt(0.75), 0.5, 0}, v, 1e-15);
    }

    @Test
    void lookAtHasLeftUpAndViewAsColumns() {
        Transform camera = Transform.lookAt(0, 0, 5, 0, 0, 0, 0, 3, 0);
        // Looking down −z with y up, the left of the picture is −x.
        assertArrayEquals(new double[] {-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 5}, camera.rows());
        assertFalse(camera.isMirroring());
        Transform oblique = Transform.lookAt(1, 2, 3, 2, 4, 5, 0, 0, 1);
        double[] v = new double[3];
        oblique.applyPoint(0, 0, 3, v);
        assertArrayEquals(new double[] {2, 4, 5}, v, 1e-14);
        oblique.applyVector(0, 1, 0, v);
        assertTrue(v[2] > 0);
        oblique.applyVector(1, 0, 0, v);
        assertEquals(0, v[2], 1e-15);
    }

    @Test
    void vecmathMatrixGoesThrough() {
        Matrix4d matrix = new Matrix4d(1, 2, 3, 4, 0, 5, 6, 7, 0, 0, 8, 9, 0, 0, 0, 1);
        assertEquals(matrix, Transform.of(matrix).toMatrix4d());
        matrix.m32 = 0.5;
        String message = assertThrows(IllegalArgumentException.class, () -> Transform.of(matrix))
                .getMessage();
        assertEquals("not an affine matrix: its last row is 0.0 0.0 0.5 1.0 instead of 0 0 0 1", message);
    }

    @Test
    void mirroringIsTheSignOfTheDeterminant() {
        assertTrue(Transform.scale(1, -1, 1).isMirroring());
        assertFalse(Transform.scale(-1, -1, 1).isMirroring());
        assertTrue(Transform.scale(-1e-100, 1e-100, 1e-100).isMirroring());
        assertTrue(Transform.rotate(1, 1, 0, 70)
                .multiply(Transform.scale(-2, -3, -4))
                .isMirroring());
    }

    @Test
    void singularAndUndefinedMatricesAreRefused() {
        assertMessage("singular", () -> Transform.scale(1, 0, 1));
        assertMessage("singular", () -> Transform.ofRows(1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9, 0));
        assertMessage("singular", () -> Transform.ofRows(new double[12]));
        // Rank 2 up to rounding, and turned, so that no entry is 0.
        assertMessage("singular", () -> Transform.ofRows(0.1, 0.2, 0.3, 0, 0.7, 0.1, 0.8, 0, 0.3, 0.6, 0.9, 0));
        assertMessage("infinite or undefined", () -> Transform.translate(Double.NaN, 0, 0));
        assertMessage("infinite or undefined", () -> Transform.scale(1, Double.POSITIVE_INFINITY, 1));
        assertMessage("12 entries", () -> Transform.ofRows(1, 2, 3));
        assertMessage("axis", () -> Transform.rotate(0, 0, 0, 10));
        assertMessage("degrees", () -> Transform.rotate(0, 0, 1, Double.NaN));
        assertMessage("view direction", () -> Transform.lookAt(1, 1, 1, 1, 1, 1, 0, 1, 0));
        assertMessage("parallel", () -> Transform.lookAt(0, 0, 0, 1, 2, 3, 2, 4, 6));
        assertMessage("parallel", () -> Transform.lookAt(0, 0, 0, 1, 2, 3, 0, 0, 0));
        assertMessage(
                "infinite", () -> Transform.scale(1e200, 1e200, 1e200).multiply(Transform.scale(1e200, 1e200, 1e200)));
    }

    @ParameterizedTest
    @ValueSource(doubles = {1e-4, 1e4, 1e-100, 1e100})
    void flatButInvertibleMapsAreAcceptedAtAnyScale(double scale) {
        Transform flat = Transform.rotate(1, 2, 3, 10).multiply(Transform.scale(scale, scale, scale * 1e-8));
        Transform again = Transform.ofRows(flat.rows());
        double[] v = new double[3];
        again.applyVector(1, 1, 1, v);
        again.applyInverseVector(v[0], v[1], v[2], v);
        assertArrayEquals(new double[] {1, 1, 1}, v, 1e-6);
    }

    private static void assertMessage(String part, Runnable action) {
        String message =
                assertThrows(IllegalArgumentException.class, action::run).getMessage();
        assertTrue(message.contains(part), message);
    }
}
