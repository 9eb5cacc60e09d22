/**
 * Partial films in files: checkpoints and parts of renders. {@code docs/partial-films.md} describes the format. This is library
 * code, also for programs that spread a render over machines; it does not know the command line.
 */
@NullMarked
package org.daybreak.cli.partial;

import org.jspecify.annotations.NullMarked;
