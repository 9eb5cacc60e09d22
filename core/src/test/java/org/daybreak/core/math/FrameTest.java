package org.daybreak.core.math;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.daybreak.core.sampling.Warps;
import org.junit.jupiter.api.Test;

class FrameTest {
    private static final double[][] AXES = {
        {0, 0, 1},
        {0, 0, -1},
        {1, 0, 0},
        {-1, 0, 0},
        {0, 1, 0},
        {0, -1, 0},
        {1, 0, -0.0},
        {1e-9, 0, -1},
        {0, 1e-300, -1}
    };

    @Test
    void isOrthonormalAndRightHandedForEveryNormal() {
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        Frame frame = new Frame();
        double[] normal = new double[3];
        for (int i = 0; i < 10_000; i++) {
            Warps.toUniformSphere(random.nextDouble(), random.nextDouble(), normal);
            frame.set(normal[0], normal[1], normal[2]);
            assertOrthonormal(frame);
        }
        for (double[] axis : AXES) {
            frame.set(axis[0], axis[1], axis[2]);
            assertOrthonormal(frame);
        }
    }

    @Test
    void keepsTheDirectionOfTheTangent() {
        Frame frame = new Frame();
        frame.set(0, 0, 1, 3, 4, 12);
        assertOrthonormal(frame);
        assertEquals(0.6, frame.sx, 1e-15);
        assertEquals(0.8, frame.sy, 1e-15);
        assertEquals(0, frame.sz);
    }

    @Test
    void survivesUselessTangents() {
        Frame frame = new Frame();
        double[][] tangents = {{0, 0, 0}, {0.36, 0.48, 0.8}, {-36, -48, -80}, {Double.NaN, 0, 0}, {1e300, 0, 0}};
        for (double[] tangent : tangents) {
            frame.set(0.36, 0.48, 0.8, tangent[0], tangent[1], tangent[2]);
            assertOrthonormal(frame);
        }
    }

    @Test
    void localAndWorldAreInverse() {
        Frame frame = new Frame();
        frame.set(0.36, -0.48, 0.8);
        double[] v = new double[3];
        frame.toLocal(0.36, -0.48, 0.8, v);
        assertArrayEquals(new double[] {0, 0, 1}, v, 1e-15);
        frame.toLocal(1, 2, 3, v);
        frame.toWorld(v[0], v[1], v[2], v);
        assertArrayEquals(new double[] {1, 2, 3}, v, 1e-14);
    }

    private static void assertOrthonormal(Frame f) {
        assertEquals(1, f.sx * f.sx + f.sy * f.sy + f.sz * f.sz, 1e-14);
        assertEquals(1, f.tx * f.tx + f.ty * f.ty + f.tz * f.tz, 1e-14);
        assertEquals(0, f.sx * f.tx + f.sy * f.ty + f.sz * f.tz, 1e-14);
        assertEquals(0, f.sx * f.nx + f.sy * f.ny + f.sz * f.nz, 1e-14);
        assertEquals(0, f.tx * f.nx + f.ty * f.ny + f.tz * f.nz, 1e-14);
        double determinant = f.nx * (f.sy * f.tz - f.sz * f.ty)
                + f.ny * (f.sz * f.tx - f.sx * f.tz)
                + f.nz * (f.sx * f.ty - f.sy * f.tx);
        assertEquals(1, determinant, 1e-14);
    }
}
