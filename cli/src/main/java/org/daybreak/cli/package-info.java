/**
 * The command {@code daybreak}. Each command is a class; what commands share (reading scenes, writing images, statistics,
 * progress) has classes of its own.
 *
 * <p>May depend on: all modules, through the renderer interface of {@code core.render}.
 */
@NullMarked
package org.daybreak.cli;

import org.jspecify.annotations.NullMarked;
