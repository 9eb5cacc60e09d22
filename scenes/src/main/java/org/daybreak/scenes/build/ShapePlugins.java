package org.daybreak.scenes.build;

import static org.daybreak.scenes.build.PropertyDefinition.objects;
import static org.daybreak.scenes.build.PropertyDefinition.optional;
import static org.daybreak.scenes.build.PropertyDefinition.value;

import java.util.List;
import org.daybreak.scenes.description.ObjectKind;

/** The table of shapes. */
final class ShapePlugins {
    private ShapePlugins() {}

    /** Appends all types of shapes. */
    static void addTo(List<PluginDefinition> list) {
        List<PropertyDefinition> common = common();
        PropertyDefinition file =
                optional("filename", ValueType.FILE, "The file.").asRequired();
        PropertyDefinition faceNormals = value(
                "face_normals",
                ValueType.BOOLEAN,
                "false",
                "Flat triangles. Otherwise normals are those of the file or, if it has none, computed.");
        list.add(Plugins.plugin(
                ObjectKind.SHAPE,
                "obj",
                "Wavefront OBJ mesh.",
                Plugins.join(
                        common,
                        file,
                        faceNormals,
                        optional(
                                "material",
                                ValueType.STRING,
                                "Only the faces that follow this usemtl; not in Mitsuba."),
                        value(
                                "flip_tex_coords",
                                ValueType.BOOLEAN,
                                "true",
                                "Turns v into 1 - v, as images start at the top."))));
        list.add(Plugins.plugin(
                ObjectKind.SHAPE,
                "ply",
                "PLY mesh, ASCII or binary.",
                Plugins.join(
                        common,
                        file,
                        faceNormals,
                        value("flip_tex_coords", ValueType.BOOLEAN, "false", "Turns v into 1 - v."))));
        list.add(Plugins.plugin(
                ObjectKind.SHAPE,
                "serialized",
                "Compressed meshes of Mitsuba 0.6.",
                Plugins.join(
                        common,
                        file,
                        faceNormals,
                        value("shape_index", ValueType.INTEGER, "0", "Number of the mesh in the file.")
                                .between(0, Integer.MAX_VALUE))));
        list.add(Plugins.plugin(
                ObjectKind.SHAPE,
                "stl",
                "STL mesh, ASCII or binary.",
                Plugins.join(
                        common,
                        file,
                        value(
                                "face_normals",
                                ValueType.BOOLEAN,
                                "true",
                                "Flat triangles. Otherwise normals are computed; those of the file are never used."))));
        PropertyDefinition sides = value(
                        "sides", ValueType.INTEGER, "16", "Sides of the cross-section: 16 lie 1.9 % inside the circle.")
                .between(3, 256);
        list.add(Plugins.plugin(
                ObjectKind.SHAPE,
                "bsplinecurve",
                "Cubic B-splines as tubes with open ends: a control point x y z r per line, an empty line between curves.",
                Plugins.join(common, file, sides)));
        list.add(Plugins.plugin(
                ObjectKind.SHAPE,
                "linearcurve",
                "Polylines as mitred tubes with open ends, in the same format.",
                Plugins.join(common, file, sides)));
        list.add(Plugins.plugin(
                ObjectKind.SHAPE,
                "heightfield",
                "Image of heights over [-1, 1]² in z = 0, as a mesh; the first row is at y = -1.",
                Plugins.join(
                        common,
                        file,
                        faceNormals,
                        value(
                                "scale",
                                ValueType.FLOAT,
                                "1",
                                "Factor on the values, which are taken as they are stored."))));
        list.add(Plugins.plugin(
                ObjectKind.SHAPE,
                "sphere",
                "Sphere.",
                Plugins.join(
                        common,
                        value("center", ValueType.POINT, "0, 0, 0", "Centre."),
                        value("radius", ValueType.FLOAT, "1", "Radius.").positive())));
        list.add(Plugins.plugin(
                ObjectKind.SHAPE, "rectangle", "Square [-1, 1]² in z = 0, normal +z.", Plugins.join(common)));
        list.add(Plugins.plugin(ObjectKind.SHAPE, "disk", "Unit disk in z = 0, normal +z.", Plugins.join(common)));
        list.add(Plugins.plugin(ObjectKind.SHAPE, "cube", "Cube [-1, 1]³, normals outwards.", Plugins.join(common)));
        list.add(Plugins.plugin(
                ObjectKind.SHAPE,
                "cylinder",
                "Cylinder without caps, normal outwards.",
                Plugins.join(
                        common,
                        value("p0", ValueType.POINT, "0, 0, 0", "Centre of one end."),
                        value("p1", ValueType.POINT, "0, 0, 1", "Centre of the other end."),
                        value("radius", ValueType.FLOAT, "1", "Radius.").positive())));
        list.add(Plugins.plugin(
                ObjectKind.SHAPE,
                "cone",
                "Cone or frustum without caps, normal outwards. Not in Mitsuba.",
                Plugins.join(
                        common,
                        value("p0", ValueType.POINT, "0, 0, 0", "Centre of one end."),
                        value("p1", ValueType.POINT, "0, 0, 1", "Centre of the other end."),
                        value("radius0", ValueType.FLOAT, "1", "Radius at p0.").between(0, Double.MAX_VALUE),
                        value("radius1", ValueType.FLOAT, "0", "Radius at p1.").between(0, Double.MAX_VALUE))));
        list.add(Plugins.plugin(
                ObjectKind.SHAPE,
                "shapegroup",
                "Shapes that only appear through instances.",
                objects(ObjectKind.SHAPE, 1, Plugins.MANY, "The shapes.")));
        list.add(Plugins.plugin(
                ObjectKind.SHAPE,
                "instance",
                "Appearance of a shapegroup; its geometry is stored once.",
                optional("to_world", ValueType.TRANSFORM, "Group to world."),
                objects(ObjectKind.SHAPE, 1, 1, "The shapegroup, usually by reference.")));
    }

    /** A mesh that a reader of another format has decoded; scene files cannot contain it. */
    static PluginDefinition meshInMemory() {
        return Plugins.plugin(
                ObjectKind.SHAPE,
                "mesh",
                "Mesh in memory.",
                Plugins.join(
                        common(), optional("mesh", ValueType.MESH, "The mesh.").asRequired()));
    }

    private static List<PropertyDefinition> common() {
        return List.of(
                optional("to_world", ValueType.TRANSFORM, "Shape to world."),
                value("flip_normals", ValueType.BOOLEAN, "false", "Exchanges front and back."),
                objects(
                        ObjectKind.BSDF,
                        0,
                        1,
                        "Material; diffuse with reflectance 0.5 if there is none, 0 on a shape that emits."),
                objects(ObjectKind.EMITTER, 0, 1, "Makes the shape a light."));
    }
}
