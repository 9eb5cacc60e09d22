package org.daybreak.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** Tiny scenes. */
final class TestScenes {
    static final String INTEGRATOR = "<integrator type=\"path\"><integer name=\"max_depth\" value=\"3\"/></integrator>";

    static final String SENSOR = """
            <sensor type="perspective">
                <string name="fov_axis" value="x"/><float name="fov" value="90"/>
                <transform name="to_world"><lookat origin="0, 0, 1" target="0, 0, 0" up="0, 1, 0"/></transform>
                <sampler type="independent"><integer name="sample_count" value="$spp"/></sampler>
                <film type="hdrfilm"><integer name="width" value="8"/><integer name="height" value="8"/>
                    <rfilter type="box"/></film>
            </sensor>
            """;

    /** Fills the middle half of the picture in both directions. */
    static final String LIGHT = """
            <shape type="rectangle">
                <transform name="to_world"><scale value="0.5"/></transform>
                <emitter type="area"><rgb name="radiance" value="4, 2, 1"/></emitter>
            </shape>
            """;

    /** A wall behind the light that is lit from the front by a point. */
    static final String WALL = """
            <shape type="rectangle">
                <transform name="to_world"><scale value="9"/><translate z="-1"/></transform>
                <bsdf type="diffuse"><rgb name="reflectance" value="0.5, 0.5, 0.5"/></bsdf>
            </shape>
            <emitter type="point"><point name="position" x="0" y="3" z="1"/>
                <rgb name="intensity" value="9, 9, 9"/></emitter>
            """;

    private TestScenes() {}

    /** A scene around some content. */
    static String scene(String... content) {
        return "<scene version=\"3.0.0\">\n<default name=\"spp\" value=\"4\"/>\n" + String.join("\n", content)
                + "\n</scene>\n";
    }

    /** Light, wall and a path tracer of depth 3. */
    static String usual() {
        return scene(INTEGRATOR, SENSOR, LIGHT, WALL);
    }

    /** A light before nothing: the picture is the same whatever the random numbers. */
    static String lightOnly() {
        return scene(INTEGRATOR, SENSOR, LIGHT);
    }

    /** Writes a scene file. */
    static Path write(Path folder, String text) throws IOException {
        return Files.writeString(folder.resolve("tiny.xml"), text);
    }
}
