package org.daybreak.metropolis.chains;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.film.SplatBuffer;
import org.junit.jupiter.api.Test;

class RoughImageTest {
    private static final FilmSettings FILM = new FilmSettings(10, 6, ReconstructionFilter.BOX);

    /** Cells of 4×4, 2×4, 4×2 and 2×2 pixels. */
    @Test
    void isOneOverTheLuminanceInUnitsOfTheMean() {
        RoughImage image = new RoughImage(FILM, 4);
        SplatBuffer splats = new SplatBuffer();
        splats.add(1, 1, 16, 16, 16);
        splats.add(9.9, 5.9, 12, 12, 12);
        splats.add(8, 4, 12, 12, 12);
        splats.add(5, 5, 8 / 25.0, 8 / 25.0, 8 / 25.0);
        image.add(splats, 100);
        ImageImportance importance = image.importance(1000);
        double mean = (16 + 24 + 8 / 25.0) / 60;
        assertEquals(mean, importance.at(3.99, 3.99), 1e-12);
        assertEquals(mean / 6, importance.at(8, 4), 1e-12);
        assertEquals(mean / 6, importance.at(9.99, 5.99), 1e-12);
        assertEquals(mean * 25, importance.at(5, 5), 1e-12);
        // Dark cells have the floor.
        assertEquals(20, importance.at(5, 1), 1e-12);
        assertEquals(20, importance.at(9, 1), 1e-12);
    }

    @Test
    void isOneWithoutLight() {
        assertSame(ImageImportance.UNIFORM, new RoughImage(FILM, 4).importance(1000));
        assertEquals(1, ImageImportance.UNIFORM.at(1e9, -5));
    }

    /** Six cells. */
    @Test
    void theFloorRisesWhereLittleIsKnown() {
        for (int chains : new int[] {24, 48}) {
            RoughImage image = new RoughImage(FILM, 4);
            SplatBuffer splats = new SplatBuffer();
            splats.add(1, 1, 16, 16, 16);
            image.add(splats, 2400);
            assertEquals(chains == 24 ? 2 : 4, image.importance(chains).at(9, 5), 1e-12);
            assertEquals(1, image.importance(1).at(9, 5) / 2, 1e-12);
        }
        assertEquals(1, oneStep().importance(1).at(9, 5), 1e-12);
    }

    private static RoughImage oneStep() {
        RoughImage image = new RoughImage(FILM, 4);
        SplatBuffer splats = new SplatBuffer();
        splats.add(1, 1, 1, 1, 1);
        image.add(splats, 1);
        return image;
    }

    @Test
    void importanceIsSaved() {
        RoughImage image = new RoughImage(FILM, 4);
        SplatBuffer splats = new SplatBuffer();
        splats.add(1, 1, 16, 16, 16);
        image.add(splats, 100);
        ImageImportance importance = image.importance(1000);
        StateWriter out = new StateWriter();
        importance.save(out);
        ImageImportance same = ImageImportance.load(new StateReader(out.toArray()));
        for (int y = 0; y < 6; y++) {
            for (int x = 0; x < 10; x++) {
                assertEquals(importance.at(x + 0.5, y + 0.5), same.at(x + 0.5, y + 0.5));
            }
        }
    }
}
