package org.daybreak.core.film;

import java.util.List;

/** An auxiliary image that a film can gather beside the colour. */
public enum FilmLayer {
    /** Reflectance plus transmittance of the first surface seen, for denoisers; 0 where nothing is seen. */
    ALBEDO("albedo", "RGB"),
    /** Shading normal of the first surface seen, world space, as the surface defines it; 0 where nothing is seen. */
    NORMAL("normal", "XYZ"),
    /**
     * Distance along the ray from the lens to the first surface seen, in world units: the mean over the samples that see
     * a surface; 0 where none does.
     */
    DEPTH("depth", "Z"),
    /**
     * Variance of the pixel's value, per colour channel, estimated from the spread of its samples as if these were
     * independent. Samplers that spread samples evenly have a lower variance than that. NaN where a pixel has fewer
     * than two samples.
     */
    VARIANCE("variance", "RGB");

    private final String id;
    private final String components;

    FilmLayer(String id, String components) {
        this.id = id;
        this.components = components;
    }

    /** Name of the layer in files and on the command line. */
    public String id() {
        return id;
    }

    /** Names of its channels: {@code albedo.R}, {@code albedo.G}, … */
    public List<String> channels() {
        return components.chars().mapToObj(c -> id + "." + (char) c).toList();
    }
}
