package org.daybreak.core.geometry;

/**
 * A shape in its own coordinates, as scenes describe it. Immutable. The scene compiler turns shapes into primitives of the
 * acceleration structure; transforms, material and emission come from the scene graph.
 */
public sealed interface Shape permits TriangleMesh, Sphere, Rectangle, Disk, Cube, Cylinder, Cone {}
