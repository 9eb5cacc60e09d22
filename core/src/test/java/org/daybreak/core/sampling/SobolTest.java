package org.daybreak.core.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;

class SobolTest {
    /**
     * Index, then the coordinates of 16 dimensions, hexadecimal. Produced with SobolSequenceGenerator of Apache Commons
     * Math 3.6.1, which reads the published file new-joe-kuo-6, at the inverse Gray code of the index.
     */
    private static final String REFERENCE = """
            1 80000000 80000000 80000000 80000000 80000000 80000000 80000000 80000000 \
              80000000 80000000 80000000 80000000 80000000 80000000 80000000 80000000
            2 40000000 C0000000 C0000000 C0000000 40000000 40000000 C0000000 40000000 \
              40000000 40000000 40000000 40000000 C0000000 C0000000 40000000 C0000000
            5 A0000000 20000000 E0000000 A0000000 A0000000 E0000000 20000000 20000000 \
              20000000 60000000 20000000 A0000000 20000000 E0000000 A0000000 A0000000
            100 26000000 C6000000 B2000000 F6000000 86000000 12000000 0A000000 96000000 \
              1E000000 FE000000 52000000 1A000000 CE000000 E6000000 EE000000 A2000000
            1000 17C00000 29400000 73400000 E8C00000 FE400000 29C00000 04400000 A3C00000 \
              FFC00000 1F400000 3B400000 FCC00000 23C00000 EEC00000 E1400000 04400000
            65537 80008000 00008000 68808000 A08F8000 A2878000 C8008000 46788000 9A248000 \
              72B28000 8A3A8000 BE0D8000 EE138000 95868000 FA038000 EBA28000 55A78000
            123456 02478000 73598000 CA678000 52C48000 D95A8000 8C098000 401D8000 AF9B8000 \
              EFA98000 85658000 671C8000 46B68000 9FC38000 CE408000 42DB8000 38C08000
            """;

    @Test
    void pointsAreThePublishedOnes() {
        for (String line : REFERENCE.lines().toList()) {
            String[] row = line.trim().split(" +", -1);
            int index = Integer.parseInt(row[0]);
            assertEquals(1 + Sobol.DIMENSIONS, row.length);
            for (int dimension = 0; dimension < Sobol.DIMENSIONS; dimension++) {
                int expected = Integer.parseUnsignedInt(row[1 + dimension], 16);
                assertEquals(expected, Sobol.sobol(index, dimension), index + ", dimension " + dimension);
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
