/**
 * Ray/scene intersection: bounding volume hierarchies over triangles, quadrics and instances.
 *
 * <p>Input is a {@link org.daybreak.core.accel.PrimitiveSet}; {@link org.daybreak.core.accel.Intersectors} picks the
 * fastest {@link org.daybreak.core.accel.IntersectorProvider} that runs well on this machine; the built
 * {@link org.daybreak.core.accel.Intersector} answers queries posed by a worker-owned
 * {@link org.daybreak.core.accel.Ray}; {@link org.daybreak.core.accel.HitRefinement} turns an answer into a point in
 * double precision and tells how far to move the origin of a ray that leaves it.
 *
 * <p>May depend on the JDK only.
 */
@NullMarked
package org.daybreak.core.accel;

import org.jspecify.annotations.NullMarked;
