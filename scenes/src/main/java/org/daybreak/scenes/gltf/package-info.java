/**
 * Reads glTF 2.0 files, text and binary, into description records. Places in a file are named by JSON pointers (RFC 6901).
 * What is supported and how it is mapped: {@code docs/formats.md}.
 *
 * <p>May depend on: {@code scenes.description}, {@code scenes.mesh}, {@code scenes.model}, {@code core}, vecmath, Jackson's streaming
 * parser.
 */
@NullMarked
package org.daybreak.scenes.gltf;

import org.jspecify.annotations.NullMarked;
