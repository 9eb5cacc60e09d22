package org.daybreak.core.geometry;

/** The cube [−1,1]³, normals outwards; each face has texture coordinates [0,1]². */
public record Cube() implements Shape {}
