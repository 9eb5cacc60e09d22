package org.daybreak.bidirectional;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.daybreak.core.film.Film;
import org.daybreak.core.film.FilmImage;
import org.daybreak.core.film.FilmSettings;
import org.daybreak.core.film.ReconstructionFilter;
import org.daybreak.core.render.ImageSheet;
import org.daybreak.core.render.ParameterValues;
import org.daybreak.tracing.FurtherImages;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TechniqueViewsTest {
    private static FurtherImages views(String... settings) {
        Map<String, String> texts = new HashMap<>();
        for (int i = 0; i < settings.length; i += 2) {
            texts.put(settings[i], settings[i + 1]);
        }
        ParameterValues values =
                ParameterValues.parse(new BidirectionalRendererFactory().parameters(), texts, "bidirectional");
        return TechniqueViews.of(BidirectionalSettings.of(values), values);
    }

    private static ImageSheet sheet(FurtherImages views) {
        List<FilmImage> images = new ArrayList<>();
        for (int i = 0; i < views.count(); i++) {
            images.add(new Film(new FilmSettings(1, 1, ReconstructionFilter.BOX)).develop());
        }
        ImageSheet sheet = views.sheets(images).get("techniques");
        assertEquals(images.size(), sheet.cells().size());
        assertEquals(
                images.size(),
                sheet.cells().stream().map(ImageSheet.Cell::image).distinct().count());
        return sheet;
    }

    @Test
    void noneUnlessAFolderIsGiven() {
        assertEquals(0, views("techniquesDepth", "3").count());
        assertTrue(new BidirectionalRenderer(
                        BidirectionalSettings.of(ParameterValues.defaults(BidirectionalSettings.PARAMETERS)))
                .isResumable());
    }

    /** Paths of k edges can be made in k + 1 ways with t ≥ 1, one less without t = 1, and for k = 1 in one. */
    @ParameterizedTest
    @CsvSource({
        "-1, -1, -1, 3, true, false, 8, true",
        "-1, -1, -1, 3, false, false, 6, true",
        "-1, -1, 3, 3, true, false, 8, false",
        "-1, -1, 2, 6, true, false, 4, false",
        "2, 1, -1, 6, true, false, 2, false",
        "1, 3, -1, 6, true, false, 3, false",
        "-1, -1, -1, 3, true, true, 11, true",
        "-1, -1, 3, 3, true, true, 11, false"
    })
    void techniquesOfTheConfiguration(
            String eye,
            String light,
            String edges,
            String shown,
            String lens,
            String lensHits,
            int techniques,
            boolean longer) {
        FurtherImages views = views(
                "techniques",
                "x",
                "maxEyeDepth",
                eye,
                "maxLightDepth",
                light,
                "maxDepth",
                edges,
                "techniquesDepth",
                shown,
                "causticMap",
                lens,
                "lensHits",
                lensHits);
        assertEquals(2 * techniques + (longer ? 1 : 0), views.count());
        ImageSheet sheet = sheet(views);
        assertEquals(longer, sheet.rows().contains("longer paths"));
        for (ImageSheet.Cell cell : sheet.cells()) {
            if (cell.name().equals("longer")) {
                assertEquals("weighted", cell.block());
                continue;
            }
            assertEquals("s" + cell.column() + "t" + (cell.row() + 2 - cell.column()), cell.name());
            assertTrue(sheet.rows().get(cell.row()).startsWith("k=" + (cell.row() + 1)), cell.name());
        }
        assertFalse(sheet.cells().isEmpty());
    }
}
