package org.daybreak.core.material;

/**
 * Fresnel's equations for unpolarised light: the fraction of the flux that a smooth interface reflects. Exact, no
 * approximation by Schlick.
 */
public final class Fresnel {
    private static final int DIFFUSE_NODES = 96;

    private Fresnel() {}

    /**
     * Cosine of the angle of refraction.
     *
     * @param cosine |cos θ| on the incident side, in [0,1]
     * @param etaRatio refractive index of the incident side over that of the transmitted side
     * @return |cos θ_t| in [0,1], or −1 for total internal reflection
     */
    public static double refractedCosine(double cosine, double etaRatio) {
        double squared = 1 - etaRatio * etaRatio * (1 - cosine) * (1 + cosine);
        return squared > 0 ? Math.min(1, Math.sqrt(squared)) : -1;
    }

    /**
     * Reflectance of a smooth dielectric interface.
     *
     * @param cosine |cos θ| on the incident side, in [0,1]
     * @param eta refractive index of the transmitted side over that of the incident side, positive
     * @return reflectance in [0,1]; 1 for total internal reflection
     */
    public static double dielectric(double cosine, double eta) {
        if (eta == 1) {
            return 0;
        }
        double transmitted = refractedCosine(cosine, 1 / eta);
        return transmitted < 0 ? 1 : dielectric(cosine, transmitted, eta);
    }

    /**
     * Reflectance of a smooth dielectric interface where both cosines are known.
     *
     * @param cosine |cos θ| on the incident side
     * @param transmitted |cos θ_t| as {@link #refractedCosine} returns it, not negative
     * @param eta refractive index of the transmitted side over that of the incident side
     * @return reflectance in [0,1]
     */
    public static double dielectric(double cosine, double transmitted, double eta) {
        if (eta == 1) {
            return 0;
        }
        if (cosine <= 0) {
            return 1;
        }
        double perpendicular = (cosine - eta * transmitted) / (cosine + eta * transmitted);
        double parallel = (eta * cosine - transmitted) / (eta * cosine + transmitted);
        return 0.5 * (perpendicular * perpendicular + parallel * parallel);
    }

    /**
     * Reflectance of a smooth conductor with the complex refractive index η + ik, one wavelength or channel.
     *
     * @param cosine |cos θ| on the side of the incident light, in [0,1]
     * @param eta real part relative to the surrounding medium, not negative
     * @param k imaginary part (absorption), not negative; not both parts zero
     * @return reflectance in [0,1]
     */
    public static double conductor(double cosine, double eta, double k) {
        if (cosine <= 0) {
            return 1;
        }
        double cosSquared = cosine * cosine;
        double sinSquared = Math.max(0, (1 - cosine) * (1 + cosine));
        // (a + ib)² = (η + ik)² − sin²θ; the two polarisations in terms of a and a² + b² (Born & Wolf, §13.2).
        double difference = eta * eta - k * k - sinSquared;
        double sumOfSquares = Math.sqrt(difference * difference + 4 * eta * eta * k * k);
        double a = Math.sqrt(Math.max(0, 0.5 * (sumOfSquares + difference)));
        double perpendicularSum = sumOfSquares + cosSquared;
        double perpendicularProduct = 2 * a * cosine;
        double perpendicular =
                Math.max(0, perpendicularSum - perpendicularProduct) / (perpendicularSum + perpendicularProduct);
        double parallelSum = cosSquared * sumOfSquares + sinSquared * sinSquared;
        double parallelProduct = perpendicularProduct * sinSquared;
        double parallel = perpendicular * Math.max(0, parallelSum - parallelProduct) / (parallelSum + parallelProduct);
        return 0.5 * (perpendicular + parallel);
    }

    /**
     * Reflectance of a smooth dielectric interface under diffuse illumination, 2 ∫ F(c) c dc over c in [0,1]; by
     * quadrature, accurate to 1e-12.
     *
     * @param eta refractive index of the transmitted side over that of the incident side, positive
     */
    public static double diffuse(double eta) {
        if (eta == 1) {
            return 0;
        }
        if (eta < 1) {
            // Flux through the interface is the same in both directions per solid angle times η² (Stokes).
            return 1 - (1 - diffuse(1 / eta)) * eta * eta;
        }
        // With c = a sinh t, η·cos θ_t = a cosh t and a² = η² − 1 the integrand is smooth for every η > 1.
        double a = Math.sqrt((eta - 1) * (eta + 1));
        double inverse = 1 / a;
        double end = Math.log(inverse + Math.sqrt(inverse * inverse + 1));
        double[] nodes = GaussLegendre.nodes(DIFFUSE_NODES);
        double[] weights = GaussLegendre.weights(nodes);
        double transmittance = 0;
        for (int i = 0; i < nodes.length; i++) {
            double t = end * nodes[i];
            double sinh = Math.sinh(t);
            double cosh = Math.cosh(t);
            double cosine = Math.min(1, a * sinh);
            transmittance +=
                    weights[i] * (1 - dielectric(cosine, Math.min(1, a * cosh / eta), eta)) * 2 * a * a * sinh * cosh;
        }
        return 1 - end * transmittance;
    }
}
