package org.daybreak.scenes.gltf;

import javax.vecmath.Matrix4d;
import javax.vecmath.Vector3d;

/** Transforms of cameras and lights. */
final class Frames {
    /** Turns +z, where cameras and lights of descriptions look, to −z, where those of glTF do; y stays up. */
    private static final Matrix4d HALF_TURN = new Matrix4d(-1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1);

    private Frames() {}

    /**
     * Where a camera or light that looks along its +z goes. The scale of its node does not count, as the specification asks
     * (3.10.2 and KHR_lights_punctual); direction, then up are kept.
     *
     * @param world transform of the node
     * @param node the node, for the error
     */
    static Matrix4d rigid(Matrix4d world, JsonValue node) throws GltfException {
        Matrix4d m = new Matrix4d(world);
        m.mul(HALF_TURN);
        Vector3d x = new Vector3d();
        Vector3d y = new Vector3d(m.m01, m.m11, m.m21);
        Vector3d z = new Vector3d(m.m02, m.m12, m.m22);
        z.normalize();
        x.cross(y, z);
        x.normalize();
        y.cross(z, x);
        double sum = x.x + x.y + x.z + y.x + y.y + y.z + z.x + z.y + z.z + m.m03 + m.m13 + m.m23;
        if (!Double.isFinite(sum)) {
            throw node.error(
                    "has a camera or light but its transform gives no direction: it is singular or not finite");
        }
        return new Matrix4d(x.x, y.x, z.x, m.m03, x.y, y.y, z.y, m.m13, x.z, y.z, z.z, m.m23, 0, 0, 0, 1);
    }
}
