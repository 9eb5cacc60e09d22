package org.daybreak.exr.imageio;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.daybreak.exr.Compression;
import org.daybreak.exr.ExrHeader;
import org.daybreak.exr.ExrImage;
import org.daybreak.exr.ExrReader;
import org.daybreak.exr.ExrWriteOptions;
import org.daybreak.exr.ExrWriter;
import org.daybreak.exr.HdrImage;
import org.daybreak.exr.Pfm;
import org.daybreak.exr.PfmImage;
import org.daybreak.exr.PixelType;
import org.daybreak.exr.RadianceHdr;

/** The file formats of this plug-in. */
enum LinearFormat {
    /** OpenEXR. */
    EXR(List.of("exr", "openexr"), List.of("exr"), "image/x-exr") {
        @Override
        boolean starts(byte[] head) {
            return head[0] == 0x76 && head[1] == 0x2f && head[2] == 0x31 && head[3] == 0x01;
        }

        @Override
        List<PictureSource> open(byte[] bytes) throws IOException {
            List<PictureSource> sources = new ArrayList<>();
            List<ExrHeader> headers = ExrReader.readHeaders(STREAM, bytes);
            for (int part = 0; part < headers.size(); part++) {
                sources.add(new ExrPictureSource(bytes, headers.get(part), part));
            }
            return sources;
        }

        @Override
        byte[] encode(LinearPicture picture, String compression) throws IOException {
            String[] names = switch (picture.components()) {
                case 1 -> new String[] {"Y"};
                case 2 -> new String[] {"Y", "A"};
                case 3 -> new String[] {"R", "G", "B"};
                default -> new String[] {"R", "G", "B", "A"};
            };
            ExrImage image = ExrImage.builder(picture.width(), picture.height())
                    .interleavedLayer("", PixelType.FLOAT, picture.samples(), names)
                    .build();
            ExrWriteOptions options = ExrWriteOptions.defaults().withCompression(Compression.valueOf(compression));
            return ExrWriter.toBytes(STREAM, List.of(image), options);
        }

        @Override
        boolean holds(int components) {
            return true;
        }

        @Override
        List<String> compressions() {
            List<String> names = new ArrayList<>();
            for (Compression compression : Compression.values()) {
                if (compression.isWritable()) {
                    names.add(compression.name());
                }
            }
            return names;
        }
    },
    /** Radiance HDR. */
    HDR(List.of("hdr", "rgbe"), List.of("hdr", "pic"), "image/vnd.radiance") {
        @Override
        boolean starts(byte[] head) {
            return head[0] == '#' && head[1] == '?';
        }

        @Override
        List<PictureSource> open(byte[] bytes) throws IOException {
            HdrImage image = RadianceHdr.read(STREAM, bytes);
            if (image.colorSpace() != HdrImage.ColorSpace.RGB) {
                throw new IOException("Radiance images of " + image.colorSpace() + " are not supported by ImageIO");
            }
            return List.of(PictureSource.of(new LinearPicture(image.width(), image.height(), 3, image.samples())));
        }

        @Override
        byte[] encode(LinearPicture picture, String compression) throws IOException {
            return RadianceHdr.toBytes(STREAM, new HdrImage(picture.width(), picture.height(), rgb(picture)));
        }

        @Override
        boolean holds(int components) {
            return components % 2 == 1;
        }
    },
    /** Portable float map. */
    PFM(List.of("pfm"), List.of("pfm"), "image/x-portable-floatmap") {
        @Override
        boolean starts(byte[] head) {
            return head[0] == 'P' && (head[1] == 'F' || head[1] == 'f') && head[2] <= ' ';
        }

        @Override
        List<PictureSource> open(byte[] bytes) throws IOException {
            PfmImage image = Pfm.read(STREAM, bytes);
            return List.of(PictureSource.of(
                    new LinearPicture(image.width(), image.height(), image.components(), image.samples())));
        }

        @Override
        byte[] encode(LinearPicture picture, String compression) throws IOException {
            return Pfm.toBytes(
                    STREAM, new PfmImage(picture.width(), picture.height(), picture.components(), picture.samples()));
        }

        @Override
        boolean holds(int components) {
            return components % 2 == 1;
        }
    };

    /** What errors call the file. */
    private static final String STREAM = "the image stream";

    /** Bytes that {@link #starts} looks at. */
    static final int HEAD_BYTES = 4;

    private final List<String> names;
    private final List<String> suffixes;
    private final String mimeType;

    LinearFormat(List<String> names, List<String> suffixes, String mimeType) {
        this.names = names;
        this.suffixes = suffixes;
        this.mimeType = mimeType;
    }

    /** Names of the format, also in capitals, as ImageIO compares them letter by letter. */
    String[] names() {
        List<String> all = new ArrayList<>(names);
        names.forEach(name -> all.add(name.toUpperCase(Locale.ROOT)));
        return all.toArray(String[]::new);
    }

    /** Endings of file names. */
    String[] suffixes() {
        return suffixes.toArray(String[]::new);
    }

    /** MIME types. */
    String[] mimeTypes() {
        return new String[] {mimeType};
    }

    /** Tells whether a file begins like this format. */
    abstract boolean starts(byte[] head);

    /** The images of a file. */
    abstract List<PictureSource> open(byte[] bytes) throws IOException;

    /**
     * Writes an image.
     *
     * @param compression one of {@link #compressions()}; of no meaning if there is none
     */
    abstract byte[] encode(LinearPicture picture, String compression) throws IOException;

    /** Tells whether images of so many components can be written. */
    abstract boolean holds(int components);

    /** Names of the compressions that can be chosen; may be empty. */
    List<String> compressions() {
        return List.of();
    }

    private static float[] rgb(LinearPicture picture) {
        if (picture.components() == 3) {
            return picture.samples();
        }
        float[] rgb = new float[3 * picture.samples().length];
        for (int i = 0; i < rgb.length; i++) {
            rgb[i] = picture.samples()[i / 3];
        }
        return rgb;
    }
}
