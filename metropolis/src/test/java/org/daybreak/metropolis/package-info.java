@org.jspecify.annotations.NullMarked
package org.daybreak.metropolis;
