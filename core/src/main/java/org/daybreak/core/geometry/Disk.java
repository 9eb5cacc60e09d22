package org.daybreak.core.geometry;

/** The unit disk in the plane z = 0, normal +z. Texture coordinates: u = radius, v = φ/2π. */
public record Disk() implements Shape {}
