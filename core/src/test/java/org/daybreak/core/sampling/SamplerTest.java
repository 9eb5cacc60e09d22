package org.daybreak.core.sampling;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.stream.Stream;
import org.daybreak.core.testing.ChiSquareTest;
import org.daybreak.core.testing.Moments;
import org.daybreak.core.testing.ZTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

class SamplerTest {
    /** False-alarm rate of each statistical assertion. */
    private static final double SIGNIFICANCE = 1e-4;

    static Stream<Sampler> samplers() {
        return Stream.of(
                new IndependentSampler(1, StreamDomain.PIXEL),
                new SobolSampler(1, StreamDomain.PIXEL, 1),
                new SobolSampler(1, StreamDomain.PIXEL, 2),
                new SobolSampler(1, StreamDomain.PIXEL, 4),
                new SobolSampler(1, StreamDomain.PIXEL, 16));
    }

    @ParameterizedTest
    @MethodSource("samplers")
    void everyNumberHasAnAddress(Sampler sampler) {
        double[][] numbers = new double[6][40];
        for (int s = 0; s < numbers.length; s++) {
            sampler.start(100 + s / 3, s);
            for (int d = 0; d < 40; d++) {
                assertEquals(d, sampler.dimension());
                numbers[s][d] = sampler.next();
                assertTrue(numbers[s][d] >= 0 && numbers[s][d] < 1);
            }
        }
        Sampler copy = sampler.copy();
        for (int s = numbers.length - 1; s >= 0; s--) {
            copy.start(100 + s / 3, s);
            for (int d = 39; d >= 0; d--) {
                copy.setDimension(d);
                assertEquals(d, copy.dimension());
                assertEquals(numbers[s][d], copy.next());
                assertEquals(d + 1, copy.dimension());
            }
            copy.setDimension(13);
            for (int d = 13; d < 40; d++) {
                assertEquals(numbers[s][d], copy.next());
            }
        }
    }

    @ParameterizedTest
    @MethodSource("samplers")
    void neighbouringPixelsDimensionsAndSamplesAreUncorrelatedOverPixels(Sampler sampler) {
        int n = 100_000;
        int dimensions = 8;
        int[] sampleIndices = {0, 1, 2, 7};
        double[][] values = new double[sampleIndices.length * dimensions][n];
        for (int pixel = 0; pixel < n; pixel++) {
            for (int s = 0; s < sampleIndices.length; s++) {
                sampler.start(pixel, sampleIndices[s]);
                for (int d = 0; d < dimensions; d++) {
                    values[s * dimensions + d][pixel] = Math.sqrt(12) * (sampler.next() - 0.5);
                }
            }
        }
        double[] pValues = new double[2 * values.length + dimensions * (dimensions - 1) / 2 * sampleIndices.length];
        int p = 0;
        for (int i = 0; i < values.length; i++) {
            Moments mean = new Moments();
            Moments neighbour = new Moments();
            for (int pixel = 0; pixel + 1 < n; pixel++) {
                mean.add(values[i][pixel]);
                neighbour.add(values[i][pixel] * values[i][pixel + 1]);
            }
            pValues[p++] = ZTest.known(mean.mean(), 1 / Math.sqrt(n - 1), 0);
            pValues[p++] = ZTest.known(neighbour.mean(), 1 / Math.sqrt(n - 1), 0);
        }
        // Within a sample all dimensions are independent over pixels; between samples of a dimension they are not.
        for (int s = 0; s < sampleIndices.length; s++) {
            for (int i = 0; i < dimensions; i++) {
                for (int j = 0; j < i; j++) {
                    Moments product = new Moments();
                    for (int pixel = 0; pixel < n; pixel++) {
                        product.add(values[s * dimensions + i][pixel] * values[s * dimensions + j][pixel]);
                    }
                    pValues[p++] = ZTest.known(product.mean(), 1 / Math.sqrt(n), 0);
                }
            }
        }
        assertEquals(pValues.length, p);
        ZTest.assertNoneRejected("means and correlations", pValues, SIGNIFICANCE);
    }

    @ParameterizedTest
    @MethodSource("samplers")
    void aSingleSampleIsUniformOverPixels(Sampler sampler) {
        long[] counts = new long[64 * 64];
        int n = 400_000;
        for (int pixel = 0; pixel < n; pixel++) {
            sampler.start(pixel, 3);
            sampler.setDimension(5);
            int row = (int) (sampler.next() * 64);
            int column = (int) (sampler.next() * 64);
            counts[64 * row + column]++;
        }
        double[] expected = new double[counts.length];
        Arrays.fill(expected, n / 4096.0);
        ZTest.assertNotRejected(
                "uniform pairs",
                ChiSquareTest.compare("pairs", counts, expected).pValue(),
                SIGNIFICANCE);
    }

    @ParameterizedTest
    @MethodSource("samplers")
    void branchesAreTheSamplesOfADenserSet(Sampler sampler) {
        Sampler dense = sampler.copy();
        for (int sample = 0; sample < 5; sample++) {
            for (int branch = 0; branch < 3; branch++) {
                sampler.start(7, sample);
                sampler.next();
                sampler.branch(branch, 3);
                dense.start(7, 3 * sample + branch);
                for (int d = 0; d < 6; d++) {
                    assertEquals(dense.next(), sampler.next());
                }
            }
            // The sample itself is not lost.
            sampler.branch(0, 1);
            dense.start(7, sample);
            assertEquals(dense.next(), sampler.next());
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {2, 3, 4, 8, 16})
    void everyBlockOfSamplesIsANetInEachGroup(int groupSize) {
        SobolSampler sampler = new SobolSampler(5, StreamDomain.PIXEL, groupSize);
        int[][] points = new int[3 * groupSize][1 << 8];
        for (int pixel = 0; pixel < 4; pixel++) {
            for (int i = 0; i < 1 << 8; i++) {
                sampler.start(pixel, i);
                for (int[] coordinates : points) {
                    coordinates[i] = (int) (long) (sampler.next() * 0x1p32);
                }
            }
            for (int d = 0; d < points.length; d++) {
                Nets.assertNet(4, 0, 16, points[d]);
            }
            for (int group = 0; group < 3; group++) {
                int d = group * groupSize;
                for (int m = 0; m <= 8; m++) {
                    Nets.assertNet(m, 0, 1 << (8 - m), points[d], points[d + 1]);
                }
                if (groupSize >= 4) {
                    Nets.assertNet(8, 3, 1, points[d], points[d + 1], points[d + 2], points[d + 3]);
                }
            }
        }
    }

    @Test
    void sobolNumbersAreThePinnedOnes() {
        // From an independent implementation (Python), with the second dimension from Pascal's triangle.
        double[] expected = {
            0.47020788736925323,
            0.740494242128591,
            0.35677684921824626,
            0.004773047747060111,
            0.5265464880074902,
            0.8570712652981968
        };
        SobolSampler sampler = new SobolSampler(7, StreamDomain.PIXEL, 2);
        sampler.start(1000, 5);
        for (double value : expected) {
            assertEquals(value, sampler.next());
        }
    }

    @Test
    void lowerBitsAreUniformToo() {
        SobolSampler sampler = new SobolSampler(7, StreamDomain.PIXEL, 4);
        int n = 1 << 17;
        int[] ones = new int[53];
        for (int i = 0; i < n; i++) {
            sampler.start(i / 64, i % 64);
            long bits = (long) (sampler.next() * 0x1p53);
            for (int b = 0; b < 53; b++) {
                ones[b] += (int) (bits >>> b & 1);
            }
        }
        double[] pValues = new double[53];
        for (int b = 0; b < 47; b++) {
            pValues[b] = ZTest.known(ones[b], Math.sqrt(n / 4.0), n / 2.0);
        }
        // The 6 leading bits are stratified by the 64 samples of each pixel, so exactly half of them are set.
        for (int b = 47; b < 53; b++) {
            pValues[b] = ones[b] == n / 2 ? 1 : 0;
        }
        ZTest.assertNoneRejected("ones among the bits", pValues, SIGNIFICANCE);
    }

    @Test
    void sobolIsUnbiasedAndConvergesFasterWithinAGroup() {
        double previous = 1;
        for (int n : new int[] {4, 16, 64, 256}) {
            double ratio = varianceRatio(4, n);
            // 2000 runs know a variance to 3 %.
            assertTrue(ratio < 0.5 * previous, "variance ratio " + ratio + " at n = " + n);
            previous = ratio;
        }
    }

    @Test
    void sobolIsUnbiasedAndConvergesFasterOverGroups() {
        // What depends on dimensions of both groups jointly converges as with independent samples. Its share of the
        // variance, with a = 0.16/12 for each factor, is ((1+a)⁴ − 1)((1+a)² − 1) / ((1+a)⁶ − 1) = 0.0178.
        double ratio = varianceRatio(6, 256);
        assertTrue(ratio > 0.0178 * 0.85 && ratio < 0.0178 * 2, "variance ratio " + ratio);
    }

    @Test
    void seedsAndDomainsDiffer() {
        for (Sampler[] pair : new Sampler[][] {
            {new SobolSampler(1, StreamDomain.PIXEL, 4), new SobolSampler(2, StreamDomain.PIXEL, 4)},
            {new SobolSampler(1, StreamDomain.PIXEL, 4), new SobolSampler(1, StreamDomain.LENS, 4)},
            {new IndependentSampler(1, StreamDomain.PIXEL), new IndependentSampler(2, StreamDomain.PIXEL)},
        }) {
            pair[0].start(9, 9);
            pair[1].start(9, 9);
            assertNotEquals(pair[0].next(), pair[1].next());
        }
    }

    @Test
    void limitsAreChecked() {
        assertThrows(IllegalArgumentException.class, () -> new SobolSampler(1, StreamDomain.PIXEL, 0));
        assertThrows(IllegalArgumentException.class, () -> new SobolSampler(1, StreamDomain.PIXEL, 17));
        SobolSampler sampler = new SobolSampler(1, StreamDomain.PIXEL, 4);
        sampler.start(0, (1L << 32) - 1);
        assertThrows(IllegalArgumentException.class, () -> sampler.start(0, 1L << 32));
        assertThrows(IllegalArgumentException.class, () -> sampler.start(0, -1));
    }

    /** Ratio of the variance of the estimate by Sobol′ points to that by independent ones, after a test of both means. */
    private static double varianceRatio(int dimensions, int n) {
        Moments sobol = new Moments();
        Moments independent = new Moments();
        for (int pixel = 0; pixel < 2000; pixel++) {
            sobol.add(estimate(new SobolSampler(3, StreamDomain.PIXEL, 4), pixel, dimensions, n));
            independent.add(estimate(new IndependentSampler(3, StreamDomain.PIXEL), pixel, dimensions, n));
        }
        ZTest.assertNotRejected("Sobol′, n = " + n, ZTest.oneSample(sobol, 1), SIGNIFICANCE);
        ZTest.assertNotRejected("independent, n = " + n, ZTest.oneSample(independent, 1), SIGNIFICANCE);
        return sobol.variance() / independent.variance();
    }

    /** The mean of n values of a smooth product over the first dimensions, whose integral is 1. */
    private static double estimate(Sampler sampler, int pixel, int dimensions, int n) {
        double sum = 0;
        for (int i = 0; i < n; i++) {
            sampler.start(pixel, i);
            double product = 1;
            for (int d = 0; d < dimensions; d++) {
                product *= 1 + 0.4 * (sampler.next() - 0.5);
            }
            sum += product;
        }
        return sum / n;
    }
}
