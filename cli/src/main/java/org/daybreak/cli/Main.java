package org.daybreak.cli;

import java.io.PrintStream;
import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Supplier;
import org.daybreak.core.render.NearestName;
import org.daybreak.core.render.ParameterException;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/** Entry point of the program. */
public final class Main {
    private Main() {}

    /**
     * Runs the program, reacts to Ctrl-C, and ends the virtual machine with the exit code.
     *
     * @param args command line
     */
    public static void main(String[] args) {
        // No option takes a date, and the classes for them would be loaded on every start.
        System.setProperty("picocli.converters.excludes", "java.time.*,java.sql.*");
        Interrupts interrupts = new Interrupts();
        interrupts.listen();
        int code = run(args, new Session(System.out, System.err, interrupts));
        System.out.flush();
        System.exit(interrupts.exitCode(code));
    }

    /**
     * Runs the program within another one: never ends the virtual machine, does not listen to signals.
     *
     * @param args command line
     * @param out receives results
     * @param err receives messages and progress
     * @return the exit code, see {@code docs/cli.md}
     */
    public static int run(String[] args, PrintStream out, PrintStream err) {
        return run(args, new Session(out, err, new Interrupts()));
    }

    private static int run(String[] args, Session session) {
        try {
            return commandLine(session, args).execute(args);
        } catch (OutOfMemoryError e) {
            return outOfMemory(session);
        } catch (RuntimeException | Error e) {
            return internalError(session, e);
        }
    }

    /** The program with all its commands. */
    static CommandLine commandLine(Session session) {
        return commandLine(session, new String[0]);
    }

    /** All commands, or only the one that is called: picocli looks at each command's annotations by slow reflection. */
    private static CommandLine commandLine(Session session, String[] args) {
        CommandLine daybreak = new CommandLine(new DaybreakCommand());
        Map<String, Supplier<Object>> commands = new LinkedHashMap<>();
        commands.put("render", () -> new RenderCommand(session));
        commands.put("replay", () -> new ReplayCommand(session));
        commands.put("list", () -> new ListCommand(session));
        commands.put("info", () -> new InfoCommand(session));
        commands.put("diff", () -> new DiffCommand(session));
        commands.put("convert", () -> new ConvertCommand(session));
        commands.put("merge", () -> new MergeCommand(session));
        commands.put("completion", () -> new CompletionCommand(session));
        Supplier<Object> called = args.length == 0 ? null : commands.get(args[0]);
        for (Supplier<Object> command : called == null ? commands.values() : List.of(called)) {
            daybreak.addSubcommand(command.get());
        }
        addHelp(daybreak.getCommandSpec());
        daybreak.getSubcommands().values().forEach(command -> addHelp(command.getCommandSpec()));
        CommandSpec spec = daybreak.getCommandSpec();
        spec.versionProvider(new Version());
        spec.addOption(OptionSpec.builder("-V", "--version")
                .versionHelp(true)
                .description("Shows versions and the intersector in use.")
                .build());
        return daybreak.setOut(writer(session.out()))
                .setErr(writer(session.err()))
                .setColorScheme(CommandLine.Help.defaultColorScheme(CommandLine.Help.Ansi.OFF))
                .setParameterExceptionHandler((e, arguments) -> usageError(session, e))
                .setExecutionExceptionHandler((e, command, result) -> failure(session, e));
    }

    private static void addHelp(CommandSpec spec) {
        spec.addOption(OptionSpec.builder("-h", "--help")
                .usageHelp(true)
                .description("Shows this help.")
                .build());
        Map<String, String> codes = new LinkedHashMap<>();
        for (ExitCode code : ExitCode.values()) {
            codes.put(Integer.toString(code.number()), code.meaning());
        }
        spec.usageMessage()
                .sortOptions(false)
                .abbreviateSynopsis(true)
                .exitCodeListHeading("%nExit codes:%n")
                .exitCodeList(codes);
    }

    private static PrintWriter writer(PrintStream stream) {
        return new PrintWriter(stream, true, Charset.defaultCharset());
    }

    private static int usageError(Session session, CommandLine.ParameterException e) {
        CommandLine command = e.getCommandLine();
        String message = String.valueOf(e.getMessage());
        if (e instanceof CommandLine.UnmatchedArgumentException unmatched
                && !unmatched.getUnmatched().isEmpty()) {
            String name = unmatched.getUnmatched().get(0);
            message = name.startsWith("-")
                    ? "unknown option '" + name + "'" + NearestName.hint(name, optionNames(command))
                    : command.getParent() == null
                            ? "there is no command '" + name + "'"
                                    + NearestName.hint(
                                            name, command.getSubcommands().keySet())
                            : "'" + name + "' is one argument too many";
        }
        session.error(message);
        session.error("try '" + command.getCommandSpec().qualifiedName() + " --help'");
        return ExitCode.USAGE.number();
    }

    private static List<String> optionNames(CommandLine command) {
        List<String> names = new ArrayList<>();
        for (OptionSpec option : command.getCommandSpec().options()) {
            names.add(option.longestName());
        }
        return names;
    }

    private static int failure(Session session, Exception e) {
        if (e instanceof CommandException expected) {
            session.error(expected.text());
            return expected.code().number();
        }
        if (e instanceof ParameterException wrong) {
            session.error(String.valueOf(wrong.getMessage()));
            return ExitCode.USAGE.number();
        }
        return internalError(session, e);
    }

    private static int internalError(Session session, Throwable error) {
        // Errors of worker threads arrive wrapped.
        for (Throwable cause = error; cause != null; cause = cause.getCause()) {
            if (cause instanceof OutOfMemoryError) {
                return outOfMemory(session);
            }
        }
        session.error(ExitCode.INTERNAL.meaning() + " with what follows");
        error.printStackTrace(session.err());
        return ExitCode.INTERNAL.number();
    }

    private static int outOfMemory(Session session) {
        long megabytes = Runtime.getRuntime().maxMemory() >> 20;
        session.error("not enough memory: the Java heap may grow to " + megabytes
                + " MiB; allow more with DAYBREAK_OPTS=-Xmx16g, or render with a smaller --size or --crop");
        return ExitCode.MEMORY.number();
    }
}
