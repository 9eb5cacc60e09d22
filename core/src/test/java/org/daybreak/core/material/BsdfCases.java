package org.daybreak.core.material;

import java.util.List;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;

/** The materials and directions that the tests of the common contract run over. */
final class BsdfCases {
    /** A material with a name for messages. */
    record Case(String name, Bsdf bsdf) {}

    /** A unit vector with a name for messages. */
    record Direction(String name, double x, double y, double z) {}

    private static final List<Case> ALL = build();

    private BsdfCases() {}

    static SurfacePoint point() {
        SurfacePoint point = new SurfacePoint();
        point.sx = 1;
        point.ty = 1;
        point.nz = 1;
        point.gz = 1;
        point.u = 0.3;
        point.v = 0.8;
        return point;
    }

    static Texture white() {
        return ConstantTexture.grey(1);
    }

    static Texture tint() {
        return new ConstantTexture(0.75, 0.5, 0.9);
    }

    static Texture base() {
        return new ConstantTexture(0.8, 0.4, 0.1);
    }

    static Spectrum eta() {
        return new Spectrum(0.2, 0.9, 1.4);
    }

    static Spectrum k() {
        return new Spectrum(3.9, 2.4, 1.6);
    }

    /** Every kind of material, some with several parameters. */
    static List<Case> all() {
        return ALL;
    }

    private static List<Case> build() {
        Bsdf diffuse = new Diffuse(base());
        Bsdf ggx = rough(Microfacet.Kind.GGX, 0.3);
        Bsdf plastic = new Plastic(1.5, 1, base(), tint(), false);
        return List.of(
                new Case("diffuse", diffuse),
                new Case(
                        "textured diffuse",
                        new Diffuse(new CheckerboardTexture(base(), tint(), new double[] {1, 0, 0, 0, 1, 0}))),
                new Case("conductor", new Conductor(eta(), k(), tint())),
                new Case("mirror", Conductor.mirror(tint())),
                new Case("ggx 0.05", rough(Microfacet.Kind.GGX, 0.05)),
                new Case("ggx 0.3", ggx),
                new Case("ggx 1", rough(Microfacet.Kind.GGX, 1)),
                new Case("beckmann 0.05", rough(Microfacet.Kind.BECKMANN, 0.05)),
                new Case("beckmann 0.3", rough(Microfacet.Kind.BECKMANN, 0.3)),
                new Case("beckmann 1", rough(Microfacet.Kind.BECKMANN, 1)),
                new Case("dielectric", new Dielectric(1.5, 1, tint(), base())),
                new Case("thin-to-dense dielectric", new Dielectric(1, 1.33, tint(), base())),
                new Case("plastic", plastic),
                new Case("nonlinear plastic", new Plastic(1.9, 1.1, base(), tint(), true)),
                new Case("plastic thinner than the outside", new Plastic(1, 1.4, base(), tint(), false)),
                new Case(
                        "rough plastic ggx", new RoughPlastic(Microfacet.Kind.GGX, 0.2, 1.5, 1, base(), tint(), false)),
                new Case(
                        "rough plastic beckmann",
                        new RoughPlastic(Microfacet.Kind.BECKMANN, 0.4, 1.9, 1, base(), tint(), true)),
                new Case("two-sided", new TwoSided(ggx, plastic)),
                new Case("masked plastic", new Mask(ConstantTexture.grey(0.35), plastic)),
                new Case("masked two-sided", new Mask(ConstantTexture.grey(0.6), new TwoSided(diffuse, ggx))),
                new Case(
                        "masked dielectric",
                        new Mask(ConstantTexture.grey(0.6), new Dielectric(1.5, 1, tint(), base()))));
    }

    /** Both sides, along the normal, oblique and grazing. */
    static List<Direction> directions() {
        return List.of(
                direction("along the normal", 0, 0),
                direction("oblique", 0.7, 0.4),
                direction("steep", 1.3, -2.5),
                direction("grazing", 1.565, 1.9),
                direction("oblique from behind", Math.PI - 0.9, -0.8),
                direction("grazing from behind", Math.PI - 1.56, 2.2),
                direction("along the reverse normal", Math.PI, 0));
    }

    private static Bsdf rough(Microfacet.Kind kind, double alpha) {
        return new RoughConductor(kind, alpha, eta(), k(), tint());
    }

    private static Direction direction(String name, double theta, double phi) {
        double sin = Math.sin(theta);
        return new Direction(name, sin * Math.cos(phi), sin * Math.sin(phi), Math.cos(theta));
    }
}
