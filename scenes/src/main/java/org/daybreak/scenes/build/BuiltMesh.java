package org.daybreak.scenes.build;

import org.daybreak.core.geometry.TriangleMesh;

/**
 * The mesh of a shape, whatever it was read or computed from.
 *
 * @param mesh the mesh; without normals if its triangles are flat
 * @param flipNormals the {@code flip_normals} with which a PLY file of this mesh has the shape's front and back; a mesh
 *     without normals is to be read with {@code face_normals}
 */
public record BuiltMesh(TriangleMesh mesh, boolean flipNormals) {}
