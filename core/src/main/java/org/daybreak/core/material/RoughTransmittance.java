package org.daybreak.core.material;

/**
 * How much light a rough dielectric interface lets through, by the angle of incidence, single scattering: a table by
 * deterministic quadrature at construction. Immutable.
 */
final class RoughTransmittance {
    /** Intervals in √cos θ, which spends them where the table bends: at grazing angles. */
    private static final int INTERVALS = 96;

    /** Total internal reflection off some of the facets makes the integrand discontinuous: that takes more nodes. */
    private static final int NODES_INTO_THINNER = 80;

    private static final int NODES_INTO_DENSER = 24;

    private final double[] table;
    private final double hemispherical;

    /**
     * Builds the table for light from the outer side.
     *
     * @param eta refractive index of the transmitted side over that of the incident side
     */
    RoughTransmittance(Microfacet.Kind kind, double alpha, double eta) {
        double[] nodes = GaussLegendre.nodes(eta < 1 ? NODES_INTO_THINNER : NODES_INTO_DENSER);
        double[] weights = GaussLegendre.weights(nodes);
        table = new double[INTERVALS + 1];
        for (int i = 0; i <= INTERVALS; i++) {
            double root = (double) i / INTERVALS;
            table[i] = directional(kind, alpha, eta, root * root, nodes, weights);
        }
        hemispherical = integrateTable();
    }

    /** Transmittance for a direction with the given cosine in [0,1]. */
    double at(double cosine) {
        double x = Math.sqrt(Math.min(1, cosine)) * INTERVALS;
        int i = Math.min((int) x, INTERVALS - 1);
        double t = x - i;
        return (1 - t) * table[i] + t * table[i + 1];
    }

    /** Transmittance under diffuse illumination, 2 ∫ T(c) c dc over c in [0,1]; the exact integral of {@link #at}. */
    double hemispherical() {
        return hemispherical;
    }

    /**
     * Integral over visible normals of (1 − F)·G₁ of the refracted direction. The facets are mirrored at the plane of
     * incidence; of the uniform number that carries the symmetry only one half is integrated.
     *
     * @param nodes Gauss–Legendre rule used in both dimensions
     */
    static double directional(
            Microfacet.Kind kind, double alpha, double eta, double cosine, double[] nodes, double[] weights) {
        int n = nodes.length;
        double sine = Math.sqrt((1 - cosine) * (1 + cosine));
        double length = Math.hypot(alpha * sine, cosine);
        boolean gaussian = kind == Microfacet.Kind.BECKMANN;
        double[] mapped = new double[n];
        double[] mappedWeights = new double[n];
        double[] along = new double[n];
        double[] across = new double[n];
        for (int i = 0; i < n; i++) {
            // Takes the root singularities at the ends of the unit interval away.
            mapped[i] = 0.5 * (1 - Math.cos(Math.PI * nodes[i]));
            mappedWeights[i] = weights[i] * 0.5 * Math.PI * Math.sin(Math.PI * nodes[i]);
            // Slopes of Gaussian facets are products: solved for once per node, not once per pair.
            along[i] =
                    gaussian ? -alpha * Microfacet.visibleSlope(cosine / length, alpha * sine / length, mapped[i]) : 0;
            across[i] = gaussian ? -alpha * Microfacet.visibleSlope(1, 0, 0.5 * mapped[i]) : 0;
        }
        BsdfSample normal = new BsdfSample();
        double sum = 0;
        for (int i = 0; i < n; i++) {
            for (int j = 0; j < n; j++) {
                if (gaussian) {
                    Microfacet.setNormal(along[i], across[j], 1, normal);
                } else {
                    Microfacet.sampleVisibleNormal(kind, alpha, sine, 0, cosine, 0.5 * mapped[j], mapped[i], normal);
                }
                double facetCosine = Math.min(1, sine * normal.wiX + cosine * normal.wiZ);
                sum += mappedWeights[i]
                        * mappedWeights[j]
                        * transmitted(kind, alpha, eta, cosine, facetCosine, normal.wiZ);
            }
        }
        return Math.min(1, sum);
    }

    private static double transmitted(
            Microfacet.Kind kind, double alpha, double eta, double cosine, double facetCosine, double normalZ) {
        double refracted = Fresnel.refractedCosine(facetCosine, 1 / eta);
        if (facetCosine <= 0 || refracted < 0) {
            return 0;
        }
        // Third component of the refracted direction, wi = (c/η − c_t) m − wo/η.
        double wiZ = (facetCosine / eta - refracted) * normalZ - cosine / eta;
        if (wiZ >= 0) {
            return 0;
        }
        double below = Math.min(1, -wiZ);
        return (1 - Fresnel.dielectric(facetCosine, refracted, eta))
                * below
                * Microfacet.maskingOverCosine(kind, alpha, below);
    }

    /** With s = √c the table is linear in s on each interval and 2 c dc = 4 s³ ds. */
    private double integrateTable() {
        double[] nodes = GaussLegendre.nodes(3);
        double[] weights = GaussLegendre.weights(nodes);
        double sum = 0;
        for (int i = 0; i < INTERVALS; i++) {
            for (int j = 0; j < nodes.length; j++) {
                double s = (i + nodes[j]) / INTERVALS;
                double value = (1 - nodes[j]) * table[i] + nodes[j] * table[i + 1];
                sum += weights[j] * value * 4 * s * s * s / INTERVALS;
            }
        }
        return sum;
    }
}
