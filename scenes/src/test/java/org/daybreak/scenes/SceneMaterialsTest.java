package org.daybreak.scenes;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;

import java.io.IOException;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.daybreak.core.material.Conductor;
import org.daybreak.core.material.Dielectric;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.Mask;
import org.daybreak.core.material.Plastic;
import org.daybreak.core.material.RoughConductor;
import org.daybreak.core.material.RoughPlastic;
import org.daybreak.core.material.TwoSided;
import org.daybreak.scenes.description.SceneException;
import org.junit.jupiter.api.Test;

/** Materials and colours of scene files. */
class SceneMaterialsTest extends SceneReading {
    @Test
    void readsEveryMaterial() throws IOException, SceneException {
        assertInstanceOf(Diffuse.class, shape("<shape type='sphere'/>").material());
        assertInstanceOf(Conductor.class, material("<bsdf type='conductor'/>"));
        assertInstanceOf(Conductor.class, material("<bsdf type='conductor'><rgb name='eta' value='.1,.2,.3'/></bsdf>"));
        assertInstanceOf(RoughConductor.class, material("<bsdf type='roughconductor'/>"));
        assertInstanceOf(
                RoughConductor.class,
                material(
                        "<bsdf type='roughconductor'><float name='alpha_u' value='.3'/><float name='alpha_v' value='.3'/>"
                                + "<float name='eta' value='1.5'/><spectrum name='k' value='2'/></bsdf>"));
        assertInstanceOf(
                Dielectric.class,
                material("<bsdf type='dielectric'><string name='int_ior' value='Water Ice'/></bsdf>"));
        assertInstanceOf(Plastic.class, material("<bsdf type='plastic'/>"));
        assertInstanceOf(RoughPlastic.class, material("<bsdf type='roughplastic'/>"));
        assertInstanceOf(
                TwoSided.class, material("<bsdf type='twosided'><bsdf type='diffuse'/><bsdf type='plastic'/></bsdf>"));
        assertInstanceOf(
                Mask.class,
                material("<bsdf type='mask'><float name='opacity' value='.3'/><bsdf type='diffuse'/></bsdf>"));
    }

    private Object material(String bsdf) throws IOException, SceneException {
        return shape("<shape type='sphere'>" + bsdf + "</shape>").material();
    }

    private double[] albedo(String content) throws IOException, SceneException {
        Spectrum out = new Spectrum();
        shape("<shape type='sphere'>" + content + "</shape>").material().albedo(new SurfacePoint(), out);
        return new double[] {out.r, out.g, out.b};
    }

    @Test
    void readsColours() throws IOException, SceneException {
        assertArrayEquals(new double[] {0.5, 0.5, 0.5}, albedo("<bsdf type='diffuse'/>"), 1e-12);
        assertArrayEquals(new double[] {0, 0, 0}, albedo("<emitter type='area'/>"), 0, "an emitter without material");
        String diffuse = "<bsdf type='diffuse'><%s name='reflectance' value='%s'/></bsdf>";
        assertArrayEquals(new double[] {0.1, 0.2, 0.3}, albedo(String.format(diffuse, "rgb", "0.1, 0.2 0.3")), 1e-12);
        assertArrayEquals(new double[] {0.4, 0.4, 0.4}, albedo(String.format(diffuse, "rgb", "0.4")), 1e-12);
        assertArrayEquals(new double[] {0.4, 0.4, 0.4}, albedo(String.format(diffuse, "spectrum", "0.4")), 1e-12);
        assertArrayEquals(new double[] {0.4, 0.4, 0.4}, albedo(String.format(diffuse, "float", "0.4")), 1e-12);
        // IEC 61966-2-1: 128/255 is 0.21586 linear, 0.5 is 0.21404.
        assertArrayEquals(new double[] {1, 0.2158605, 0}, albedo(String.format(diffuse, "rgb", "#fF8000")), 1e-6);
        assertArrayEquals(new double[] {1, 0.2140411, 0}, albedo(String.format(diffuse, "srgb", "1 0.5 0")), 1e-6);
    }
}
