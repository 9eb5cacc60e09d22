package org.daybreak.cli;

import java.util.LinkedHashMap;
import java.util.Map;
import org.daybreak.core.render.RenderReport;
import org.daybreak.exr.ExrAttribute;

/** What an OpenEXR file says about how its image was made: enough to make it again, nothing about the machine. */
final class ImageAttributes {
    private ImageAttributes() {}

    /**
     * The attributes of a finished render.
     *
     * @param seconds wall-clock seconds of rendering
     */
    static Map<String, ExrAttribute> of(RenderPlan plan, RenderReport report, double seconds) {
        Map<String, ExrAttribute> attributes = new LinkedHashMap<>();
        attributes.put("software", text(Version.software()));
        attributes.put("renderer", text(plan.renderer().id()));
        attributes.put("parameters", text(JsonText.line(plan.parameterMap())));
        attributes.put("antialiasing", text(plan.antialiasing().id()));
        attributes.put(
                "antialiasingParameters",
                text(JsonText.line(plan.antialiasingParameters().asMap())));
        // As text: a seed has 64 bits, the format's integers have 32.
        attributes.put("seed", text(Long.toString(plan.seed())));
        attributes.put("samplesPerPixel", new ExrAttribute.DoubleValue(report.samplesPerPixel()));
        attributes.put("samples", new ExrAttribute.DoubleValue(report.samples()));
        attributes.put("renderSeconds", new ExrAttribute.DoubleValue(seconds));
        return attributes;
    }

    private static ExrAttribute text(String value) {
        return new ExrAttribute.StringValue(value);
    }
}
