package org.daybreak.core.scene;

import java.util.ArrayList;
import java.util.IdentityHashMap;
import java.util.List;
import org.daybreak.core.accel.Instance;
import org.daybreak.core.accel.Intersector;
import org.daybreak.core.accel.IntersectorProvider;
import org.daybreak.core.accel.Intersectors;
import org.daybreak.core.accel.PrimitiveSet;
import org.daybreak.core.camera.Camera;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.geometry.BoundingSphere;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.light.AreaLight;
import org.daybreak.core.light.Light;
import org.daybreak.core.light.LightSelections;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.Texture;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Transform;
import org.jspecify.annotations.Nullable;

/**
 * Compiles a scene graph: unrolls it to two levels, builds the acceleration structures, prepares lights and camera. The graph
 * may be changed or dropped afterwards.
 */
public final class SceneCompiler {
    private SceneCompiler() {}

    /**
     * How to compile.
     *
     * @param threads number of threads for building, at least 1; does not influence the result
     * @param intersector identifier of the intersector to use, null for the best on this machine
     */
    public record Options(int threads, @Nullable String intersector) {
        /** All processors and the best intersector. */
        public static Options defaults() {
            return new Options(Runtime.getRuntime().availableProcessors(), null);
        }
    }

    /** Compiles with default options; see {@link #compile(SceneGraph, Options)}. */
    public static Scene compile(SceneGraph graph) {
        return compile(graph, Options.defaults());
    }

    /**
     * Compiles a scene.
     *
     * @throws IllegalArgumentException if there is no camera or film, a transform is singular, a group contains itself, or a
     *     level is too large
     */
    public static Scene compile(SceneGraph graph, Options options) {
        CameraSettings cameraSettings = graph.camera();
        if (cameraSettings == null) {
            throw new IllegalArgumentException("the scene has no camera");
        }
        FilmSettings film = graph.film();
        if (film == null) {
            throw new IllegalArgumentException("the scene has no film: its size is unknown");
        }
        IntersectorProvider provider = options.intersector() == null
                ? Intersectors.select().provider()
                : Intersectors.select(options.intersector());
        FlatScene flat = FlatScene.of(graph.root());

        List<Bsdf> bsdfs = new ArrayList<>();
        LevelBuilder builder = new LevelBuilder();
        List<Light> lights = new ArrayList<>();
        List<Integer> lightOfShape = new ArrayList<>();
        DeltaSpheres deltaSpheres = new DeltaSpheres();
        for (FlatScene.PlacedShape shape : flat.shapes) {
            ShapeNode node = shape.node();
            int index = bsdfs.size();
            bsdfs.add(node.material());
            Shape geometry = wound(node.shape());
            Texture radiance = node.radiance();
            ShadingNeeds needs = ShadingNeeds.of(node.material(), radiance);
            int firstPrimitive = builder.triangleCount();
            builder.add(index, geometry, shape.toLevel(), node.flipNormals(), needs);
            if (Scene.isDelta(node.material())) {
                deltaSpheres.add(BoundingSphere.of(geometry, shape.toLevel()));
            }
            if (radiance == null) {
                lightOfShape.add(-1);
            } else {
                lightOfShape.add(lights.size());
                lights.add(
                        AreaLight.of(geometry, shape.toLevel(), node.flipNormals(), firstPrimitive, radiance, index));
            }
        }
        LevelGeometry geometry = builder.build();
        Levels levels = buildPrototypes(flat, provider, options.threads(), bsdfs, deltaSpheres);
        PrimitiveSet world = geometry.primitives(levels.instances);
        Intersector intersector = provider.build(world, options.threads());
        while (lightOfShape.size() < bsdfs.size()) {
            lightOfShape.add(-1);
        }

        Bounds bounds = boundsOf(intersector);
        for (FlatScene.PlacedLight light : flat.lights) {
            lights.add(LightCompiler.light(light.node().source(), light.toWorld(), bounds));
        }
        Camera camera = CameraCompiler.camera(cameraSettings, film);
        return new Scene(
                intersector,
                new SurfaceResolver(world, geometry, levels.geometries, levels.sets),
                bsdfs.toArray(new Bsdf[0]),
                lightOfShape.stream().mapToInt(Integer::intValue).toArray(),
                lights.toArray(new Light[0]),
                LightSelections.forLights(lights),
                camera,
                film,
                bounds,
                deltaSpheres.build());
    }

    /** Instances of the top level, and for each what it places. */
    private record Levels(Instance[] instances, LevelGeometry[] geometries, PrimitiveSet[] sets) {}

    private static Levels buildPrototypes(
            FlatScene flat, IntersectorProvider provider, int threads, List<Bsdf> bsdfs, DeltaSpheres deltaSpheres) {
        IdentityHashMap<FlatScene.Prototype, BuiltLevel> built = new IdentityHashMap<>();
        for (FlatScene.Prototype prototype : flat.usedPrototypes()) {
            LevelBuilder builder = new LevelBuilder();
            // A level may hold many copies of a node.
            IdentityHashMap<ShapeNode, Integer> indices = new IdentityHashMap<>();
            IdentityHashMap<Shape, Shape> wound = new IdentityHashMap<>();
            boolean delta = false;
            for (FlatScene.PlacedShape shape : prototype.shapes) {
                ShapeNode node = shape.node();
                Integer index = indices.get(node);
                if (index == null) {
                    index = bsdfs.size();
                    indices.put(node, index);
                    bsdfs.add(node.material());
                    delta |= Scene.isDelta(node.material());
                }
                builder.add(
                        index,
                        wound.computeIfAbsent(node.shape(), SceneCompiler::wound),
                        shape.toLevel(),
                        node.flipNormals(),
                        ShadingNeeds.of(node.material(), null));
            }
            LevelGeometry geometry = builder.build();
            PrimitiveSet set = geometry.primitives(new Instance[0]);
            built.put(prototype, new BuiltLevel(geometry, set, provider.build(set, threads), delta));
        }
        int count = flat.instances.size();
        Instance[] instances = new Instance[count];
        LevelGeometry[] geometries = new LevelGeometry[count];
        PrimitiveSet[] sets = new PrimitiveSet[count];
        for (int i = count - 1; i >= 0; i--) {
            // Frees what has been taken over: there can be millions.
            FlatScene.PlacedPrototype placed = flat.instances.remove(i);
            BuiltLevel level = java.util.Objects.requireNonNull(built.get(placed.prototype()));
            Transform toWorld = placed.toWorld();
            instances[i] = new Instance(toWorld.rows(), toWorld.inverse().rows(), level.intersector);
            geometries[i] = level.geometry;
            sets[i] = level.set;
            Bounds bounds = level.delta ? boundsOf(level.intersector) : Bounds.EMPTY;
            if (!bounds.isEmpty()) {
                deltaSpheres.add(BoundingSphere.of(bounds, toWorld));
            }
        }
        return new Levels(instances, geometries, sets);
    }

    private record BuiltLevel(LevelGeometry geometry, PrimitiveSet set, Intersector intersector, boolean delta) {}

    private static Bounds boundsOf(Intersector intersector) {
        float[] b = new float[6];
        intersector.bounds(b);
        return b[0] > b[3] ? Bounds.EMPTY : new Bounds(b[0], b[1], b[2], b[3], b[4], b[5]);
    }

    /** Intersection and sampling must agree which side of a triangle is its front. */
    private static Shape wound(Shape shape) {
        return shape instanceof TriangleMesh mesh ? mesh.windAlongNormals() : shape;
    }
}
