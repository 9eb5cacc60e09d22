package org.daybreak.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;
import picocli.CommandLine.Model.PositionalParamSpec;

/**
 * The manual page is what the commands say of themselves. With {@code -Ddaybreak.update=true} the test writes {@code
 * docs/daybreak.1} anew.
 */
class ManPageTest {
    private static final Path PAGE = Path.of(System.getProperty("daybreak.root"), "docs", "daybreak.1");

    @Test
    void pageIsInStepWithTheCommands() throws IOException {
        String page = page();
        if (Boolean.getBoolean("daybreak.update")) {
            Files.writeString(PAGE, page);
        }
        assertEquals(
                Files.readString(PAGE), page, "run mvn -pl cli -am test -Dtest=ManPageTest -Ddaybreak.update=true");
    }

    private static String page() {
        CommandLine daybreak = Main.commandLine(new Session(System.out, System.err, new Interrupts()));
        StringBuilder out = new StringBuilder();
        out.append(".TH DAYBREAK 1 \"\" \"Daybreak\" \"User Commands\"\n");
        out.append(".SH NAME\ndaybreak \\- ");
        out.append(escaped(first(daybreak.getCommandSpec()))).append('\n');
        out.append(".SH SYNOPSIS\n");
        for (Map.Entry<String, CommandLine> command : daybreak.getSubcommands().entrySet()) {
            out.append(".B daybreak ").append(command.getKey()).append('\n');
            for (PositionalParamSpec parameter :
                    command.getValue().getCommandSpec().positionalParameters()) {
                String more = parameter.arity().max() > 1 ? "..." : "";
                out.append(".I ").append(escaped(parameter.paramLabel() + more)).append('\n');
            }
            out.append("[options]\n.br\n");
        }
        for (Map.Entry<String, CommandLine> command : daybreak.getSubcommands().entrySet()) {
            section(command.getKey(), command.getValue().getCommandSpec(), out);
        }
        out.append(".SH EXIT STATUS\n");
        for (ExitCode code : ExitCode.values()) {
            out.append(".TP\n.B ").append(code.number()).append('\n');
            out.append(escaped(code.meaning())).append('\n');
        }
        return out.toString();
    }

    private static void section(String name, CommandSpec spec, StringBuilder out) {
        out.append(".SH ").append(name.toUpperCase(java.util.Locale.ROOT)).append('\n');
        for (String line : spec.usageMessage().description()) {
            out.append(escaped(line)).append("\n.br\n");
        }
        for (PositionalParamSpec parameter : spec.positionalParameters()) {
            out.append(".TP\n.I ").append(escaped(parameter.paramLabel())).append('\n');
            out.append(escaped(String.join(" ", parameter.description()))).append('\n');
        }
        for (OptionSpec option : spec.options()) {
            String label = option.arity().max() == 0 ? "" : " " + option.paramLabel();
            out.append(".TP\n.B ")
                    .append(escaped(String.join(", ", option.names()) + label))
                    .append('\n');
            out.append(escaped(String.join(" ", option.description()))).append('\n');
        }
        boolean examples = false;
        for (String line : spec.usageMessage().footer()) {
            if (line.equals("Examples:")) {
                examples = true;
                out.append(".PP\nExamples:\n.nf\n");
            } else if (examples) {
                out.append(escaped(line)).append('\n');
            }
        }
        if (examples) {
            out.append(".fi\n");
        }
    }

    private static String first(CommandSpec spec) {
        return spec.usageMessage().description()[0];
    }

    /** Hyphens are minus signs, backslashes themselves, and no line is a request. */
    private static String escaped(String text) {
        String escaped = text.replace("\\", "\\e").replace("-", "\\-");
        return escaped.startsWith(".") || escaped.startsWith("'") ? "\\&" + escaped : escaped;
    }
}
