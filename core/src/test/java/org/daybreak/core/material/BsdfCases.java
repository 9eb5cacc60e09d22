package org.daybreak.core.material;

import java.util.ArrayList;
import java.util.List;
import org.daybreak.core.color.Spectrum;
import org.daybreak.core.geometry.SurfacePoint;
import org.jspecify.annotations.Nullable;

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
        point.uAlongS = 1.5;
        point.vAlongS = 0.25;
        point.vAlongT = -0.8;
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
        List<Case> list = new ArrayList<>(List.of(
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
                        new Mask(ConstantTexture.grey(0.6), new Dielectric(1.5, 1, tint(), base())))));
        addMicrofacets(list);
        addThin(list, diffuse);
        addPrincipled(list);
        addPhong(list);
        addAdapters(list, diffuse, ggx);
        addDeltaLobes(list, plastic);
        return List.copyOf(list);
    }

    private static void addMicrofacets(List<Case> list) {
        for (Microfacet.Kind kind : Microfacet.Kind.values()) {
            Roughness stretched = Roughness.of(ConstantTexture.grey(0.1), ConstantTexture.grey(0.5));
            list.add(
                    new Case("anisotropic conductor " + kind, new RoughConductor(kind, stretched, eta(), k(), tint())));
            list.add(new Case(
                    "rough dielectric " + kind, new RoughDielectric(kind, Roughness.of(0.25), 1.5, 1, tint(), base())));
            list.add(new Case(
                    "anisotropic dielectric " + kind, new RoughDielectric(kind, stretched, 1.33, 1.6, tint(), base())));
        }
        Texture checkers = new CheckerboardTexture(
                ConstantTexture.grey(0.2), ConstantTexture.grey(0.6), new double[] {1, 0, 0, 0, 1, 0});
        list.add(new Case(
                "textured roughness",
                new RoughDielectric(Microfacet.Kind.GGX, Roughness.of(checkers), 1.5, 1, white(), white())));
    }

    private static void addThin(List<Case> list, Bsdf diffuse) {
        list.add(new Case("thin dielectric", new ThinDielectric(1.5, 1, tint(), base())));
        list.add(new Case("diffuse transmitter", Leaf.transmitter(base())));
        Texture darker = new ConstantTexture(0.2, 0.3, 0.05);
        list.add(new Case("leaf", new Leaf(darker, darker, new ConstantTexture(0.4, 0.5, 0.3), darker)));
        list.add(new Case(
                "leaf of different transmittances",
                new Leaf(darker, darker, ConstantTexture.grey(0.1), new ConstantTexture(0.6, 0.1, 0.3))));
        list.add(
                new Case("masked leaf", new Mask(ConstantTexture.grey(0.7), new Leaf(darker, darker, darker, darker))));
        Texture checkers = new CheckerboardTexture(base(), tint(), new double[] {1, 0, 0, 0, 1, 0});
        list.add(new Case("leaf brighter than 1", new Leaf(checkers, tint(), checkers, tint())));
        list.add(new Case("blend with leaf", new Blend(ConstantTexture.grey(0.4), diffuse, Leaf.transmitter(base()))));
    }

    /** A principled material; the numbers are its parameters in order, without base colour and index. */
    static Principled principled(double eta, double... n) {
        return new Principled(new Principled.Parameters(
                base(),
                ConstantTexture.grey(n[0]),
                ConstantTexture.grey(n[1]),
                ConstantTexture.grey(n[2]),
                ConstantTexture.grey(n[3]),
                eta,
                ConstantTexture.grey(n[4]),
                ConstantTexture.grey(n[5]),
                ConstantTexture.grey(n[6]),
                ConstantTexture.grey(n[7]),
                ConstantTexture.grey(n[8]),
                ConstantTexture.grey(n[9])));
    }

    /** A thin principled material; the numbers are its parameters in order, without base colour and index. */
    static PrincipledThin principledThin(double eta, double... n) {
        return new PrincipledThin(new PrincipledThin.Parameters(
                base(),
                ConstantTexture.grey(n[0]),
                ConstantTexture.grey(n[1]),
                ConstantTexture.grey(n[2]),
                eta,
                ConstantTexture.grey(n[3]),
                ConstantTexture.grey(n[4]),
                ConstantTexture.grey(n[5]),
                ConstantTexture.grey(n[6]),
                ConstantTexture.grey(n[7])));
    }

    private static void addPrincipled(List<Case> list) {
        list.add(new Case("principled", principled(1.5, 0.5, 0, 0, 0, 0, 0, 0, 0, 0, 0)));
        list.add(new Case("principled metal", principled(1.5, 0.4, 0.7, 1, 0, 0, 0, 0, 0, 0, 0)));
        list.add(new Case("principled glass", principled(1.5, 0.45, 0.3, 0, 1, 0, 0, 0, 0, 0, 0)));
        list.add(new Case("principled coat", principled(1.5, 0.6, 0, 0.2, 0, 0.3, 0, 0, 0, 1, 0.2)));
        list.add(new Case("principled all", principled(1.4, 0.5, 0.5, 0.3, 0.4, 0.6, 0.7, 0.5, 0.4, 0.8, 0.1)));
        list.add(new Case("principled thinner than outside", principled(0.8, 0.5, 0, 0.3, 0.6, 0.5, 0, 0, 0, 0, 0)));
        list.add(new Case("principled thin", principledThin(1.5, 0.4, 0, 0.5, 0.4, 0.5, 0.3, 0.5, 0.4)));
        list.add(new Case("principled thin pane", principledThin(1.4, 0.5, 0.6, 1, 0, 0, 0, 0, 0)));
        list.add(new Case("principled thin paper", principledThin(1.5, 0.5, 0, 0, 0, 0, 0, 0, 0.5)));
    }

    private static Case phong(
            String name,
            double alpha,
            @Nullable Texture specular,
            double shininess,
            double transparency,
            double transparencyShininess,
            double ior) {
        Texture third = ConstantTexture.grey(0.3);
        return new Case(
                name,
                new GroimpPhong(
                        new GroimpPhong.Parameters(
                                new ConstantTexture(0.5, 0.3, 0.1),
                                ConstantTexture.grey(alpha),
                                specular,
                                ConstantTexture.grey(shininess),
                                new ConstantTexture(transparency, 0.5 * transparency, transparency),
                                ConstantTexture.grey(transparencyShininess),
                                third,
                                alpha < 1 || transparency > 0),
                        ior,
                        1));
    }

    private static void addPhong(List<Case> list) {
        Texture specular = new ConstantTexture(0.2, 0.3, 0.1);
        list.add(phong("phong", 1, specular, 0.4, 0, 1, 1));
        list.add(phong("phong without specular", 1, null, 0.4, 0, 1, 1.5));
        list.add(phong("phong mirror", 1, specular, 1, 0, 1, 1));
        list.add(phong("phong glass", 0.8, specular, 0.7, 0.6, 1, 1.5));
        list.add(phong("phong frosted glass", 0.8, specular, 0.7, 0.6, 0.6, 1.4));
        list.add(phong("phong frosted pane", 1, specular, 0.8, 0.7, 0.7, 1));
    }

    private static void addAdapters(List<Case> list, Bsdf diffuse, Bsdf ggx) {
        Bsdf glass = new RoughDielectric(Microfacet.Kind.GGX, Roughness.of(0.3), 1.5, 1, tint(), base());
        Texture half = ConstantTexture.grey(0.5);
        list.add(new Case("blend", new Blend(ConstantTexture.grey(0.3), ggx, diffuse)));
        list.add(new Case("blend with delta", new Blend(half, new Dielectric(1.5, 1, tint(), base()), glass)));
        list.add(new Case("blend with null", new Blend(ConstantTexture.grey(0.2), ggx, new NullBsdf())));
        list.add(new Case("null", new NullBsdf()));
        Texture tilted = new ConstantTexture(0.65, 0.4, 0.9);
        list.add(new Case("normal map", new NormalMap(tilted, diffuse, true)));
        list.add(new Case("normal map over glass", new NormalMap(tilted, glass, false)));
        list.add(new Case("normal map over mirror", new NormalMap(tilted, Conductor.mirror(tint()), true)));
        float[] heights = {0, 1, 0.5f, 0.25f};
        Texture bumps = new BitmapTexture(
                TextureImage.fromFloats(2, 2, 1, heights),
                BitmapTexture.Filter.BILINEAR,
                BitmapTexture.Wrap.REPEAT,
                new double[] {1, 0, 0, 0, 1, 0});
        list.add(new Case("bump map", new BumpMap(bumps, 0.2, diffuse, true)));
    }

    /** Wrappers of delta lobes, which number them anew. */
    private static void addDeltaLobes(List<Case> list, Bsdf plastic) {
        Bsdf glass = new Dielectric(1.5, 1, tint(), base());
        Bsdf pane = new ThinDielectric(1.4, 1, base(), tint());
        Bsdf metal = new Conductor(eta(), k(), white());
        Texture tilted = new ConstantTexture(0.65, 0.4, 0.9);
        list.add(new Case(
                "blend of mirror, glass and pane",
                new Blend(ConstantTexture.grey(0.7), metal, new Blend(ConstantTexture.grey(0.4), glass, pane))));
        list.add(new Case(
                "blend of mirror, null and plastic",
                new Blend(
                        ConstantTexture.grey(0.6),
                        new Blend(ConstantTexture.grey(0.5), metal, new NullBsdf()),
                        plastic)));
        list.add(new Case(
                "two-sided blend with mirror",
                new TwoSided(metal, new Blend(ConstantTexture.grey(0.3), metal, plastic))));
        list.add(new Case("normal map over smooth glass", new NormalMap(tilted, glass, true)));
        list.add(new Case(
                "normal map over masked blend",
                new NormalMap(
                        tilted,
                        new Mask(ConstantTexture.grey(0.7), new Blend(ConstantTexture.grey(0.5), plastic, pane)),
                        false)));
        Texture shininess =
                new CheckerboardTexture(ConstantTexture.grey(0.4), white(), new double[] {1, 0, 0, 0, 1, 0});
        list.add(new Case(
                "phong mirror in places",
                new GroimpPhong(
                        new GroimpPhong.Parameters(
                                base(),
                                ConstantTexture.grey(0.5),
                                tint(),
                                shininess,
                                tint(),
                                shininess,
                                ConstantTexture.grey(0.1),
                                false),
                        1.3,
                        1)));
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
