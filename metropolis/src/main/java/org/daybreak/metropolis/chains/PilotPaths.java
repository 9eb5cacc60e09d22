package org.daybreak.metropolis.chains;

import java.util.Arrays;

/** Paths that the surveys of a pilot have found, sample by sample, as a structure of arrays. */
final class PilotPaths implements PilotWorker.Survey {
    private static final int INITIAL_CAPACITY = 64;

    private final PilotSteps steps = new PilotSteps();
    private int surveys;
    private double work;
    private int size;
    private long[] pattern = new long[INITIAL_CAPACITY];
    private double[] filmX = new double[INITIAL_CAPACITY];
    private double[] filmY = new double[INITIAL_CAPACITY];
    private double[] weight = new double[INITIAL_CAPACITY];
    private PilotWorker.By[] by = new PilotWorker.By[INITIAL_CAPACITY];
    private int[] sample = new int[INITIAL_CAPACITY];
    private int[] survey = new int[INITIAL_CAPACITY];

    void clear() {
        size = 0;
        surveys = 0;
        work = 0;
        steps.clear();
    }

    /** Ends the survey whose paths were added last. */
    void endSurvey() {
        surveys++;
    }

    /** Adds work of samples. */
    void addWork(double ofSamples) {
        work += ofSamples;
    }

    /** Work of all samples together. */
    double work() {
        return work;
    }

    /** Steps of chains from these paths. */
    PilotSteps steps() {
        return steps;
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

    /** Number of the sample that has found a path, in its half of the survey. */
    int sample(int path) {
        return sample[path];
    }

    @Override
    public void moved(long kind, double w, double ofStep) {
        steps.add(kind, w, ofStep);
    }

    @Override
    public void found(long kind, double x, double y, double w, PilotWorker.By finder, int number) {
        reserve(size + 1);
        filmX[size] = x;
        filmY[size] = y;
        weight[size] = w;
        pattern[size] = kind;
        by[size] = finder;
        sample[size] = number;
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
        System.arraycopy(others.sample, 0, sample, size, others.size);
        for (int i = 0; i < others.size; i++) {
            survey[size + i] = surveys + others.survey[i];
        }
        size += others.size;
        surveys += others.surveys;
        work += others.work;
        steps.addAll(others.steps);
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
        sample = Arrays.copyOf(sample, capacity);
        survey = Arrays.copyOf(survey, capacity);
    }
}
