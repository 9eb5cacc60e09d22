package org.daybreak.scenes.build;

import java.util.IdentityHashMap;
import javax.vecmath.Matrix4d;
import org.daybreak.core.geometry.Cone;
import org.daybreak.core.geometry.Cube;
import org.daybreak.core.geometry.Cylinder;
import org.daybreak.core.geometry.Disk;
import org.daybreak.core.geometry.Rectangle;
import org.daybreak.core.geometry.Shape;
import org.daybreak.core.geometry.Sphere;
import org.daybreak.core.geometry.TriangleMesh;
import org.daybreak.core.material.Bsdf;
import org.daybreak.core.material.Diffuse;
import org.daybreak.core.material.Texture;
import org.daybreak.core.material.TwoSided;
import org.daybreak.core.material.VertexColorTexture;
import org.daybreak.core.scene.Group;
import org.daybreak.core.scene.Instance;
import org.daybreak.core.scene.Node;
import org.daybreak.core.scene.ShapeNode;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.view.AutoView;
import org.jspecify.annotations.Nullable;

/** Builds shapes with their materials and emission. */
final class ShapeBuilder {
    /** What models with colours get in place of the neutral material. */
    private static final Bsdf COLORED =
            new TwoSided(new Diffuse(new VertexColorTexture(1)), new Diffuse(new VertexColorTexture(1)));

    private final BuildContext context;
    private final TextureBuilder textures;
    private final BsdfBuilder bsdfs;
    private final MeshBuilder meshes;
    private final IdentityHashMap<ObjectDescription, BuiltMesh> built;
    private final IdentityHashMap<ObjectDescription, Group> groups = new IdentityHashMap<>();
    private final Bsdf neutral = AutoView.neutralMaterial();

    private int lights;

    /**
     * Creates a builder.
     *
     * @param built receives the meshes of the shapes
     */
    ShapeBuilder(
            BuildContext context,
            TextureBuilder textures,
            BsdfBuilder bsdfs,
            IdentityHashMap<ObjectDescription, BuiltMesh> built) {
        this.context = context;
        this.built = built;
        this.textures = textures;
        this.bsdfs = bsdfs;
        this.meshes = new MeshBuilder(context);
    }

    /** Number of emitting shapes built so far. */
    int lights() {
        return lights;
    }

    /** Builds a shape and adds it to a group. A shapegroup is only checked; its instances add it. */
    void addTo(Group parent, ObjectDescription object, SourceLocation usedAt) {
        Properties p = context.properties(object);
        if (p == null) {
            return;
        }
        Node node;
        if (object.type().equals("shapegroup")) {
            group(object, p, usedAt);
            return;
        }
        if (object.type().equals("instance")) {
            node = instance(object, p, usedAt);
        } else {
            node = shape(p);
        }
        if (node != null) {
            node.setName(object.id());
            parent.add(node);
        }
    }

    private @Nullable Group group(ObjectDescription object, Properties p, SourceLocation usedAt) {
        Group known = groups.get(object);
        if (known != null) {
            return known;
        }
        Group group = context.<Group>build(object, usedAt, () -> {
            Group made = new Group();
            made.setName(object.id());
            for (Properties.Child child : p.children(ObjectKind.SHAPE)) {
                addTo(made, child.object(), child.location());
            }
            return made;
        });
        if (group != null) {
            groups.put(object, group);
        }
        return group;
    }

    private @Nullable Node instance(ObjectDescription object, Properties p, SourceLocation usedAt) {
        Properties.Child child = p.child(ObjectKind.SHAPE);
        if (child == null) {
            return null;
        }
        if (!child.object().type().equals("shapegroup")) {
            context.error(
                    child.location(),
                    "<shape type=\"instance\"> must contain a shapegroup but is given "
                            + child.object().label());
            return null;
        }
        Properties groupProperties = context.properties(child.object());
        if (groupProperties == null) {
            return null;
        }
        Group group =
                context.<Group>build(object, usedAt, () -> group(child.object(), groupProperties, child.location()));
        if (group == null) {
            return null;
        }
        Instance instance = new Instance(group);
        instance.setTransform(p.transform("to_world"));
        return instance;
    }

    private @Nullable Node shape(Properties p) {
        Matrix4d toWorld = p.transform("to_world");
        boolean flip = p.truth("flip_normals");
        try {
            Texture radiance = radiance(p);
            Bsdf material = material(p);
            Shape shape;
            switch (p.object().type()) {
                case "obj", "ply", "stl", "serialized", "bsplinecurve", "linearcurve", "heightfield" -> {
                    MeshBuilder.Mesh mesh = meshes.mesh(p, toWorld);
                    if (mesh == null) {
                        return null;
                    }
                    shape = mesh.mesh();
                    material = material == neutral && mesh.mesh().colors() != null ? COLORED : material;
                    flip ^= mesh.frontByWinding() && Affine.isMirroring(toWorld);
                }
                case "mesh" -> {
                    TriangleMesh mesh = p.mesh("mesh");
                    if (mesh == null) {
                        return null;
                    }
                    shape = mesh;
                }
                case "sphere" -> shape = new Sphere(p.point("center"), p.number("radius"));
                case "cylinder" -> shape = new Cylinder(p.point("p0"), p.point("p1"), p.number("radius"));
                case "cone" -> shape = new Cone(p.point("p0"), p.point("p1"), p.number("radius0"), p.number("radius1"));
                case "rectangle" -> shape = new Rectangle();
                case "disk" -> shape = new Disk();
                case "cube" -> shape = new Cube();
                default ->
                    throw new IllegalStateException(
                            "no builder for " + p.object().label());
            }
            if (shape instanceof TriangleMesh mesh) {
                boolean frontByWinding = mesh.normals() == null && Affine.isMirroring(toWorld);
                built.put(p.object(), new BuiltMesh(mesh, flip ^ frontByWinding));
            }
            ShapeNode node = new ShapeNode(shape, material);
            node.setTransform(toWorld);
            node.setFlipNormals(flip);
            node.setRadiance(radiance);
            return node;
        } catch (IllegalArgumentException e) {
            context.error(p.location(), p.object().label() + ": " + e.getMessage());
            return null;
        }
    }

    private @Nullable Texture radiance(Properties p) {
        Properties.Child emitter = p.child(ObjectKind.EMITTER);
        if (emitter == null) {
            return null;
        }
        lights++;
        if (!emitter.object().type().equals("area")
                && Plugins.find(ObjectKind.EMITTER, emitter.object().type()) != null) {
            context.error(
                    emitter.location(),
                    "a shape can only contain <emitter type=\"area\">, not "
                            + emitter.object().label());
            return null;
        }
        Properties properties = context.properties(emitter.object());
        return properties == null ? null : textures.texture(properties, "radiance");
    }

    private Bsdf material(Properties p) {
        Properties.Child bsdf = p.child(ObjectKind.BSDF);
        if (bsdf != null) {
            return bsdfs.bsdf(bsdf.object(), bsdf.location());
        }
        if (p.child(ObjectKind.EMITTER) != null) {
            return BsdfBuilder.BLACK;
        }
        return context.isModel() ? neutral : BsdfBuilder.DEFAULT;
    }
}
