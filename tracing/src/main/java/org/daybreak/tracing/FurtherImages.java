package org.daybreak.tracing;

import java.util.List;
import java.util.Map;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.render.ImageSheet;

/**
 * Images that a pixelwise render makes besides the film's, such as one for each technique of an algorithm: a {@link RayProcessor} fills
 * {@link RaySample#further}. Each has a film of its own, of the same size and filter, and gets a value from each sample that the film
 * gets, so that images whose values add up to those of the film add up to its image. Immutable.
 */
public interface FurtherImages {
    /** No images. */
    FurtherImages NONE = new FurtherImages() {
        @Override
        public int count() {
            return 0;
        }

        @Override
        public Map<String, ImageSheet> sheets(List<FilmImage> images) {
            return Map.of();
        }
    };

    /** Number of images. */
    int count();

    /**
     * Arranges the finished images for the report.
     *
     * @param images as many as {@link #count()}
     * @return tables of images, see {@link org.daybreak.core.render.RenderReport#sheets()}
     */
    Map<String, ImageSheet> sheets(List<FilmImage> images);
}
