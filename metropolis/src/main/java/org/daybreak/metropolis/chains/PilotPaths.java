package org.daybreak.metropolis.chains;

import java.util.Arrays;

/** Paths that the surveys of a pilot have found, sample by sample, as a structure of arrays. */
final class PilotPaths implements PilotWorker.Survey {
    private static final int INITIAL_CAPACITY = 64;

    private int surveys;
    private long rays;
    private int size;
    private long[] pattern = new long[INITIAL_CAPACITY];
    private double[] filmX = new double[INITIAL_CAPACITY];
    private double[] filmY = new double[INITIAL_CAPACITY];
    private double[] weight = new double[INITIAL_CAPACITY];
    private PilotWorker.By[] by = new PilotWorker.By[INITIAL_CAPACITY];
    private int[] survey = new int[INITIAL_CAPACITY];

    void clear() {
        size = 0;
        surveys = 0;
        rays = 0;
    }

    /** Ends the survey whose paths were added last. */
    void endSurvey() {
        surveys++;
    }

    /** Counts rays of surveys that are not for occlusion. */
    void addRays(long number) {
        rays += number;
    }

    /** Number of such rays. */
    long rays() {
        return rays;
    }

    /** Number of surveys, with those that have found nothing. */
    int surveys() {
        return surveys;
    }

    /** Number of paths. */
    int size() {
        return size;
    }

    long pattern(int path) {
        return pattern[path];
    }

    double filmX(int path) {
        return filmX[path];
    }

    double filmY(int path) {
        return filmY[path];
    }

    double weight(int path) {
        return weight[path];
    }

    /** What has found a path. */
    PilotWorker.By by(int path) {
        return by[path];
    }

    /** Number of the survey that has found a path. */
    int survey(int path) {
        return survey[path];
    }

    @Override
    public void found(long kind, double x, double y, double w, PilotWorker.By finder) {
        reserve(size + 1);
        filmX[size] = x;
        filmY[size] = y;
        weight[size] = w;
        pattern[size] = kind;
        by[size] = finder;
        survey[size] = surveys;
        size++;
    }

    /** Adds the surveys of others behind these. */
    void addAll(PilotPaths others) {
        reserve(size + others.size);
        System.arraycopy(others.filmX, 0, filmX, size, others.size);
        System.arraycopy(others.filmY, 0, filmY, size, others.size);
        System.arraycopy(others.weight, 0, weight, size, others.size);
        System.arraycopy(others.pattern, 0, pattern, size, others.size);
        System.arraycopy(others.by, 0, by, size, others.size);
        for (int i = 0; i < others.size; i++) {
            survey[size + i] = surveys + others.survey[i];
        }
        size += others.size;
        surveys += others.surveys;
        rays += others.rays;
    }

    private void reserve(int paths) {
        if (paths <= weight.length) {
            return;
        }
        int capacity = Math.max(paths, 2 * weight.length);
        pattern = Arrays.copyOf(pattern, capacity);
        filmX = Arrays.copyOf(filmX, capacity);
        filmY = Arrays.copyOf(filmY, capacity);
        weight = Arrays.copyOf(weight, capacity);
        by = Arrays.copyOf(by, capacity);
        survey = Arrays.copyOf(survey, capacity);
    }
}
