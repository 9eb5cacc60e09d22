package org.daybreak.cli;

import java.util.List;
import java.util.concurrent.Callable;
import org.daybreak.core.render.NearestName;
import picocli.AutoComplete;
import picocli.CommandLine.Command;
import picocli.CommandLine.Parameters;

/** {@code daybreak completion}: a script that completes command lines in a shell. */
@Command(
        name = "completion",
        description = "Prints a script with which bash or zsh complete commands and options.",
        footer = {
            "",
            "Examples:",
            "  source <(daybreak completion bash)       in this shell; for all, put it into ~/.bashrc",
            "  source <(daybreak completion zsh)        the same in ~/.zshrc"
        })
final class CompletionCommand implements Callable<Integer> {
    private static final List<String> SHELLS = List.of("bash", "zsh");

    private final Session session;

    @Parameters(paramLabel = "SHELL", description = "bash or zsh.")
    private String shell = "";

    CompletionCommand(Session session) {
        this.session = session;
    }

    @Override
    public Integer call() {
        if (!SHELLS.contains(shell)) {
            throw new CommandException(
                    ExitCode.USAGE, "there is no completion for '" + shell + "'" + NearestName.hint(shell, SHELLS));
        }
        if (shell.equals("zsh")) {
            // The script uses bash's functions, which zsh has in these modules.
            session.out().print("autoload -Uz compinit bashcompinit && compinit && bashcompinit\n");
        }
        session.out().print(AutoComplete.bash("daybreak", Main.commandLine(session)));
        session.out().flush();
        return ExitCode.OK.number();
    }
}
