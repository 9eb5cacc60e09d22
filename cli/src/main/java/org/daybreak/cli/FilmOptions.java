package org.daybreak.cli;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.daybreak.core.film.FilmLayer;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.render.NearestName;
import org.jspecify.annotations.Nullable;

/** Understands the options {@code --size}, {@code --crop} and {@code --layers}. */
final class FilmOptions {
    private FilmOptions() {}

    /**
     * The scene's film with the size and crop of the command line.
     *
     * @param size {@code WxH} in pixels, null for the scene's; a new size drops the scene's crop
     * @param crop {@code X,Y,W,H} in pixels, null for the scene's
     */
    static FilmSettings apply(FilmSettings film, @Nullable String size, @Nullable String crop) {
        try {
            FilmSettings sized = film;
            if (size != null) {
                int[] wh = numbers("--size", size, "x", "WxH, such as 640x480", 2);
                sized = new FilmSettings(wh[0], wh[1], film.filter()).withFilterSampling(film.filterSampling());
            }
            if (crop == null) {
                return sized;
            }
            int[] c = numbers("--crop", crop, ",", "X,Y,W,H, such as 0,0,32,32", 4);
            return new FilmSettings(
                    sized.width(),
                    sized.height(),
                    new FilmSettings.Crop(c[0], c[1], c[2], c[3]),
                    sized.filter(),
                    sized.filterSampling());
        } catch (IllegalArgumentException e) {
            throw new CommandException(ExitCode.USAGE, String.valueOf(e.getMessage()), e);
        }
    }

    /** Auxiliary images by name. */
    static Set<FilmLayer> layers(List<String> ids) {
        Set<FilmLayer> layers = EnumSet.noneOf(FilmLayer.class);
        for (String id : ids) {
            layers.add(layer(id.trim()));
        }
        return layers;
    }

    /** Names of all auxiliary images. */
    static List<String> layerIds() {
        List<String> ids = new ArrayList<>();
        for (FilmLayer layer : FilmLayer.values()) {
            ids.add(layer.id());
        }
        return ids;
    }

    private static FilmLayer layer(String id) {
        for (FilmLayer layer : FilmLayer.values()) {
            if (layer.id().equals(id)) {
                return layer;
            }
        }
        throw new CommandException(ExitCode.USAGE, "there is no layer '" + id + "'" + NearestName.hint(id, layerIds()));
    }

    /** Whole numbers with separators between them; {@link ExitCode#USAGE} if the text has another form. */
    static int[] numbers(String option, String text, String separator, String form, int count) {
        String[] parts = text.split(separator, -1);
        int[] numbers = new int[count];
        try {
            for (int i = 0; i < count && parts.length == count; i++) {
                numbers[i] = Integer.parseInt(parts[i].trim());
            }
        } catch (NumberFormatException e) {
            throw new CommandException(ExitCode.USAGE, badForm(option, text, form), e);
        }
        if (parts.length != count) {
            throw new CommandException(ExitCode.USAGE, badForm(option, text, form));
        }
        return numbers;
    }

    private static String badForm(String option, String text, String form) {
        return option + " is '" + text + "' but must be of the form " + form;
    }
}
