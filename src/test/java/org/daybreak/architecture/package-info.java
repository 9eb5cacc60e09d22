/** Rules about the code as a whole: which module may use which, and what library code must not do. */
@NullMarked
package org.daybreak.architecture;

import org.jspecify.annotations.NullMarked;
