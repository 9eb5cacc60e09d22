package org.daybreak.core.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class SobolTest {
    /**
     * Index, then the coordinates of 16 dimensions. Produced with SobolSequenceGenerator of Apache Commons Math 3.6.1,
     * which reads the published file new-joe-kuo-6, at the inverse Gray code of the index.
     */
    private static final int[][] REFERENCE = {
        {
            1,
            0x80000000,
            0x80000000,
            0x80000000,
            0x80000000,
            0x80000000,
            0x80000000,
            0x80000000,
            0x80000000,
            0x80000000,
            0x80000000,
            0x80000000,
            0x80000000,
            0x80000000,
            0x80000000,
            0x80000000,
            0x80000000
        },
        {
            2,
            0x40000000,
            0xC0000000,
            0xC0000000,
            0xC0000000,
            0x40000000,
            0x40000000,
            0xC0000000,
            0x40000000,
            0x40000000,
            0x40000000,
            0x40000000,
            0x40000000,
            0xC0000000,
            0xC0000000,
            0x40000000,
            0xC0000000
        },
        {
            5,
            0xA0000000,
            0x20000000,
            0xE0000000,
            0xA0000000,
            0xA0000000,
            0xE0000000,
            0x20000000,
            0x20000000,
            0x20000000,
            0x60000000,
            0x20000000,
            0xA0000000,
            0x20000000,
            0xE0000000,
            0xA0000000,
            0xA0000000
        },
        {
            100,
            0x26000000,
            0xC6000000,
            0xB2000000,
            0xF6000000,
            0x86000000,
            0x12000000,
            0x0A000000,
            0x96000000,
            0x1E000000,
            0xFE000000,
            0x52000000,
            0x1A000000,
            0xCE000000,
            0xE6000000,
            0xEE000000,
            0xA2000000
        },
        {
            1000,
            0x17C00000,
            0x29400000,
            0x73400000,
            0xE8C00000,
            0xFE400000,
            0x29C00000,
            0x04400000,
            0xA3C00000,
            0xFFC00000,
            0x1F400000,
            0x3B400000,
            0xFCC00000,
            0x23C00000,
            0xEEC00000,
            0xE1400000,
            0x04400000
        },
        {
            65537,
            0x80008000,
            0x00008000,
            0x68808000,
            0xA08F8000,
            0xA2878000,
            0xC8008000,
            0x46788000,
            0x9A248000,
            0x72B28000,
            0x8A3A8000,
            0xBE0D8000,
            0xEE138000,
            0x95868000,
            0xFA038000,
            0xEBA28000,
            0x55A78000
        },
        {
            123456,
            0x02478000,
            0x73598000,
            0xCA678000,
            0x52C48000,
            0xD95A8000,
            0x8C098000,
            0x401D8000,
            0xAF9B8000,
            0xEFA98000,
            0x85658000,
            0x671C8000,
            0x46B68000,
            0x9FC38000,
            0xCE408000,
            0x42DB8000,
            0x38C08000
        },
    };

    @Test
    void pointsAreThePublishedOnes() {
        for (int[] row : REFERENCE) {
            for (int dimension = 0; dimension < Sobol.DIMENSIONS; dimension++) {
                assertEquals(row[1 + dimension], Sobol.sobol(row[0], dimension), row[0] + ", dimension " + dimension);
            }
        }
    }

    @Test
    void pointsAreLinearInTheIndex() {
        for (int dimension = 0; dimension < Sobol.DIMENSIONS; dimension++) {
            assertEquals(0, Sobol.sobol(0, dimension));
            assertEquals(
                    Sobol.sobol(0xC0000000, dimension) ^ Sobol.sobol(0x00123456, dimension),
                    Sobol.sobol(0xC0123456, dimension));
        }
    }

    @Test
    void everyDimensionIsStratifiedAtEveryPower() {
        for (int dimension = 0; dimension < Sobol.DIMENSIONS; dimension++) {
            Nets.assertNet(12, 0, 1, sampleOf(dimension));
        }
    }

    @Test
    void firstTwoDimensionsAreNets() {
        int[] x = sampleOf(0);
        int[] y = sampleOf(1);
        for (int m = 0; m <= 12; m++) {
            Nets.assertNet(m, 0, 1, x, y);
        }
    }

    @Test
    void firstFourDimensionsAreNetsOfTheirQuality() {
        // t = Σ (degree − 1) over the dimensions: 0 + 0 + 1 + 2 (Niederreiter 1992).
        Nets.assertNet(10, 3, 1, sampleOf(0), sampleOf(1), sampleOf(2), sampleOf(3));
    }

    private static int[] sampleOf(int dimension) {
        int[] points = new int[1 << 12];
        for (int i = 0; i < points.length; i++) {
            points[i] = Sobol.sobol(i, dimension);
        }
        return points;
    }
}
