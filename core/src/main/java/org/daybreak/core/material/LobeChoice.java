package org.daybreak.core.material;

/** Probabilities of the two lobes of a coated material, in proportion to the light that each is expected to return. */
final class LobeChoice {
    private final double specularWeight;
    private final double diffuseWeight;

    LobeChoice(Reflectance specular, Reflectance diffuse) {
        specularWeight = specular.samplingWeight();
        diffuseWeight = diffuse.samplingWeight();
    }

    /**
     * Probability of the diffuse lobe; positive wherever that lobe is not black.
     *
     * @param transmittance of the coating for the direction the walk came from, in [0,1]
     */
    double diffuseProbability(double transmittance) {
        double diffuse = transmittance * diffuseWeight;
        return diffuse == 0 ? 0 : diffuse / (diffuse + (1 - transmittance) * specularWeight);
    }

    /** False if both lobes are black everywhere. */
    boolean anyLobe() {
        return specularWeight > 0 || diffuseWeight > 0;
    }
}
