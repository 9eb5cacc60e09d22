package org.daybreak.core.render;

import java.util.List;
import java.util.Map;

/**
 * What a render did. Immutable.
 *
 * @param renderer identifier of the renderer
 * @param cancelled true if it stopped because it was asked to
 * @param samples image samples (or light subpaths) in the image, those of the render that was continued included
 * @param resumedSamples how many of them are those
 * @param samplesPerPixel samples per pixel in finished passes
 * @param secondsByPhase wall-clock seconds by phase, in order: {@code prepare}, {@code render}
 * @param raysByKind rays traced by kind, keys as {@link org.daybreak.core.scene.RayKind} in lower case
 * @param nonFiniteSamples number of samples that were NaN or infinite; they are left out of the image and always an
 *     error of the renderer or the scene
 * @param nonFiniteAddresses addresses (seed, pixel, sample) of the first few of them, to replay
 * @param figures further figures by name
 * @param warnings what the user should know
 * @param sheets images besides the film's, by the name of the parameter that asks for them ({@link Parameter.Type#FOLDER})
 */
public record RenderReport(
        String renderer,
        boolean cancelled,
        long samples,
        long resumedSamples,
        long samplesPerPixel,
        Map<String, Double> secondsByPhase,
        Map<String, Long> raysByKind,
        long nonFiniteSamples,
        List<String> nonFiniteAddresses,
        Map<String, Double> figures,
        List<String> warnings,
        Map<String, ImageSheet> sheets) {
    /** Copies the collections; maps keep their order. */
    public RenderReport {
        secondsByPhase = java.util.Collections.unmodifiableMap(new java.util.LinkedHashMap<>(secondsByPhase));
        raysByKind = java.util.Collections.unmodifiableMap(new java.util.LinkedHashMap<>(raysByKind));
        figures = java.util.Collections.unmodifiableMap(new java.util.LinkedHashMap<>(figures));
        nonFiniteAddresses = List.copyOf(nonFiniteAddresses);
        warnings = List.copyOf(warnings);
        sheets = java.util.Collections.unmodifiableMap(new java.util.LinkedHashMap<>(sheets));
    }

    /** What a render did that has made no images besides the film's. */
    public RenderReport(
            String renderer,
            boolean cancelled,
            long samples,
            long resumedSamples,
            long samplesPerPixel,
            Map<String, Double> secondsByPhase,
            Map<String, Long> raysByKind,
            long nonFiniteSamples,
            List<String> nonFiniteAddresses,
            Map<String, Double> figures,
            List<String> warnings) {
        this(
                renderer,
                cancelled,
                samples,
                resumedSamples,
                samplesPerPixel,
                secondsByPhase,
                raysByKind,
                nonFiniteSamples,
                nonFiniteAddresses,
                figures,
                warnings,
                Map.of());
    }
}
