package org.daybreak.cli;

import java.util.LinkedHashMap;
import java.util.Map;
import org.daybreak.cli.partial.RenderIdentity;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.RenderState;
import org.daybreak.exr.ExrAttribute;
import org.jspecify.annotations.Nullable;

/** What an OpenEXR file says about how its image was made: enough to make it again, nothing about the machine. */
final class ImageAttributes {
    private ImageAttributes() {}

    /** The attributes of a finished render. */
    static Map<String, ExrAttribute> of(RenderPlan plan, RenderReport report, double seconds) {
        return of(plan.identity(), report.samples(), report.samplesPerPixel(), seconds);
    }

    /** The attributes of a film that was read from files. */
    static Map<String, ExrAttribute> of(Map<String, String> identity, RenderState state) {
        return of(identity, state.samples(), state.samplesPerPixel(), state.seconds());
    }

    private static Map<String, ExrAttribute> of(
            Map<String, String> identity, long samples, long samplesPerPixel, double seconds) {
        Map<String, ExrAttribute> attributes = new LinkedHashMap<>();
        put(attributes, "software", identity.get(RenderIdentity.SOFTWARE));
        put(attributes, "renderer", identity.get(RenderIdentity.RENDERER));
        put(attributes, "parameters", identity.get(RenderIdentity.PARAMETERS));
        put(attributes, "antialiasing", identity.get(RenderIdentity.ANTIALIASING));
        put(attributes, "antialiasingParameters", identity.get(RenderIdentity.ANTIALIASING_PARAMETERS));
        // As text: a seed has 64 bits, the format's integers have 32.
        put(attributes, "seed", identity.get(RenderIdentity.SEED));
        attributes.put("samplesPerPixel", new ExrAttribute.DoubleValue(samplesPerPixel));
        attributes.put("samples", new ExrAttribute.DoubleValue(samples));
        attributes.put("renderSeconds", new ExrAttribute.DoubleValue(seconds));
        return attributes;
    }

    private static void put(Map<String, ExrAttribute> attributes, String name, @Nullable String value) {
        if (value != null) {
            attributes.put(name, new ExrAttribute.StringValue(value));
        }
    }
}
