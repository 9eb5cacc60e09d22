package org.daybreak.scenes.build;

import java.nio.file.Path;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.function.Consumer;
import org.daybreak.core.scene.SceneGraph;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.SceneDescription;
import org.daybreak.scenes.image.ImageLoader;
import org.jspecify.annotations.Nullable;

/** Builds a scene graph from a description. */
public final class SceneBuilder {
    /**
     * What a description amounts to.
     *
     * @param graph the scene; incomplete if errors were reported
     * @param request what the file asks of the renderer
     * @param files all files that were read, the main file first
     * @param meshes the meshes of all shapes that are meshes, by the identity of their descriptions
     */
    public record Result(
            SceneGraph graph,
            RenderSettingsRequest request,
            List<Path> files,
            IdentityHashMap<ObjectDescription, BuiltMesh> meshes) {}

    private final BuildContext context;
    private final SceneGraph graph = new SceneGraph();
    private final Map<String, String> parameters = new LinkedHashMap<>();
    private final IdentityHashMap<ObjectDescription, BuiltMesh> meshes = new IdentityHashMap<>();
    private @Nullable String rendererId;

    private SceneBuilder(BuildContext context) {
        this.context = context;
    }

    /**
     * Builds a scene. Goes on after errors to find all of them.
     *
     * @param description what the files say
     * @param images reads textures and environments
     * @param problems receives all errors and warnings; after an error the result must not be used
     */
    public static Result build(SceneDescription description, ImageLoader images, ProblemList problems) {
        return new SceneBuilder(new BuildContext(description, images, problems)).build();
    }

    private Result build() {
        Properties scene = context.properties(context.root());
        if (scene == null) {
            throw new IllegalArgumentException("the root of a description must be a scene");
        }
        Properties.Child integrator = scene.child(ObjectKind.INTEGRATOR);
        Properties integratorProperties = integrator == null ? null : context.properties(integrator.object());
        if (integratorProperties != null) {
            IntegratorReader.Request request = IntegratorReader.read(context, integratorProperties);
            rendererId = request.rendererId();
            parameters.putAll(request.parameters());
        }
        Properties sampler = buildSensor(scene.children(ObjectKind.SENSOR));
        buildContent(scene);
        OptionalInt samples = sampler != null && sampler.has("sample_count")
                ? OptionalInt.of(sampler.integer("sample_count"))
                : OptionalInt.empty();
        OptionalLong seed = sampler != null && sampler.has("seed")
                ? OptionalLong.of((long) sampler.number("seed"))
                : OptionalLong.empty();
        return new Result(
                graph,
                new RenderSettingsRequest(Optional.ofNullable(rendererId), parameters, samples, seed),
                context.files(),
                meshes);
    }

    /** Builds the first camera and checks the others. Returns the sampler's properties, if there are any. */
    private @Nullable Properties buildSensor(List<Properties.Child> sensors) {
        SensorBuilder builder = new SensorBuilder(context);
        int used = Math.min(1, sensors.size());
        each(sensors.subList(0, used), sensor -> {
            builder.build(sensor.object(), graph);
            sampler(sensor);
        });
        each(sensors.subList(used, sensors.size()), sensor -> {
            builder.build(sensor.object(), new SceneGraph());
            sampler(sensor);
            context.warning(sensor.location(), "only the first camera of a scene is used");
        });
        return sensors.isEmpty() ? null : sampler(sensors.get(0));
    }

    private @Nullable Properties sampler(Properties.Child sensor) {
        Properties p = context.properties(sensor.object());
        Properties.Child child = p == null ? null : p.child(ObjectKind.SAMPLER);
        return child == null ? null : context.properties(child.object());
    }

    /**
     * Builds objects one by one. Properties are checked when they are read, but values within their ranges may still combine
     * to what the engine refuses: that too is an error of the file.
     */
    private void each(List<Properties.Child> children, Consumer<Properties.Child> build) {
        for (Properties.Child child : children) {
            try {
                build.accept(child);
            } catch (IllegalArgumentException e) {
                context.error(child.location(), child.object().label() + ": " + e.getMessage());
            }
        }
    }

    /** Builds shapes, lights, and also materials and textures that nothing uses, so that their errors are found too. */
    private void buildContent(Properties scene) {
        TextureBuilder textures = new TextureBuilder(context);
        BsdfBuilder bsdfs = new BsdfBuilder(context, textures);
        ShapeBuilder shapes = new ShapeBuilder(context, textures, bsdfs, meshes);
        LightBuilder lights = new LightBuilder(context, textures);
        each(scene.children(ObjectKind.TEXTURE), child -> textures.texture(child.object(), child.location()));
        each(scene.children(ObjectKind.BSDF), child -> bsdfs.bsdf(child.object(), child.location()));
        each(scene.children(ObjectKind.EMITTER), child -> {
            // Shapes may refer to an area light that stands in the scene under a name.
            if (!child.object().type().equals("area") || child.object().id() == null) {
                lights.addTo(graph.root(), child.object());
            } else {
                context.properties(child.object());
            }
        });
        each(scene.children(ObjectKind.SHAPE), child -> shapes.addTo(graph.root(), child.object(), child.location()));
        if (shapes.lights() == 0 && scene.children(ObjectKind.EMITTER).isEmpty() && !context.isModel()) {
            context.warning(scene.location(), "the scene has no light; the picture will be black");
        }
    }
}
