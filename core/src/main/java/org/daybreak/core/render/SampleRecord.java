package org.daybreak.core.render;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * All that a renderer did for one sample: for people who look for the reason of what they see. Immutable.
 *
 * @param filmX film position in pixels
 * @param filmY film position in pixels
 * @param radiance what the sample adds at its film position, to be averaged over the samples of a pixel; splats are not in it
 * @param subpaths the paths that were traced, in order
 * @param contributions what became of each way to join them, in order of s, then t
 * @param raysByKind rays traced by kind, keys as in {@link RenderReport#raysByKind()}
 * @param notes what differs from the sample in the render
 */
public record SampleRecord(
        double filmX,
        double filmY,
        Color radiance,
        List<Subpath> subpaths,
        List<Contribution> contributions,
        Map<String, Long> raysByKind,
        List<String> notes) {
    /** Copies the collections. */
    public SampleRecord {
        subpaths = List.copyOf(subpaths);
        contributions = List.copyOf(contributions);
        raysByKind = Collections.unmodifiableMap(new LinkedHashMap<>(raysByKind));
        notes = List.copyOf(notes);
    }

    /**
     * Linear RGB.
     *
     * @param r red
     * @param g green
     * @param b blue
     */
    public record Color(double r, double g, double b) {
        /** Black. */
        public static final Color BLACK = new Color(0, 0, 0);

        /** Componentwise sum. */
        public Color plus(Color other) {
            return new Color(r + other.r, g + other.g, b + other.b);
        }

        /** Product with a number. */
        public Color times(double factor) {
            return new Color(factor * r, factor * g, factor * b);
        }
    }

    /**
     * A point or a direction.
     *
     * @param x x
     * @param y y
     * @param z z
     */
    public record Vector(double x, double y, double z) {}

    /**
     * A path from the lens or from a light.
     *
     * @param name what it is: {@code eye subpath}, {@code subpath from light 2 (PointLight)}
     * @param vertices from the lens or the light on; none if nothing could be traced
     */
    public record Subpath(String name, List<Vertex> vertices) {
        /** Copies the vertices. */
        public Subpath {
            vertices = List.copyOf(vertices);
        }
    }

    /**
     * A vertex of a subpath.
     *
     * @param name {@code z0} for the lens, {@code y0} for the light
     * @param what what is there: {@code shape 3 (Dielectric)}
     * @param position in world space; of lights at infinity the point of the disk over the scene that the path starts from
     * @param normal shading normal; of lights the geometric one, of the lens 0
     * @param delta true if the path went on by a delta lobe
     * @param connectable true if it can be joined to other vertices
     * @param throughput f/p of the path up to here
     * @param forward density with which the path sampled the vertex: per area; per solid angle at infinity
     * @param reverse the same as if sampled from the next vertex, NaN if not known
     */
    public record Vertex(
            String name,
            String what,
            Vector position,
            Vector normal,
            boolean delta,
            boolean connectable,
            Color throughput,
            double forward,
            double reverse) {}

    /** What became of a way to join subpaths. */
    public enum Outcome {
        /** Added to the sample. */
        ADDED("added"),
        /** Splatted at another film position. */
        SPLATTED("splatted"),
        /** A surface is in the way. */
        OCCLUDED("occluded"),
        /** Small, and not tested for occlusion: the roulette has spared the ray. */
        ROULETTE("left out by roulette"),
        /** Nothing is emitted, scattered or seen along the edge. */
        ZERO("zero"),
        /** A vertex scatters by delta lobes only. */
        DELTA("not admissible: delta vertex"),
        /** The path would be too long. */
        DEPTH("not admissible: depth"),
        /** The technique is left out, by the settings or because others do better. */
        OFF("not admissible: left out");

        private final String text;

        Outcome(String text) {
            this.text = text;
        }

        /** In words. */
        public String text() {
            return text;
        }
    }

    /**
     * A way to join subpaths.
     *
     * @param s vertices from the light
     * @param t vertices from the lens
     * @param eyePath number of the eye subpath, -1 if there is only the lens
     * @param light index of the light, -1 if there is none
     * @param outcome what became of it; the following is 0 unless it was added, splatted, occluded or left out by roulette
     * @param unweighted contribution without its weight; if occluded or left out by roulette, as it would be otherwise
     * @param weight weight of multiple importance sampling
     * @param filmX film position in pixels
     * @param filmY film position in pixels
     */
    public record Contribution(
            int s,
            int t,
            int eyePath,
            int light,
            Outcome outcome,
            Color unweighted,
            double weight,
            double filmX,
            double filmY) {}
}
