package org.daybreak.core.geometry;

/** The square [−1,1]² in the plane z = 0, normal +z. Texture coordinates: u = (x+1)/2, v = (y+1)/2. */
public record Rectangle() implements Shape {}
