package org.daybreak.core.scene;

/** What a ray is traced for; statistics count by it. */
public enum RayKind {
    /** First ray of an eye path. */
    CAMERA,
    /** First ray of a light path. */
    LIGHT,
    /** Further rays of a path: closest hit after scattering. */
    SCATTERED,
    /** Occlusion between two points. */
    SHADOW
}
