package org.daybreak.scenes.build;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import javax.vecmath.Color3f;
import javax.vecmath.Matrix4d;
import javax.vecmath.Point3d;
import javax.vecmath.Vector3d;
import org.daybreak.core.light.PhotometricProfile;
import org.daybreak.core.light.RadianceMap;
import org.daybreak.core.light.SkySettings;
import org.daybreak.core.light.SolarPosition;
import org.daybreak.core.material.Texture;
import org.daybreak.core.math.Transform;
import org.daybreak.core.scene.Group;
import org.daybreak.core.scene.LightNode;
import org.daybreak.core.scene.LightSource;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.photometry.IesReader;
import org.jspecify.annotations.Nullable;

/** Builds lights that are not shapes. */
final class LightBuilder {
    private static final List<String> DATE_AND_PLACE =
            List.of("year", "month", "day", "hour", "minute", "second", "latitude", "longitude", "timezone");

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
                if (p.has("ies")) {
                    PhotometricProfile profile = profile(p);
                    if (profile == null) {
                        return;
                    }
                    if (!isSimilarity(toWorld)) {
                        context.error(
                                p.location("to_world"),
                                "the transform of a luminaire must not shear or scale unevenly");
                        return;
                    }
                    source = new LightSource.Photometric(profile, color(p, "intensity"));
                } else {
                    source = new LightSource.Point(color(p, "intensity"));
                }
            }
            case "spot" -> {
                double cutoff = p.number("cutoff_angle");
                double beam = p.number("beam_width", 0.75 * cutoff);
                if (beam > cutoff) {
                    context.error(
                            p.location("beam_width"),
                            "'beam_width' must not exceed 'cutoff_angle', " + cutoff + ", but is " + beam);
                }
                Texture slide = p.has("texture") ? textures.texture(p, "texture") : null;
                if (slide != null && cutoff >= 90) {
                    context.error(
                            p.location("texture"),
                            "a spot with a texture needs a 'cutoff_angle' of less than 90 degrees but has " + cutoff);
                    return;
                }
                source = new LightSource.Spot(color(p, "intensity"), cutoff, beam, slide);
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
            case "sunsky", "sky", "sun" -> {
                addSky(parent, object, p, toWorld);
                return;
            }
            default -> throw new IllegalStateException("no builder for " + object.label());
        }
        add(parent, object, source, toWorld);
    }

    private static void add(Group parent, ObjectDescription object, LightSource source, Matrix4d toWorld) {
        LightNode node = new LightNode(source);
        node.setTransform(toWorld);
        node.setName(object.id());
        parent.add(node);
    }

    private @Nullable PhotometricProfile profile(Properties p) {
        Path file = context.file(p.text("ies"), p.location("ies"));
        if (file == null) {
            return null;
        }
        try {
            return IesReader.read(file);
        } catch (IOException e) {
            context.error(p.location("ies"), "cannot use " + file + ": " + e.getMessage());
            return null;
        }
    }

    /** Adds sky and sun as two lights, as each is sampled in its own way. */
    private void addSky(Group parent, ObjectDescription object, Properties p, Matrix4d toWorld) {
        boolean hasSky = !object.type().equals("sun");
        boolean hasSun = !object.type().equals("sky");
        if (!isSimilarity(toWorld)) {
            context.error(p.location("to_world"), "the transform of a sky must not shear or scale unevenly");
            return;
        }
        if (hasSun && p.truth("complex_sun")) {
            context.error(p.location("complex_sun"), "'complex_sun' is not supported: it must be false");
        }
        Vector3d sun;
        if (p.has("sun_direction")) {
            for (String name : DATE_AND_PLACE) {
                if (p.mentions(name)) {
                    context.error(p.location(name), "either 'sun_direction' or '" + name + "' can be given, not both");
                }
            }
            sun = new Vector3d(p.point("sun_direction"));
            if (sun.length() == 0) {
                context.error(p.location("sun_direction"), "'sun_direction' must not be zero");
                return;
            }
            Matrix4d toSky = new Matrix4d(toWorld);
            toSky.invert();
            toSky.transform(sun);
        } else {
            double hour = p.number("hour") + (p.number("minute") + p.number("second") / 60) / 60;
            sun = SolarPosition.direction(
                    p.integer("year"),
                    p.integer("month"),
                    p.integer("day"),
                    hour,
                    p.number("timezone"),
                    p.number("latitude"),
                    p.number("longitude"));
        }
        if (sun.z < 0) {
            context.warning(p.location("sun_direction"), "the sun is below the horizon; the sky is black");
        }
        SkySettings.Kind kind = hasSky && p.text("model").equals("preetham")
                ? SkySettings.Kind.PREETHAM
                : SkySettings.Kind.HOSEK_WILKIE;
        SkySettings settings;
        try {
            settings = new SkySettings(kind, p.number("turbidity"), color(p, "albedo"), sun);
        } catch (IllegalArgumentException e) {
            context.error(p.location("turbidity"), String.valueOf(e.getMessage()));
            return;
        }
        if (hasSky && p.number("sky_scale") > 0) {
            add(parent, object, new LightSource.Sky(settings, p.number("sky_scale")), toWorld);
        }
        if (hasSun && p.number("sun_scale") > 0) {
            add(
                    parent,
                    object,
                    new LightSource.Sun(settings, p.number("sun_aperture"), p.number("sun_scale")),
                    toWorld);
        }
    }

    /** True if a transform only turns, mirrors, moves and scales evenly. */
    private static boolean isSimilarity(Matrix4d m) {
        double scale = Math.sqrt(m.m00 * m.m00 + m.m10 * m.m10 + m.m20 * m.m20);
        Matrix4d unit = new Matrix4d(m);
        unit.m03 = 0;
        unit.m13 = 0;
        unit.m23 = 0;
        unit.mul(1 / scale);
        unit.m33 = 1;
        return Affine.isRigid(unit);
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
