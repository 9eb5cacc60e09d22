package org.daybreak.scenes.description;

/**
 * A property of an object. Immutable.
 *
 * @param name its name; empty if the file gives none, as nested objects may
 * @param value its value
 * @param location its start tag
 */
public record PropertyDescription(String name, Value value, SourceLocation location) {}
