package org.daybreak.scenes.view;

import java.util.IdentityHashMap;
import org.daybreak.core.geometry.Cone;
import org.daybreak.core.geometry.Cube;
import org.daybreak.core.geometry.Cylinder;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.math.Bounds;
import org.daybreak.core.math.Transform;
import org.daybreak.core.scene.Group;
import org.daybreak.core.scene.Instance;
import org.daybreak.core.scene.Node;
import org.daybreak.core.scene.ShapeNode;

/**
 * Points whose convex hull holds all geometry of a scene graph: the vertices of meshes, the corners of the boxes around other
 * shapes and around instances. The box of an instanced group is computed once, so that forests cost one visit per
 * instance.
 */
final class ScenePoints {
    /** Receives points in world coordinates. */
    interface Visitor {
        void point(double x, double y, double z);
    }

    private final IdentityHashMap<Group, Bounds> prototypes = new IdentityHashMap<>();
    private final IdentityHashMap<Group, Boolean> open = new IdentityHashMap<>();

    private ScenePoints() {}

    /**
     * Visits the points.
     *
     * @throws IllegalArgumentException if a group contains itself or a transform is singular or not finite
     */
    static void visit(Group root, Visitor visitor) {
        new ScenePoints().visit(root, Transform.identity(), visitor);
    }

    private void visit(Group group, Transform outer, Visitor visitor) {
        if (open.put(group, Boolean.TRUE) != null) {
            throw new IllegalArgumentException("a group contains itself");
        }
        Transform toWorld = outer.multiply(Transform.of(group.transform()));
        for (Node child : group.children()) {
            if (child instanceof Group inner) {
                visit(inner, toWorld, visitor);
            } else if (child instanceof Instance instance) {
                corners(prototype(instance.prototype()), toWorld.multiply(Transform.of(instance.transform())), visitor);
            } else if (child instanceof ShapeNode shape) {
                visit(shape.shape(), toWorld.multiply(Transform.of(shape.transform())), visitor);
            }
        }
        open.remove(group);
    }

    private Bounds prototype(Group group) {
        Bounds known = prototypes.get(group);
        if (known == null) {
            Bounds.Builder builder = new Bounds.Builder();
            visit(group, Transform.identity(), builder::include);
            known = builder.build();
            prototypes.put(group, known);
        }
        return known;
    }

    private static void visit(Shape shape, Transform toWorld, Visitor visitor) {
        if (shape instanceof TriangleMesh mesh) {
            float[] p = mesh.positions();
            double[] world = new double[3];
            for (int i = 0; i < p.length; i += 3) {
                toWorld.applyPoint(p[i], p[i + 1], p[i + 2], world);
                visitor.point(world[0], world[1], world[2]);
            }
        } else {
            corners(box(shape), toWorld, visitor);
        }
    }

    private static Bounds box(Shape shape) {
        Bounds.Builder box = new Bounds.Builder();
        if (shape instanceof Sphere sphere) {
            ball(box, sphere.centre(), sphere.radius());
        } else if (shape instanceof Cylinder cylinder) {
            ball(box, cylinder.from(), cylinder.radius());
            ball(box, cylinder.to(), cylinder.radius());
        } else if (shape instanceof Cone cone) {
            ball(box, cone.from(), cone.fromRadius());
            ball(box, cone.to(), cone.toRadius());
        } else if (shape instanceof Rectangle || shape instanceof Disk) {
            box.include(-1, -1, 0);
            box.include(1, 1, 0);
        } else if (shape instanceof Cube) {
            box.include(-1, -1, -1);
            box.include(1, 1, 1);
        }
        return box.build();
    }

    private static void ball(Bounds.Builder box, javax.vecmath.Point3d c, double r) {
        box.include(c.x - r, c.y - r, c.z - r);
        box.include(c.x + r, c.y + r, c.z + r);
    }

    private static void corners(Bounds b, Transform toWorld, Visitor visitor) {
        if (b.isEmpty()) {
            return;
        }
        double[] p = new double[3];
        for (int corner = 0; corner < 8; corner++) {
            toWorld.applyPoint(
                    (corner & 1) == 0 ? b.minX() : b.maxX(),
                    (corner & 2) == 0 ? b.minY() : b.maxY(),
                    (corner & 4) == 0 ? b.minZ() : b.maxZ(),
                    p);
            visitor.point(p[0], p[1], p[2]);
        }
    }
}
