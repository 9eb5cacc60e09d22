package org.daybreak.scenes.build;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.Locale;
import java.util.Map;
import java.util.function.Supplier;
import javax.vecmath.Matrix4d;
import org.daybreak.core.color.ColorSpaces;
import org.daybreak.core.light.RadianceMap;
import org.daybreak.core.material.BitmapTexture;
import org.daybreak.core.material.CheckerboardTexture;
import org.daybreak.core.material.ConstantTexture;
import org.daybreak.core.material.ProductTexture;
import org.daybreak.core.material.ScaledTexture;
import org.daybreak.core.material.Texture;
import org.daybreak.core.material.TextureImage;
import org.daybreak.core.material.ThresholdTexture;
import org.daybreak.core.material.VertexColorTexture;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.daybreak.scenes.image.ImageLoader;
import org.daybreak.scenes.image.LoadedImage;
import org.jspecify.annotations.Nullable;

/** Builds textures and environment images. Files and objects that are used several times are read once. */
final class TextureBuilder {
    /** Stands for a texture with an error that is reported. */
    static final Texture PLACEHOLDER = ConstantTexture.grey(0.5);

    private final BuildContext context;
    private final IdentityHashMap<ObjectDescription, Texture> built = new IdentityHashMap<>();
    private final Map<ImageKey, TextureImage> images = new HashMap<>();
    /** The embedded image that was read last: the next texture often uses another channel of it. */
    private byte @Nullable [] lastContent;

    private @Nullable LoadedImage lastImage;

    /**
     * What of an image is used, and how.
     *
     * @param source the file's path, or the array that holds the content, which is its own identity
     */
    private record ImageKey(Object source, boolean raw, String channel) {}

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
        return context.shared(built, object, usedAt, PLACEHOLDER, () -> make(object));
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
            case "product":
                return new ProductTexture(texture(p, "first"), texture(p, "second"));
            case "threshold":
                return new ThresholdTexture(texture(p, "value"), p.number("cutoff"));
            default:
                return bitmap(p);
        }
    }

    private @Nullable Texture vertexColors(Properties p) {
        String attribute = p.text("name");
        if (!attribute.equals("vertex_color")) {
            context.error(p.location("name"), "the only mesh attribute is 'vertex_color', not '" + attribute + "'");
            return null;
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
        BitmapTexture.Wrap wrapU = wrap(p.text("wrap_mode"));
        BitmapTexture.Wrap wrapV = p.has("wrap_mode_v") ? wrap(p.text("wrap_mode_v")) : wrapU;
        return new BitmapTexture(image, filter, wrapU, wrapV, uvTransform(p), p.integer("uv_set") == 1);
    }

    private static BitmapTexture.Wrap wrap(String mode) {
        return switch (mode) {
            case "mirror" -> BitmapTexture.Wrap.MIRROR;
            case "clamp" -> BitmapTexture.Wrap.CLAMP;
            default -> BitmapTexture.Wrap.REPEAT;
        };
    }

    /** The part of a transform that acts on texture coordinates: as in Mitsuba, the translation is that of the last column. */
    private static double[] uvTransform(Properties p) {
        Matrix4d m = p.transform("to_uv");
        return new double[] {m.m00, m.m01, m.m03, m.m10, m.m11, m.m13};
    }

    private @Nullable TextureImage image(Properties p) {
        SourceLocation location = p.location("filename");
        Value.Content content = p.content("filename");
        if (content != null) {
            return image(p, content.bytes(), content.name(), () -> load(content, location));
        }
        Path file = p.has("filename") ? context.file(p.text("filename"), location) : null;
        return file == null
                ? null
                : image(p, file.toAbsolutePath().normalize(), file.toString(), () -> load(file, location));
    }

    /** The part of an image that a texture asks for, read once. */
    private @Nullable TextureImage image(
            Properties p, Object source, String name, Supplier<@Nullable LoadedImage> loader) {
        boolean raw = p.truth("raw");
        String channel = p.text("channel");
        ImageKey key = new ImageKey(source, raw, channel);
        TextureImage known = images.get(key);
        if (known == null) {
            LoadedImage loaded = loader.get();
            if (loaded != null && channel.equals("a") && loaded.channels() % 2 != 0) {
                context.error(p.location("channel"), "the image has no alpha channel");
                return null;
            }
            known = loaded == null ? null : textureImage(loaded, raw, channel, name, p.location("filename"));
            if (known != null) {
                images.put(key, known);
            }
        }
        return known;
    }

    private @Nullable TextureImage textureImage(
            LoadedImage loaded, boolean raw, String channel, String name, SourceLocation location) {
        try {
            boolean opacity = channel.equals("a") || channel.equals("opacity");
            LoadedImage used = channel.equals("all") ? loaded : loaded.channel(opacity ? 3 : "rgb".indexOf(channel));
            // Opacity is never encoded.
            boolean linear = raw || opacity;
            if (used instanceof LoadedImage.Bytes b) {
                return linear
                        ? TextureImage.fromRawBytes(b.width(), b.height(), b.channels(), b.samples())
                        : TextureImage.fromSrgbBytes(b.width(), b.height(), b.channels(), b.samples());
            }
            LoadedImage.Floats f = (LoadedImage.Floats) used;
            float[] samples = f.encoded() && !linear ? decoded(f.samples()) : f.samples();
            return TextureImage.fromFloats(f.width(), f.height(), f.channels(), samples);
        } catch (IllegalArgumentException e) {
            context.error(location, "cannot use " + name + ": " + e.getMessage());
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

    private @Nullable LoadedImage load(Value.Content content, SourceLocation location) {
        if (content.bytes() == lastContent) {
            return lastImage;
        }
        if (!isKnown(content.ending(), location)) {
            return null;
        }
        try {
            LoadedImage image = context.images().load(content.bytes(), content.ending());
            lastContent = content.bytes();
            lastImage = image;
            return image;
        } catch (IOException e) {
            context.error(location, "cannot read " + content.name() + ": " + e.getMessage());
            return null;
        } catch (OutOfMemoryError e) {
            context.error(location, "the image " + content.name() + " does not fit into memory");
            return null;
        }
    }

    private @Nullable LoadedImage load(Path file, SourceLocation location) {
        if (!isKnown(ImageLoader.ending(file), location)) {
            return null;
        }
        try {
            return context.images().load(file);
        } catch (IOException e) {
            context.error(location, "cannot read " + file + ": " + e.getMessage());
            return null;
        }
    }

    private boolean isKnown(String ending, SourceLocation location) {
        if (context.images().endings().contains(ending)) {
            return true;
        }
        context.error(
                location,
                "images of type '" + ending + "' cannot be read; known: "
                        + String.join(
                                ", ",
                                context.images().endings().stream().sorted().toList()));
        return false;
    }
}
