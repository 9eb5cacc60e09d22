package org.daybreak.core.geometry;

import org.daybreak.core.math.Bounds;

/**
 * Where an emitter is, which way it shines and how much: what a light tree knows of it (Conty Estevez and Kulla, “Importance
 * Sampling of Many Lights with Adaptive Tree Splitting”, Proc. ACM Comput. Graph. Interact. Tech. 1, 2018, section 4).
 * No light leaves in a direction that is farther than {@code normalAngle + spread} from the axis.
 *
 * @param box box around the emitter
 * @param axisX unit axis of the cone that holds all normals
 * @param normalAngle half-angle of that cone in radians, from 0 to π; π if light goes everywhere
 * @param spread angle to the normal up to which light leaves, in radians: π/2 for surfaces, from where it falls off as the
 *     cosine; 0 for a cone of directions that is the whole of {@code normalAngle}
 * @param intensity estimate of the luminance of the radiant intensity along the axis, in W/sr; for surfaces the area times
 *     radiance that faces there
 */
public record EmissionBounds(
        Bounds box, double axisX, double axisY, double axisZ, double normalAngle, double spread, double intensity) {
    /** What emits everywhere from a box. */
    public static EmissionBounds everywhere(Bounds box, double intensity) {
        return new EmissionBounds(box, 0, 0, 1, Math.PI, Math.PI / 2, intensity);
    }

    /** The same emitter with its intensity multiplied by a factor. */
    public EmissionBounds scaled(double factor) {
        return new EmissionBounds(box, axisX, axisY, axisZ, normalAngle, spread, factor * intensity);
    }

    /** Bounds of both emitters. */
    EmissionBounds union(EmissionBounds o) {
        Bounds both = box.union(o.box);
        double sum = intensity + o.intensity;
        double widest = Math.max(spread, o.spread);
        if (o.normalAngle > normalAngle) {
            return o.union(this, both, widest, sum);
        }
        return union(o, both, widest, sum);
    }

    /** The same with the narrower of the cones. */
    private EmissionBounds union(EmissionBounds narrow, Bounds both, double widest, double sum) {
        double cosine = axisX * narrow.axisX + axisY * narrow.axisY + axisZ * narrow.axisZ;
        double between = Math.acos(Math.max(-1, Math.min(1, cosine)));
        if (Math.min(between + narrow.normalAngle, Math.PI) <= normalAngle) {
            return new EmissionBounds(both, axisX, axisY, axisZ, normalAngle, widest, sum);
        }
        double angle = 0.5 * (normalAngle + between + narrow.normalAngle);
        double sine = Math.sin(between);
        if (angle >= Math.PI || sine < 1e-9) {
            return sine < 1e-9 && cosine > 0
                    ? new EmissionBounds(both, axisX, axisY, axisZ, Math.min(Math.PI, angle + 1e-8), widest, sum)
                    : new EmissionBounds(both, 0, 0, 1, Math.PI, widest, sum);
        }
        // The new axis lies between the two, turned from the wider one's towards the other.
        double turn = angle - normalAngle;
        double own = Math.sin(between - turn) / sine;
        double other = Math.sin(turn) / sine;
        double x = own * axisX + other * narrow.axisX;
        double y = own * axisY + other * narrow.axisY;
        double z = own * axisZ + other * narrow.axisZ;
        double length = Math.sqrt(x * x + y * y + z * z);
        return new EmissionBounds(both, x / length, y / length, z / length, angle, widest, sum);
    }

    /**
     * Measure of the directions that light leaves to, each weighted with its fall-off (equation 1 of section 4.4 of the
     * paper).
     */
    double orientationMeasure() {
        double o = normalAngle;
        double w = Math.min(o + spread, Math.PI);
        return 2 * Math.PI * (1 - Math.cos(o))
                + Math.PI / 2 * (2 * w * Math.sin(o) - Math.cos(o - 2 * w) - 2 * o * Math.sin(o) + Math.cos(o));
    }

    /** Squared diagonal of the box. */
    double squaredDiagonal() {
        double x = box.maxX() - box.minX();
        double y = box.maxY() - box.minY();
        double z = box.maxZ() - box.minZ();
        return x * x + y * y + z * z;
    }
}
