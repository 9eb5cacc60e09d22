package org.daybreak.core.material;

/**
 * How much light a rough dielectric interface lets through, by the angle of incidence, single scattering: a table by
 * deterministic quadrature at construction. Immutable.
 */
final class RoughTransmittance {
    /** Intervals in √cos θ, which spends them where the table bends: at grazing angles. */
    private static final int INTERVALS = 96;

    private static final int NODES = 24;

    private final double[] table;
    private final double hemispherical;

    /**
     * Builds the table for light from the outer side.
     *
     * @param eta refractive index of the transmitted side over that of the incident side
     */
    RoughTransmittance(Microfacet.Kind kind, double alpha, double eta) {
        double[] nodes = GaussLegendre.nodes(NODES);
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
     * Integral over visible normals of (1 − F)·G₁ of the refracted direction.
     *
     * @param nodes Gauss–Legendre rule used in both dimensions
     */
    static double directional(
            Microfacet.Kind kind, double alpha, double eta, double cosine, double[] nodes, double[] weights) {
        double sine = Math.sqrt((1 - cosine) * (1 + cosine));
        BsdfSample normal = new BsdfSample();
        double sum = 0;
        for (int i = 0; i < nodes.length; i++) {
            double u = smoothed(nodes[i]);
            for (int j = 0; j < nodes.length; j++) {
                double v = smoothed(nodes[j]);
                Microfacet.sampleVisibleNormal(kind, alpha, sine, 0, cosine, u, v, normal);
                double facetCosine = Math.min(1, sine * normal.wiX + cosine * normal.wiZ);
                sum += weights[i]
                        * weights[j]
                        * smoothedDerivative(nodes[i])
                        * smoothedDerivative(nodes[j])
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

    /** Sample mapping that takes the root singularities at the ends of the unit square away. */
    private static double smoothed(double x) {
        return 0.5 * (1 - Math.cos(Math.PI * x));
    }

    private static double smoothedDerivative(double x) {
        return 0.5 * Math.PI * Math.sin(Math.PI * x);
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
