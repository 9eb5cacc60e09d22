package org.daybreak.scenes.gltf;

import java.util.Arrays;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.Locale;
import java.util.Map;
import javax.vecmath.Matrix4d;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.Value;
import org.jspecify.annotations.Nullable;

/**
 * Textures with their images, samplers and KHR_texture_transform. Texture coordinates need no flip: here as in descriptions v
 * runs down from the top of the image. A use of a texture is described once for all materials, so that it is built once.
 */
final class Textures {
    static final String TRANSFORM = "KHR_texture_transform";
    private static final int NEAREST = 9728;
    private static final int LINEAR = 9729;
    private static final Map<Integer, String> WRAPS = Map.of(10497, "repeat", 33071, "clamp", 33648, "mirror");

    private final Container container;
    private final Buffers buffers;
    private final Report report;
    private final Map<String, ObjectDescription> described = new HashMap<>();
    private final IdentityHashMap<JsonValue, Value> images = new IdentityHashMap<>();

    Textures(Container container, Buffers buffers, Report report) {
        this.container = container;
        this.buffers = buffers;
        this.report = report;
    }

    /** What of an image is used. */
    enum Channel {
        /** Three colours, encoded by the sRGB transfer function. */
        SRGB(false, "all"),
        /** Three linear values. */
        LINEAR(true, "all"),
        RED(true, "r"),
        GREEN(true, "g"),
        BLUE(true, "b"),
        OPACITY(true, "opacity");

        private final boolean raw;
        private final String id;

        Channel(boolean raw, String id) {
            this.raw = raw;
            this.id = id;
        }
    }

    /**
     * Describes a use of a texture.
     *
     * @param info the textureInfo in a material
     * @param geometry what the texture goes on
     * @return null if there is no image that can be used, about which there is a warning
     */
    @Nullable
    ObjectDescription texture(JsonValue info, Channel channel, Geometry geometry) throws GltfException {
        JsonValue reference = info.get("index");
        JsonValue texture = container.resolve(reference, "textures");
        JsonValue source = texture.find("source");
        if (source == null) {
            report.warning(texture, "is left out: it has no source that is PNG or JPEG");
            return null;
        }
        JsonValue image = container.resolve(source, "images");
        JsonValue transform = info.extension(TRANSFORM);
        int set = info.integer("texCoord", 0, 0, Integer.MAX_VALUE);
        if (transform != null) {
            set = transform.integer("texCoord", set, 0, Integer.MAX_VALUE);
        }
        if (set > 1 || (set == 0 ? geometry.uv0() : geometry.uv1()) == null) {
            report.warning(
                    info,
                    set > 1
                            ? "is left out: only the texture coordinates 0 and 1 are supported, not " + set
                            : "is left out where a mesh lacks TEXCOORD_" + set);
            return null;
        }
        Matrix4d toUv = transform == null ? identity() : matrix(transform);
        String key = texture.index() + " " + channel + " " + set + " " + toUv;
        ObjectDescription known = described.get(key);
        if (known == null) {
            known = describe(texture, image, channel, set, toUv);
            described.put(key, known);
        }
        return known;
    }

    private ObjectDescription describe(JsonValue texture, JsonValue image, Channel channel, int set, Matrix4d toUv)
            throws GltfException {
        ObjectBuilder builder = new ObjectBuilder(ObjectKind.TEXTURE, "bitmap", report.location(image));
        builder.value("filename", image(image)).truth("raw", channel.raw);
        if (!channel.id.equals("all")) {
            builder.text("channel", channel.id);
        }
        JsonValue sampler = container.resolve(texture, "sampler", "samplers");
        if (sampler != null) {
            int filter = sampler.integer("magFilter", LINEAR, 0, Integer.MAX_VALUE);
            if (filter != NEAREST && filter != LINEAR) {
                throw sampler.get("magFilter").error("must be " + NEAREST + " or " + LINEAR + " but is " + filter);
            }
            builder.text("filter_type", filter == NEAREST ? "nearest" : "bilinear");
            String wrap = wrap(sampler, "wrapS");
            String wrapV = wrap(sampler, "wrapT");
            builder.text("wrap_mode", wrap);
            if (!wrapV.equals(wrap)) {
                builder.text("wrap_mode_v", wrapV);
            }
        }
        builder.transform("to_uv", toUv);
        if (set != 0) {
            builder.integer("uv_set", set);
        }
        return builder.build();
    }

    private static String wrap(JsonValue sampler, String name) throws GltfException {
        int given = sampler.integer(name, 10497, 0, Integer.MAX_VALUE);
        String mode = WRAPS.get(given);
        if (mode == null) {
            throw sampler.get(name).error("must be 10497, 33071 or 33648 but is " + given);
        }
        return mode;
    }

    /** Translation · rotation · scale, where a positive angle turns u towards −v, which is up in the image. */
    private static Matrix4d matrix(JsonValue transform) throws GltfException {
        double[] offset = transform.numbers("offset", 0, 0);
        double[] scale = transform.numbers("scale", 1, 1);
        double angle = transform.number("rotation", 0);
        Matrix4d m = identity();
        m.m00 = Math.cos(angle) * scale[0];
        m.m01 = Math.sin(angle) * scale[1];
        m.m03 = offset[0];
        m.m10 = -Math.sin(angle) * scale[0];
        m.m11 = Math.cos(angle) * scale[1];
        m.m13 = offset[1];
        return m;
    }

    private static Matrix4d identity() {
        Matrix4d m = new Matrix4d();
        m.setIdentity();
        return m;
    }

    private Value image(JsonValue image) throws GltfException {
        Value known = images.get(image);
        if (known == null) {
            known = read(image);
            images.put(image, known);
        }
        return known;
    }

    private Value read(JsonValue image) throws GltfException {
        JsonValue uri = image.find("uri");
        JsonValue view = image.find("bufferView");
        if (uri != null && view != null) {
            throw image.error("must not have both 'uri' and 'bufferView'");
        }
        if (uri == null && view == null) {
            throw image.error("needs the property 'uri' or 'bufferView'");
        }
        String name = "image " + image.index();
        if (view != null) {
            Buffers.Slice slice = buffers.view(view);
            byte[] bytes = Arrays.copyOfRange(slice.bytes(), slice.offset(), slice.offset() + slice.length());
            String mediaType = image.text("mimeType");
            return new Value.Content(name, ending(image, bytes, mediaType == null ? "" : mediaType), bytes);
        }
        if (uri != null && Uris.isData(uri.text())) {
            Uris.Data data = Uris.data(uri);
            return new Value.Content(name, ending(uri, data.bytes(), data.mediaType()), data.bytes());
        }
        JsonValue file = image.get("uri");
        Uris.file(file, container.file());
        return new Value.Text(Uris.name(file));
    }

    /** Type of an image: its first bytes go before what the document says, as they do in other readers. */
    private static String ending(JsonValue where, byte[] bytes, String mediaType) throws GltfException {
        if (bytes.length > 3 && bytes[0] == (byte) 0x89 && bytes[1] == 'P' && bytes[2] == 'N' && bytes[3] == 'G') {
            return "png";
        }
        if (bytes.length > 2 && bytes[0] == (byte) 0xff && bytes[1] == (byte) 0xd8) {
            return "jpg";
        }
        throw where.error("is neither a PNG nor a JPEG image"
                + (mediaType.isEmpty() ? "" : ", but " + JsonValue.quotable(mediaType.toLowerCase(Locale.ROOT))));
    }
}
