package org.daybreak.core.film;

/** The film a renderer fills. */
public final class Film {
    private final FilmSettings settings;

    /** Creates an empty film. */
    public Film(FilmSettings settings) {
        this.settings = settings;
    }

    /** Size and filter. */
    public FilmSettings settings() {
        return settings;
    }
}
