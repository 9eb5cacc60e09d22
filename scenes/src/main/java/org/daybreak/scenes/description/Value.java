package org.daybreak.scenes.description;

import javax.vecmath.Matrix4d;
import org.daybreak.core.geometry.TriangleMesh;

/** The value of a property, typed as the file says. Immutable; numbers are finite. */
public sealed interface Value {
    /** What it is, for messages: {@code "an integer"}. */
    String description();

    /** A whole number. */
    record WholeNumber(long value) implements Value {
        @Override
        public String description() {
            return "an integer";
        }
    }

    /** A real number. */
    record RealNumber(double value) implements Value {
        @Override
        public String description() {
            return "a float";
        }
    }

    /** True or false. */
    record Switch(boolean value) implements Value {
        @Override
        public String description() {
            return "a boolean";
        }
    }

    /** A text. */
    record Text(String value) implements Value {
        @Override
        public String description() {
            return "a string";
        }
    }

    /** A point or a vector. */
    record Triple(double x, double y, double z) implements Value {
        @Override
        public String description() {
            return "a point or vector";
        }
    }

    /** A colour in linear RGB with the primaries of sRGB. */
    record Color(double r, double g, double b) implements Value {
        @Override
        public String description() {
            return "an rgb colour";
        }
    }

    /** A spectrum that is the same at all wavelengths. As a light it is whiter than white is in RGB: illuminant E. */
    record FlatSpectrum(double value) implements Value {
        @Override
        public String description() {
            return "a spectrum";
        }
    }

    /**
     * A spectrum by wavelength, converted to linear RGB both ways: what it is as light has another white than what it is as
     * a property of a surface.
     */
    record SampledSpectrum(Color surface, Color light) implements Value {
        @Override
        public String description() {
            return "a spectrum";
        }
    }

    /** An affine transform. */
    record Transform(Matrix4d matrix) implements Value {
        /** Copies the matrix. */
        public Transform {
            matrix = new Matrix4d(matrix);
        }

        @Override
        public Matrix4d matrix() {
            return new Matrix4d(matrix);
        }

        @Override
        public String description() {
            return "a transform";
        }
    }

    /** A nested object. */
    record Nested(ObjectDescription object) implements Value {
        @Override
        public String description() {
            return "a " + object.kind().element();
        }
    }

    /** A reference to an object by its name. */
    record Reference(String id) implements Value {
        @Override
        public String description() {
            return "a reference";
        }
    }

    /** A mesh that a reader has in memory. */
    record Mesh(TriangleMesh mesh) implements Value {
        @Override
        public String description() {
            return "a mesh";
        }
    }

    /**
     * A file that is contained in another one.
     *
     * @param name how messages call it
     * @param ending what its name would end in, in lower case without the dot: the type of its content
     * @param bytes the content; not to be changed
     */
    record Content(String name, String ending, byte[] bytes) implements Value {
        @Override
        public String description() {
            return "an embedded file";
        }
    }

    /** A value that could not be parsed; the error has been reported, so nothing more need be said about it. */
    record Invalid() implements Value {
        @Override
        public String description() {
            return "invalid";
        }
    }
}
