package org.daybreak.cli;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A small scene with all that debug views tell apart: a light that is seen, glass, a mirror, diffuse walls, a point light. */
final class BidirectionalScene {
    private static final String CONTENT = """
            <integrator type="path"><integer name="max_depth" value="$depth"/></integrator>
            <sensor type="perspective">
                <string name="fov_axis" value="x"/><float name="fov" value="60"/>
                <transform name="to_world"><lookat origin="0, 1, 4" target="0, 1, 0" up="0, 1, 0"/></transform>
                <sampler type="independent"><integer name="sample_count" value="4"/></sampler>
                <film type="hdrfilm"><integer name="width" value="24"/><integer name="height" value="20"/>
                    <rfilter type="$filter"/></film>
            </sensor>
            <shape type="rectangle">
                <transform name="to_world"><scale value="3"/><rotate x="1" angle="-90"/></transform>
                <bsdf type="diffuse"><rgb name="reflectance" value="0.7, 0.6, 0.5"/></bsdf>
            </shape>
            <shape type="rectangle">
                <transform name="to_world"><scale value="3"/><translate z="-1.5"/></transform>
                <bsdf type="diffuse"><rgb name="reflectance" value="0.2, 0.4, 0.7"/></bsdf>
            </shape>
            <shape type="sphere">
                <point name="center" x="-0.8" y="0.6" z="0"/><float name="radius" value="0.6"/>
                <bsdf type="dielectric"/>
            </shape>
            <shape type="sphere">
                <point name="center" x="0.8" y="0.6" z="-0.5"/><float name="radius" value="0.6"/>
                <bsdf type="conductor"/>
            </shape>
            <shape type="rectangle">
                <transform name="to_world"><scale value="0.4"/><rotate x="1" angle="90"/><translate y="1.9"/></transform>
                <emitter type="area"><rgb name="radiance" value="9, 8, 6"/></emitter>
            </shape>
            <emitter type="point"><point name="position" x="1" y="2" z="1"/>
                <rgb name="intensity" value="1, 1, 2"/></emitter>
            """;

    private BidirectionalScene() {}

    /** Writes the scene; its parameters are {@code depth}, 4 by default, and {@code filter}, {@code box} by default. */
    static Path write(Path folder) throws IOException {
        return Files.writeString(
                folder.resolve("views.xml"),
                "<scene version=\"3.0.0\">\n<default name=\"depth\" value=\"4\"/>\n"
                        + "<default name=\"filter\" value=\"box\"/>\n" + CONTENT + "</scene>\n");
    }
}
