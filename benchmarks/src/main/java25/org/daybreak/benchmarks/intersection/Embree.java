package org.daybreak.benchmarks.intersection;

import java.lang.foreign.AddressLayout;
import java.lang.foreign.Arena;
import java.lang.foreign.FunctionDescriptor;
import java.lang.foreign.Linker;
import java.lang.foreign.MemorySegment;
import java.lang.foreign.SymbolLookup;
import java.lang.foreign.ValueLayout;
import java.lang.invoke.MethodHandle;
import org.daybreak.core.accel.PrimitiveSet;

/**
 * Embree's single-ray interface through the Foreign Function and Memory API. The queries are linked as critical calls,
 * which costs a few nanoseconds each; they use what the library picks for the processor by itself, at medium build
 * quality and without flags.
 */
final class Embree implements AutoCloseable {
    private static final AddressLayout POINTER = ValueLayout.ADDRESS;
    private static final ValueLayout.OfInt INT = ValueLayout.JAVA_INT;
    private static final ValueLayout.OfFloat FLOAT = ValueLayout.JAVA_FLOAT;
    private static final ValueLayout.OfLong LONG = ValueLayout.JAVA_LONG;

    private static final int TRIANGLES = 0;
    private static final int INDEX_BUFFER = 0;
    private static final int VERTEX_BUFFER = 1;
    private static final int UINT3 = 0x5003;
    private static final int FLOAT3 = 0x9003;
    private static final int MEDIUM_QUALITY = 1;

    private static final SymbolLookup LIBRARY = SymbolLookup.libraryLookup("libembree3.so.3", Arena.global());
    private static final MethodHandle NEW_DEVICE = function("rtcNewDevice", FunctionDescriptor.of(POINTER, POINTER));
    private static final MethodHandle RELEASE_DEVICE = function("rtcReleaseDevice", FunctionDescriptor.ofVoid(POINTER));
    private static final MethodHandle NEW_SCENE = function("rtcNewScene", FunctionDescriptor.of(POINTER, POINTER));
    private static final MethodHandle RELEASE_SCENE = function("rtcReleaseScene", FunctionDescriptor.ofVoid(POINTER));
    private static final MethodHandle SET_QUALITY =
            function("rtcSetSceneBuildQuality", FunctionDescriptor.ofVoid(POINTER, INT));
    private static final MethodHandle NEW_GEOMETRY =
            function("rtcNewGeometry", FunctionDescriptor.of(POINTER, POINTER, INT));
    private static final MethodHandle NEW_BUFFER =
            function("rtcSetNewGeometryBuffer", FunctionDescriptor.of(POINTER, POINTER, INT, INT, INT, LONG, LONG));
    private static final MethodHandle COMMIT_GEOMETRY =
            function("rtcCommitGeometry", FunctionDescriptor.ofVoid(POINTER));
    private static final MethodHandle ATTACH_GEOMETRY =
            function("rtcAttachGeometry", FunctionDescriptor.of(INT, POINTER, POINTER));
    private static final MethodHandle RELEASE_GEOMETRY =
            function("rtcReleaseGeometry", FunctionDescriptor.ofVoid(POINTER));
    private static final MethodHandle COMMIT_SCENE = function("rtcCommitScene", FunctionDescriptor.ofVoid(POINTER));
    private static final MethodHandle INTERSECT = query("rtcIntersect1");
    private static final MethodHandle OCCLUDED = query("rtcOccluded1");

    private final Arena arena = Arena.ofShared();
    private final MemorySegment device;
    private final MemorySegment geometry;
    private final MemorySegment context;
    private final MemorySegment ray;
    private MemorySegment scene = MemorySegment.NULL;

    private static MethodHandle function(String name, FunctionDescriptor descriptor) {
        return Linker.nativeLinker().downcallHandle(LIBRARY.findOrThrow(name), descriptor);
    }

    private static MethodHandle query(String name) {
        return Linker.nativeLinker()
                .downcallHandle(
                        LIBRARY.findOrThrow(name),
                        FunctionDescriptor.ofVoid(POINTER, POINTER, POINTER),
                        Linker.Option.critical(false));
    }

    /**
     * Copies the mesh into Embree's buffers.
     *
     * @param threads number of threads that builds may use
     */
    Embree(PrimitiveSet set, int threads) {
        try {
            device = (MemorySegment) NEW_DEVICE.invokeExact(arena.allocateFrom("threads=" + threads));
            geometry = (MemorySegment) NEW_GEOMETRY.invokeExact(device, TRIANGLES);
            float[] positions = set.positions();
            int[] triangles = set.triangles();
            MemorySegment vertices = (MemorySegment)
                    NEW_BUFFER.invokeExact(geometry, VERTEX_BUFFER, 0, FLOAT3, 12L, positions.length / 3L);
            MemorySegment.copy(positions, 0, vertices.reinterpret(4L * positions.length), FLOAT, 0, positions.length);
            MemorySegment indices = (MemorySegment)
                    NEW_BUFFER.invokeExact(geometry, INDEX_BUFFER, 0, UINT3, 12L, triangles.length / 3L);
            MemorySegment.copy(triangles, 0, indices.reinterpret(4L * triangles.length), INT, 0, triangles.length);
            COMMIT_GEOMETRY.invokeExact(geometry);
        } catch (Throwable e) {
            throw new IllegalStateException("Embree cannot be called", e);
        }
        context = arena.allocate(24, 16);
        context.set(INT, 16, -1);
        ray = arena.allocate(96, 64);
        ray.set(INT, 36, -1);
    }

    /** Builds the hierarchy anew. */
    void build() {
        try {
            if (!scene.equals(MemorySegment.NULL)) {
                RELEASE_SCENE.invokeExact(scene);
            }
            scene = (MemorySegment) NEW_SCENE.invokeExact(device);
            SET_QUALITY.invokeExact(scene, MEDIUM_QUALITY);
            int ignored = (int) ATTACH_GEOMETRY.invokeExact(scene, geometry);
            COMMIT_SCENE.invokeExact(scene);
        } catch (Throwable e) {
            throw new IllegalStateException("Embree cannot be called", e);
        }
    }

    /** Number of the triangle that one ray hits first, or -1. */
    int intersect(float[] rays, int at) {
        MemorySegment r = ray;
        load(r, rays, at);
        r.set(INT, 68, -1);
        r.set(INT, 72, -1);
        try {
            INTERSECT.invokeExact(scene, context, r);
        } catch (Throwable e) {
            throw new IllegalStateException("Embree cannot be called", e);
        }
        return r.get(INT, 68);
    }

    /** Parameter of the last closest hit. */
    float parameter() {
        return ray.get(FLOAT, 32);
    }

    /** Whether one ray hits anything. */
    boolean occluded(float[] rays, int at) {
        MemorySegment r = ray;
        load(r, rays, at);
        try {
            OCCLUDED.invokeExact(scene, context, r);
        } catch (Throwable e) {
            throw new IllegalStateException("Embree cannot be called", e);
        }
        return r.get(FLOAT, 32) < 0;
    }

    private static void load(MemorySegment r, float[] rays, int at) {
        r.set(FLOAT, 0, rays[at]);
        r.set(FLOAT, 4, rays[at + 1]);
        r.set(FLOAT, 8, rays[at + 2]);
        r.set(FLOAT, 12, 0);
        r.set(FLOAT, 16, rays[at + 4]);
        r.set(FLOAT, 20, rays[at + 5]);
        r.set(FLOAT, 24, rays[at + 6]);
        r.set(FLOAT, 28, 0);
        r.set(FLOAT, 32, rays[at + 7]);
    }

    @Override
    public void close() {
        try {
            RELEASE_SCENE.invokeExact(scene);
            RELEASE_GEOMETRY.invokeExact(geometry);
            RELEASE_DEVICE.invokeExact(device);
        } catch (Throwable e) {
            throw new IllegalStateException("Embree cannot be called", e);
        }
        arena.close();
    }
}
