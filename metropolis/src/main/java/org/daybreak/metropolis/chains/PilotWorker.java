package org.daybreak.metropolis.chains;

import org.daybreak.core.scene.RayKind;

/** Draws samples that show what samples and what chains would make of the paths of a scene. One object per thread. */
public interface PilotWorker {
    /** The pattern of all paths that are too short for chains. */
    long SHORT = -1;

    /** Number of samples that a {@link #survey} draws twice, and of candidates in half of it. */
    int BLOCK = 4;

    /** What has found a path. */
    enum By {
        /** A candidate for the start of chains, anywhere on the film. */
        CANDIDATES,
        /** The samples of a pixel. */
        FIRST,
        /** Other such samples of the same pixel. */
        SECOND
    }

    /** Told of the paths that are found. */
    interface Survey {
        /**
         * A path.
         *
         * @param pattern the kind of path, or {@link #SHORT}
         * @param filmX where it is on the film, in pixels
         * @param weight w·f* / p over the number of candidates or samples: the expectation of the sum over the paths of the candidates is the mean
         *     luminance of the image, and that over those of the samples the luminance of the pixel, but for kinds of paths that such samples
         *     cannot find, or by chance only
         * @param sample number of the sample in its half of the survey, from 0; 0 for candidates
         */
        void found(long pattern, double filmX, double filmY, double weight, By by, int sample);

        /**
         * A step that a chain has tried from a path that a candidate has found.
         *
         * @param pattern the kind of path that it was at
         * @param weight of such steps: their mean is that over chains, as with independent paths of the chains' density
         * @param work of the step, as of {@link #work()}
         */
        void moved(long pattern, double weight, double work);
    }

    /**
     * Draws some candidates for the starts of chains, tries steps from there, and draws as many samples of one pixel, in two halves; the random
     * numbers are those of the index.
     *
     * @param column of the pixel
     * @param row of the pixel
     */
    void survey(long index, int column, int row, Survey found);

    /** Number of rays of a kind traced so far. */
    long rays(RayKind kind);

    /** Work of the samples so far, in rays that find the nearest surface; in what else takes time, as if it were such rays. */
    double work();
}
