package org.daybreak.scenes.model;

import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.vecmath.Matrix4d;
import org.daybreak.scenes.description.ObjectDescription;
import org.daybreak.scenes.description.ObjectKind;
import org.daybreak.scenes.description.ProblemList;
import org.daybreak.scenes.description.PropertyDescription;
import org.daybreak.scenes.description.SourceLocation;
import org.daybreak.scenes.description.Value;
import org.jspecify.annotations.Nullable;

/**
 * A texture statement of an MTL file: options, then a file name that may contain blanks.
 *
 * @param bitmap the texture
 * @param file the image, which exists
 * @param multiplier the number of {@code -bm}, 1 if there is none
 */
record MtlTexture(ObjectDescription bitmap, Path file, double multiplier) {
    /** Largest scale and offset of a texture, and one over the smallest scale. */
    private static final double LARGEST_SCALE = 1e30;

    /** Most numbers behind an option. */
    private static final int MOST_ARGUMENTS = 3;

    private static final Pattern WORD = Pattern.compile("\\S+");

    /**
     * Reads a statement.
     *
     * @param raw whether values are numbers rather than colours
     * @return null if there is no such file, which is reported as a warning
     */
    static @Nullable MtlTexture read(String argument, boolean raw, SourceLocation location, ProblemList problems) {
        List<PropertyDescription> properties = new ArrayList<>();
        double[] scale = {1, 1};
        double[] offset = {0, 0};
        double multiplier = 1;
        boolean clamped = false;
        String statement = argument.strip();
        Matcher word = WORD.matcher(statement);
        int at = 0;
        while (statement.startsWith("-", at)) {
            List<String> words = new ArrayList<>();
            int[] starts = new int[MOST_ARGUMENTS + 2];
            Arrays.fill(starts, statement.length());
            for (int from = at; words.size() < starts.length && word.find(from); from = word.end()) {
                starts[words.size()] = word.start();
                words.add(word.group());
            }
            String option = words.get(0).toLowerCase(Locale.ROOT);
            int used = 1;
            if (option.equals("-s") || option.equals("-o") || option.equals("-t")) {
                while (used <= MOST_ARGUMENTS && used < words.size() && MtlMaterial.number(words.get(used)) != null) {
                    Double value = MtlMaterial.number(words.get(used));
                    if (used <= 2 && value != null && !option.equals("-t")) {
                        (option.equals("-s") ? scale : offset)[used - 1] = value;
                    }
                    used++;
                }
            } else {
                used = option.equals("-mm") ? 3 : 2;
                String value = words.size() > 1 ? words.get(1) : "";
                Double number = option.equals("-bm") ? MtlMaterial.number(value) : null;
                multiplier = number == null ? multiplier : number;
                if (option.equals("-clamp") && !value.isEmpty()) {
                    clamped = value.equals("on");
                }
            }
            at = starts[used];
        }
        String name = statement.substring(at).strip().replace('\\', '/');
        Path file;
        try {
            file = location.file().resolveSibling(name);
            if (name.isEmpty() || !Files.isRegularFile(file)) {
                problems.warning(location, "the texture '" + name + "' does not exist");
                return null;
            }
        } catch (InvalidPathException e) {
            problems.warning(location, "'" + name + "' is no file name");
            return null;
        }
        properties.add(new PropertyDescription("filename", new Value.Text(name), location));
        if (raw) {
            properties.add(new PropertyDescription("raw", new Value.Switch(true), location));
        }
        if (clamped) {
            properties.add(new PropertyDescription("wrap_mode", new Value.Text("clamp"), location));
        }
        if (!isUsable(scale, offset)) {
            problems.warning(
                    location, "scale and offset of the texture '" + argument + "' are passed over: too small or large");
        } else if (scale[0] != 1 || scale[1] != 1 || offset[0] != 0 || offset[1] != 0) {
            // v counts from the bottom in the file and from the top here: 1 − (s·v + o) = s·(1 − v) + 1 − s − o.
            Matrix4d m = new Matrix4d(
                    scale[0], 0, 0, offset[0], 0, scale[1], 0, 1 - scale[1] - offset[1], 0, 0, 1, 0, 0, 0, 0, 1);
            properties.add(new PropertyDescription("to_uv", new Value.Transform(m), location));
        }
        return new MtlTexture(
                new ObjectDescription(ObjectKind.TEXTURE, "bitmap", null, location, properties), file, multiplier);
    }

    /** Whether a texture can be placed that way: the inverse must exist, in numbers of ordinary size. */
    private static boolean isUsable(double[] scale, double[] offset) {
        boolean usable = true;
        for (int i = 0; i < 2; i++) {
            double s = Math.abs(scale[i]);
            usable &= s >= 1 / LARGEST_SCALE && s <= LARGEST_SCALE && Math.abs(offset[i]) <= LARGEST_SCALE;
        }
        return usable;
    }
}
