package org.daybreak.core.render;

/** Takes the state of a render. Called in the thread that called the renderer. */
public interface CheckpointSink {
    /** Takes nothing. */
    CheckpointSink NONE = new CheckpointSink() {
        @Override
        public double intervalSeconds() {
            return Double.POSITIVE_INFINITY;
        }

        @Override
        public boolean takesStates() {
            return false;
        }

        @Override
        public void save(RenderState state) {
            // Nobody wants it.
        }
    };

    /** Seconds of work that may be lost at most, saving included; infinite to take the state at the end only. */
    double intervalSeconds();

    /** False if no state need be made at all. */
    default boolean takesStates() {
        return true;
    }

    /**
     * Takes a state. While this works the render goes on. The last call is for the end of the render, cancelled or not.
     *
     * @throws CheckpointException if that fails; the render then ends with this exception
     */
    void save(RenderState state);
}
