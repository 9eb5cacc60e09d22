package org.daybreak.scenes.build;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.Locale;
import java.util.Map;
import javax.vecmath.Matrix4d;
import org.daybreak.core.color.ColorSpaces;
import org.daybreak.core.light.RadianceMap;
import org.daybreak.core.material.BitmapTexture;
import org.daybreak.core.material.CheckerboardTexture;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.ScaledTexture;
import org.daybreak.core.material.Texture;
import org.daybreak.core.material.TextureImage;
import org.daybreak.core.material.VertexColorTexture;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.image.ImageLoader;
import org.daybreak.scenes.image.LoadedImage;
import org.jspecify.annotations.Nullable;

/** Builds textures and environment images. Files and objects that are used several times are read once. */
final class TextureBuilder {
    private static final Texture PLACEHOLDER = ConstantTexture.grey(0.5);

    private final BuildContext context;
    private final IdentityHashMap<ObjectDescription, Texture> built = new IdentityHashMap<>();
    private final Map<String, TextureImage> images = new HashMap<>();

    TextureBuilder(BuildContext context) {
        this.context = context;
    }

    /** The texture or colour of a property. After an error that has been reported it is a placeholder. */
    Texture texture(Properties owner, String name) {
        Properties.Child child = owner.texture(name);
        if (child == null) {
            double[] rgb = owner.color(name);
            return new ConstantTexture(rgb[0], rgb[1], rgb[2]);
        }
        Texture texture = texture(child.object(), child.location());
        double limit = owner.textureLimit(name);
        if (texture.maximum() > limit) {
            context.error(
                    child.location(),
                    String.format(
                            Locale.ROOT,
                            "'%s' of %s must not exceed %s but its texture reaches %s",
                            name,
                            owner.object().label(),
                            limit == Math.rint(limit) ? String.format(Locale.ROOT, "%.0f", limit) : limit,
                            texture.maximum()));
            return PLACEHOLDER;
        }
        return texture;
    }

    /** Builds a texture. */
    Texture texture(ObjectDescription object, SourceLocation usedAt) {
        Texture known = built.get(object);
        if (known == null) {
            Texture made = context.<Texture>build(object, usedAt, () -> make(object));
            known = made == null ? PLACEHOLDER : made;
            built.put(object, known);
        }
        return known;
    }

    private @Nullable Texture make(ObjectDescription object) {
        Properties p = context.properties(object);
        if (p == null) {
            return null;
        }
        switch (object.type()) {
            case "checkerboard":
                return new CheckerboardTexture(texture(p, "color0"), texture(p, "color1"), uvTransform(p));
            case "mesh_attribute":
                return vertexColors(p);
            case "scaled":
                return scaled(p);
            default:
                return bitmap(p);
        }
    }

    private Texture vertexColors(Properties p) {
        String attribute = p.text("name");
        if (!attribute.equals("vertex_color")) {
            context.error(p.location("name"), "the only mesh attribute is 'vertex_color', not '" + attribute + "'");
        }
        return new VertexColorTexture(p.number("scale"));
    }

    private @Nullable Texture scaled(Properties p) {
        Properties.Child nested = p.child(ObjectKind.TEXTURE);
        if (nested == null) {
            return null;
        }
        double[] scale = p.color("scale");
        return new ScaledTexture(texture(nested.object(), nested.location()), scale[0], scale[1], scale[2]);
    }

    private @Nullable Texture bitmap(Properties p) {
        TextureImage image = image(p);
        if (image == null) {
            return null;
        }
        BitmapTexture.Filter filter =
                p.text("filter_type").equals("nearest") ? BitmapTexture.Filter.NEAREST : BitmapTexture.Filter.BILINEAR;
        BitmapTexture.Wrap wrap = switch (p.text("wrap_mode")) {
            case "mirror" -> BitmapTexture.Wrap.MIRROR;
            case "clamp" -> BitmapTexture.Wrap.CLAMP;
            default -> BitmapTexture.Wrap.REPEAT;
        };
        return new BitmapTexture(image, filter, wrap, uvTransform(p), p.integer("uv_set") == 1);
    }

    /** The part of a transform that acts on texture coordinates: as in Mitsuba, the translation is that of the last column. */
    private static double[] uvTransform(Properties p) {
        Matrix4d m = p.transform("to_uv");
        return new double[] {m.m00, m.m01, m.m03, m.m10, m.m11, m.m13};
    }

    private @Nullable TextureImage image(Properties p) {
        Path file = p.has("filename") ? context.file(p.text("filename"), p.location("filename")) : null;
        if (file == null) {
            return null;
        }
        boolean raw = p.truth("raw");
        String channel = p.text("channel");
        String key = raw + " " + channel + " " + file.toAbsolutePath().normalize();
        TextureImage known = images.get(key);
        if (known == null) {
            LoadedImage loaded = load(file, p.location("filename"));
            LoadedImage wanted = loaded == null ? null : channel(loaded, channel, p.location("channel"));
            // Alpha is never encoded.
            boolean linear = raw || channel.equals("a");
            known = wanted == null ? null : textureImage(wanted, linear, file, p.location("filename"));
            if (known != null) {
                images.put(key, known);
            }
        }
        return known;
    }

    /** One channel of an image as a grey one; null after an error that has been reported. */
    private @Nullable LoadedImage channel(LoadedImage image, String channel, SourceLocation location) {
        if (channel.equals("all")) {
            return image;
        }
        int channels = image.channels();
        boolean colored = channels >= 3;
        boolean hasAlpha = channels == 2 || channels == 4;
        if (channel.equals("a") && !hasAlpha) {
            context.error(location, "the image has no alpha channel");
            return null;
        }
        int index = channel.equals("a") ? channels - 1 : colored ? "rgb".indexOf(channel) : 0;
        int pixels = image.width() * image.height();
        if (image instanceof LoadedImage.Bytes b) {
            byte[] grey = new byte[pixels];
            for (int i = 0; i < pixels; i++) {
                grey[i] = b.samples()[channels * i + index];
            }
            return new LoadedImage.Bytes(b.width(), b.height(), 1, grey);
        }
        LoadedImage.Floats f = (LoadedImage.Floats) image;
        float[] grey = new float[pixels];
        for (int i = 0; i < pixels; i++) {
            grey[i] = f.samples()[channels * i + index];
        }
        return new LoadedImage.Floats(f.width(), f.height(), 1, grey, f.encoded());
    }

    private @Nullable TextureImage textureImage(LoadedImage loaded, boolean raw, Path file, SourceLocation location) {
        try {
            if (loaded instanceof LoadedImage.Bytes b) {
                return raw
                        ? TextureImage.fromRawBytes(b.width(), b.height(), b.channels(), b.samples())
                        : TextureImage.fromSrgbBytes(b.width(), b.height(), b.channels(), b.samples());
            }
            LoadedImage.Floats f = (LoadedImage.Floats) loaded;
            float[] samples = f.encoded() && !raw ? decoded(f.samples()) : f.samples();
            return TextureImage.fromFloats(f.width(), f.height(), f.channels(), samples);
        } catch (IllegalArgumentException e) {
            context.error(location, "cannot use " + file + ": " + e.getMessage());
            return null;
        }
    }

    /** The panorama of an environment; null after an error that has been reported. */
    @Nullable
    RadianceMap radianceMap(Properties p) {
        Path file = p.has("filename") ? context.file(p.text("filename"), p.location("filename")) : null;
        LoadedImage loaded = file == null ? null : load(file, p.location("filename"));
        if (file == null || loaded == null) {
            return null;
        }
        int channels = loaded.channels();
        int pixels = loaded.width() * loaded.height();
        float[] rgb = new float[3 * pixels];
        for (int i = 0; i < pixels; i++) {
            for (int c = 0; c < 3; c++) {
                rgb[3 * i + c] = linear(loaded, channels * i + (channels < 3 ? 0 : c));
            }
        }
        try {
            return new RadianceMap(loaded.width(), loaded.height(), rgb);
        } catch (IllegalArgumentException e) {
            context.error(p.location("filename"), "cannot use " + file + ": " + e.getMessage());
            return null;
        }
    }

    private static float linear(LoadedImage image, int index) {
        if (image instanceof LoadedImage.Bytes b) {
            return (float) ColorSpaces.srgbByteToLinear(b.samples()[index] & 0xff);
        }
        LoadedImage.Floats f = (LoadedImage.Floats) image;
        float value = f.samples()[index];
        return f.encoded() ? (float) ColorSpaces.srgbToLinear(value) : value;
    }

    private static float[] decoded(float[] encoded) {
        float[] linear = new float[encoded.length];
        for (int i = 0; i < linear.length; i++) {
            linear[i] = (float) ColorSpaces.srgbToLinear(encoded[i]);
        }
        return linear;
    }

    private @Nullable LoadedImage load(Path file, SourceLocation location) {
        String ending = ImageLoader.ending(file);
        if (!context.images().endings().contains(ending)) {
            context.error(
                    location,
                    "images of type '" + ending + "' cannot be read; known: "
                            + String.join(
                                    ", ",
                                    context.images().endings().stream().sorted().toList()));
            return null;
        }
        try {
            return context.images().load(file);
        } catch (IOException e) {
            context.error(location, "cannot read " + file + ": " + e.getMessage());
            return null;
        }
    }
}
