package org.daybreak.metropolis.chains;

/** Whether samples take a part of the light off the chains: see {@link SamplePlan}. */
public enum Sharing {
    /** If a pilot says that it pays. */
    AUTO,
    /** In any case. */
    ALWAYS,
    /** Chains find all but what is lit directly. */
    NEVER
}
