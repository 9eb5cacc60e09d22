package org.daybreak.core.material;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.BitmapTexture.Filter;
import org.daybreak.core.material.BitmapTexture.Wrap;
import org.junit.jupiter.api.Test;

/** Products, thresholds, and images that continue differently along u and v. */
class CombinedTexturesTest {
    private static final double[] IDENTITY = {1, 0, 0, 0, 1, 0};
    /** Rows 0.1 0.2 and 0.3 0.4. */
    private static final TextureImage FOUR = TextureImage.fromFloats(2, 2, 1, new float[] {0.1f, 0.2f, 0.3f, 0.4f});

    private final SurfacePoint point = new SurfacePoint();
    private final Spectrum out = new Spectrum();

    private double at(Texture texture, double u, double v) {
        point.u = u;
        point.v = v;
        return texture.component(point, 0);
    }

    @Test
    void productsMultiplyComponents() {
        Texture product = new ProductTexture(new ConstantTexture(0.5, 1, 0.25), new ConstantTexture(0.5, 0.125, 2));
        product.evaluate(point, out);
        assertEquals(0.25, out.r);
        assertEquals(0.125, out.g);
        assertEquals(0.5, out.b);
        assertEquals(0.125, product.component(point, 1));
        assertEquals(Spectrum.luminance(0.25, 0.125, 0.5), product.evaluateScalar(point), 1e-15);
        assertEquals(2, product.maximum());
        assertTrue(product.isConstant());
        product.mean(out);
        assertEquals(0.5, out.b);
        assertFalse(new ProductTexture(
                        new BitmapTexture(FOUR, Filter.NEAREST, Wrap.CLAMP, IDENTITY), ConstantTexture.grey(1))
                .isConstant());
    }

    @Test
    void thresholdsCutAtTheirValue() {
        Texture cut = new ThresholdTexture(new BitmapTexture(FOUR, Filter.NEAREST, Wrap.CLAMP, IDENTITY), 0.3f);
        assertEquals(0, at(cut, 0.25, 0.25));
        assertEquals(0, at(cut, 0.75, 0.25));
        assertEquals(1, at(cut, 0.25, 0.75));
        assertEquals(1, at(cut, 0.75, 0.75));
        assertEquals(1, cut.maximum());
        assertEquals(0, new ThresholdTexture(ConstantTexture.grey(0.5), 0.6).maximum());
    }

    @Test
    void imagesContinueAsEachAxisSays() {
        Texture image = new BitmapTexture(FOUR, Filter.NEAREST, Wrap.CLAMP, Wrap.MIRROR, IDENTITY, false);
        assertEquals(0.2f, at(image, 1.25, 0.25));
        assertEquals(0.1f, at(image, -3, 0.25));
        assertEquals(0.3f, at(image, 0.25, 1.25));
        assertEquals(0.1f, at(image, 0.25, 1.75));
        Texture repeated = new BitmapTexture(FOUR, Filter.NEAREST, Wrap.REPEAT, Wrap.CLAMP, IDENTITY, false);
        assertEquals(0.1f, at(repeated, 1.25, 0.25));
        assertEquals(0.3f, at(repeated, 1.25, 1.25));
    }

    /** A normal that leans to green looks brighter from that side: up along t, or against v where v runs along t. */
    @Test
    void greenOfNormalMapsMayGoAgainstV() {
        Texture tilted = new ConstantTexture(0.5, 0.75, 0.9);
        point.nz = 1;
        point.gz = 1;
        point.sx = 1;
        point.ty = 1;
        point.uAlongS = 1;
        Bsdf diffuse = new Diffuse(ConstantTexture.grey(0.8));
        for (double vAlongT : new double[] {-1, 1}) {
            point.vAlongT = vAlongT;
            double left = value(new NormalMap(tilted, diffuse, false), 0.3);
            double right = value(new NormalMap(tilted, diffuse, false), -0.3);
            assertTrue(left > right);
            Bsdf against = new NormalMap(tilted, 1, true, diffuse, false);
            assertEquals(vAlongT < 0 ? left : right, value(against, 0.3), 1e-12);
            assertEquals(value(diffuse, 0.3), value(new NormalMap(tilted, 0, true, diffuse, false), 0.3), 1e-12);
        }
    }

    /** The slope of a bump map over the surface is the same in whatever way the frame lies. */
    @Test
    void bumpsDoNotTurnWithTheFrame() {
        BumpMap bump = new BumpMap(
                new BitmapTexture(FOUR, Filter.BILINEAR, Wrap.CLAMP, IDENTITY),
                0.3,
                new Diffuse(ConstantTexture.grey(0.8)),
                false);
        point.u = 0.4;
        point.v = 0.6;
        point.nz = 1;
        point.sx = 1;
        point.ty = 1;
        point.uAlongS = 2;
        point.vAlongS = 0.5;
        point.vAlongT = -3;
        double x = bump.slopeS(point);
        double y = bump.slopeT(point);
        // ∂h/∂u = 0.3·0.2, ∂h/∂v = 0.3·0.4.
        assertEquals(0.06, 2 * x, 1e-7);
        assertEquals(0.12, 0.5 * x - 3 * y, 1e-7);
        point.turnFrame(-0.3, 0.7, 4);
        assertEquals(x, bump.slopeS(point) * point.sx + bump.slopeT(point) * point.tx, 1e-12);
        assertEquals(y, bump.slopeS(point) * point.sy + bump.slopeT(point) * point.ty, 1e-12);
    }

    private double value(Bsdf bsdf, double y) {
        bsdf.evaluate(point, 0, 0, 1, 0, y, Math.sqrt(1 - y * y), TransportMode.RADIANCE, out);
        return out.r;
    }
}
