/** Statistical tests and grids shared by the tests of all modules. Every assertion states its false-alarm rate. */
@NullMarked
package org.daybreak.core.testing;

import org.jspecify.annotations.NullMarked;
