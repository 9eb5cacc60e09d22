package org.daybreak.cli;

import java.util.List;
import java.util.Map;
import java.util.concurrent.ExecutionException;
import org.daybreak.core.render.Parameter;
import org.daybreak.core.render.ParameterException;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.core.render.RenderReport;
import org.daybreak.core.render.Renderer;
import org.daybreak.core.render.RendererFactory;

/** A renderer that goes wrong in the way it is asked to. */
public final class FaultyRendererFactory implements RendererFactory {
    @Override
    public String id() {
        return "faulty";
    }

    @Override
    public String description() {
        return "goes wrong";
    }

    @Override
    public List<Parameter> parameters() {
        return List.of(Parameter.choice(
                "fault",
                "Fault",
                "nonFinite",
                List.of("nonFinite", "crash", "memory", "settings"),
                "What goes wrong."));
    }

    @Override
    public Renderer create(ParameterValues values) {
        String fault = values.choice("fault");
        return (scene, camera, film, context) -> switch (fault) {
            case "crash" -> throw new IllegalStateException("on purpose");
            case "memory" ->
                throw new IllegalStateException(
                        "a worker failed", new ExecutionException(new OutOfMemoryError("on purpose")));
            case "settings" -> throw new ParameterException("these settings do not fit the scene");
            default ->
                new RenderReport(
                        id(),
                        false,
                        64,
                        0,
                        1,
                        Map.of("prepare", 0.0, "render", 0.0),
                        Map.of("camera", 64L),
                        3,
                        List.of("seed 0, pixel (1, 2), sample 0"),
                        Map.of(),
                        List.of());
        };
    }
}
