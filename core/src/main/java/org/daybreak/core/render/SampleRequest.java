package org.daybreak.core.render;

import org.daybreak.core.film.FilmSettings;

/**
 * Asks for a single sample of a render once more.
 *
 * @param address which one
 * @param film size and filter of the film; the crop plays no part
 * @param antialiasing the antialiasing method of the render
 * @param samplesPerPixel samples per pixel of the render, as {@link Antialiasing#samplesPerPixel} returns it
 */
public record SampleRequest(SampleAddress address, FilmSettings film, Antialiasing antialiasing, long samplesPerPixel) {
    /**
     * Checks that there is such a sample. With a method that divides samples among pixels, any number may be one.
     *
     * @throws ParameterException if pixel or sample is out of range
     */
    public SampleRequest {
        if (address.x() < 0 || address.y() < 0 || address.x() >= film.width() || address.y() >= film.height()) {
            throw new ParameterException("there is no pixel (" + address.x() + ", " + address.y() + ") in an image of "
                    + film.width() + "x" + film.height() + " pixels");
        }
        boolean any = antialiasing.allocation().isPresent();
        if (address.sample() < 0 || (!any && address.sample() >= samplesPerPixel)) {
            throw new ParameterException("there is no sample " + address.sample() + " of a pixel that has "
                    + samplesPerPixel + ": they are numbered from 0");
        }
    }
}
