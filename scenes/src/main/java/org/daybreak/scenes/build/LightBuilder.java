package org.daybreak.scenes.build;

import javax.vecmath.Color3f;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import org.daybreak.core.light.RadianceMap;
import org.daybreak.core.math.Transform;
import org.daybreak.core.scene.Group;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.scenes.description.ObjectDescription;

/** Builds lights that are not shapes. */
final class LightBuilder {
    private final BuildContext context;
    private final TextureBuilder textures;

    LightBuilder(BuildContext context, TextureBuilder textures) {
        this.context = context;
        this.textures = textures;
    }

    /** Builds a light and adds it to a group. */
    void addTo(Group parent, ObjectDescription object) {
        Properties p = context.properties(object);
        if (p == null) {
            return;
        }
        Matrix4d toWorld = object.type().equals("area") || object.type().equals("constant")
                ? new Matrix4d(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)
                : p.transform("to_world");
        LightSource source;
        switch (object.type()) {
            case "area" -> {
                context.error(object.location(), "<emitter type=\"area\"> must stand in a shape");
                return;
            }
            case "point" -> {
                if (p.mentions("position") && p.mentions("to_world")) {
                    context.error(p.location("position"), "either 'position' or 'to_world' can be given, not both");
                } else if (p.has("position")) {
                    toWorld.setTranslation(new Vector3d(p.point("position")));
                }
                source = new LightSource.Point(color(p, "intensity"));
            }
            case "spot" -> {
                double cutoff = p.number("cutoff_angle");
                double beam = p.number("beam_width", 0.75 * cutoff);
                if (beam > cutoff) {
                    context.error(
                            p.location("beam_width"),
                            "'beam_width' must not exceed 'cutoff_angle', " + cutoff + ", but is " + beam);
                }
                source = new LightSource.Spot(color(p, "intensity"), cutoff, beam);
            }
            case "directional" -> {
                if (p.mentions("direction") && p.mentions("to_world")) {
                    context.error(p.location("direction"), "either 'direction' or 'to_world' can be given, not both");
                } else if (p.has("direction")) {
                    Point3d direction = p.point("direction");
                    if (direction.distance(new Point3d()) == 0) {
                        context.error(p.location("direction"), "'direction' must not be zero");
                        return;
                    }
                    toWorld = alongZ(direction);
                }
                source = new LightSource.Directional(color(p, "irradiance"));
            }
            case "constant" -> source = new LightSource.ConstantEnvironment(color(p, "radiance"));
            case "envmap" -> {
                RadianceMap map = textures.radianceMap(p);
                if (map == null) {
                    return;
                }
                source = new LightSource.ImageEnvironment(map, p.number("scale"));
            }
            default -> throw new IllegalStateException("no builder for " + object.label());
        }
        LightNode node = new LightNode(source);
        node.setTransform(toWorld);
        node.setName(object.id());
        parent.add(node);
    }

    /** A rotation that takes +z to a direction. */
    private static Matrix4d alongZ(Point3d direction) {
        // Of the axes, the one farthest from the direction gives the best conditioned cross product.
        boolean steep = Math.abs(direction.y) > Math.abs(direction.x);
        return Transform.lookAt(0, 0, 0, direction.x, direction.y, direction.z, steep ? 1 : 0, steep ? 0 : 1, 0)
                .toMatrix4d();
    }

    private static Color3f color(Properties p, String name) {
        double[] rgb = p.color(name);
        return new Color3f((float) rgb[0], (float) rgb[1], (float) rgb[2]);
    }
}
