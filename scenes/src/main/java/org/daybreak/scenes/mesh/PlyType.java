package org.daybreak.scenes.mesh;

/** Type of a number in a PLY file. */
enum PlyType {
    INT8(1),
    UINT8(1),
    INT16(2),
    UINT16(2),
    INT32(4),
    UINT32(4),
    FLOAT32(4),
    FLOAT64(8);

    final int bytes;

    PlyType(int bytes) {
        this.bytes = bytes;
    }

    boolean isInteger() {
        return this != FLOAT32 && this != FLOAT64;
    }
}
