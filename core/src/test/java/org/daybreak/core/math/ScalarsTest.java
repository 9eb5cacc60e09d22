package org.daybreak.core.math;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.math.BigDecimal;
import org.daybreak.core.sampling.RandomStream;
import org.daybreak.core.sampling.StreamDomain;
import org.junit.jupiter.api.Test;

class ScalarsTest {
    @Test
    void differenceOfProductsSurvivesCancellation() {
        RandomStream random = new RandomStream(1, StreamDomain.SELF_CHECK, 0, 0);
        for (int i = 0; i < 10_000; i++) {
            double a = random.nextDouble();
            double b = random.nextDouble();
            double c = a * (1 + 1e-9 * random.nextDouble());
            double d = b * (1 - 1e-9 * random.nextDouble());
            double exact = new BigDecimal(a)
                    .multiply(new BigDecimal(b))
                    .subtract(new BigDecimal(c).multiply(new BigDecimal(d)))
                    .doubleValue();
            assertEquals(exact, Scalars.differenceOfProducts(a, b, c, d), 1.5 * Math.ulp(exact));
        }
    }

    @Test
    void clampedFunctionsAcceptRoundingNoise() {
        assertEquals(0, Scalars.sqrtClamped(-1e-17));
        assertEquals(3, Scalars.sqrtClamped(9));
        assertEquals(0, Scalars.acosClamped(Math.nextUp(1.0)));
        assertEquals(Math.PI, Scalars.acosClamped(Math.nextDown(-1.0)));
        assertTrue(Double.isNaN(Scalars.clamp(Double.NaN, 0, 1)));
    }

    @Test
    void lerpIsExactAtBothEnds() {
        assertEquals(0.1, Scalars.lerp(0, 0.1, 1e20));
        assertEquals(0.1, Scalars.lerp(1, 1e20, 0.1));
        assertEquals(2.5, Scalars.lerp(0.25, 2, 4));
    }

    @Test
    void densitiesConvertBothWays() {
        // A patch of area A at distance r, tilted by 60°, has the solid angle A · 0.5 / r².
        assertEquals(18, Densities.areaToSolidAngle(1, 9, -0.5));
        assertEquals(1, Densities.solidAngleToArea(18, 9, 0.5));
        assertEquals(0, Densities.areaToSolidAngle(1, 9, 0));
    }
}
