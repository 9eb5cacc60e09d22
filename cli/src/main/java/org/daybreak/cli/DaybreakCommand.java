package org.daybreak.cli;

import picocli.CommandLine.Command;

/** The program itself: its commands stand for themselves. */
@Command(
        name = "daybreak",
        description = "A physically based light-transport renderer.",
        footer = {
            "",
            "Examples:",
            "  daybreak render scene.xml              render a scene",
            "  daybreak render model.glb              render a model, with a fitting camera and light",
            "  daybreak render --help                 all options of a command",
            "  daybreak list renderers                renderers with their parameters",
            "  daybreak info scene.xml                what is in a scene or an image",
            "  daybreak diff picture.exr reference.exr"
        })
final class DaybreakCommand {
    DaybreakCommand() {}
}
